// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the Vulkan driver's compiler makes of fragment shaders, as JSON: a line about the driver,
// then one for each shader.
#include "Compilation.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>

namespace
{
using namespace tetmarch::gpu;
using nlohmann::json;

json resultOf(const Device& device, const SpirvWords& vertex, const std::string& file)
{
  try
  {
    const Compilation compilation = compile(device, vertex, readSpirv(file));
    return { { "file", file }, { "subgroup_size", compilation.SubgroupSize },
      { "statistics", compilation.Statistics } };
  }
  catch (const std::exception& error)
  {
    return { { "file", file }, { "error", error.what() } };
  }
}
} // namespace

int main(int argc, char** argv)
try
{
  if (argc < 2)
  {
    std::cerr << "usage: tetmarch-gpu-statistics VERTEX.spv [FRAGMENT.spv]...\n";
    return 2;
  }
  const SpirvWords vertex = readSpirv(argv[1]);
  const Device device;
  std::cout << json{ { "device", device.Name }, { "driver", device.Driver } } << std::endl;
  int status = EXIT_SUCCESS;
  for (int i = 2; i < argc; ++i)
  {
    const json result = resultOf(device, vertex, argv[i]);
    status = result.contains("error") ? EXIT_FAILURE : status;
    std::cout << result << std::endl;
  }
  return status;
}
catch (const std::exception& error)
{
  std::cerr << "tetmarch-gpu-statistics: " << error.what() << '\n';
  return EXIT_FAILURE;
}
