// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpirvInterface.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <stdexcept>

namespace tetmarch::gpu
{
namespace
{
// Of the specification of SPIR-V.
constexpr std::uint32_t Magic = 0x07230203;
constexpr std::size_t HeaderWords = 5;
enum Operation : std::uint32_t
{
  OpTypeImage = 25,
  OpTypeSampledImage = 27,
  OpTypeArray = 28,
  OpTypeStruct = 30,
  OpTypePointer = 32,
  OpConstant = 43,
  OpFunctionCall = 57,
  OpVariable = 59,
  OpLoad = 61,
  OpAccessChain = 65,
  OpInBoundsAccessChain = 66,
  OpDecorate = 71
};
enum Storage : std::uint32_t
{
  StorageUniformConstant = 0,
  StorageUniform = 2,
  StorageOutput = 3
};
constexpr std::uint32_t DecorationLocation = 30, DecorationBinding = 33;
constexpr std::uint32_t DimensionBuffer = 5;

using Instruction = std::vector<std::uint32_t>; // without the word of its length and operation
using Numbers = std::map<std::uint32_t, std::uint32_t>;

class Reader
{
public:
  explicit Reader(const SpirvWords& module)
  {
    for (std::size_t at = HeaderWords; at < module.size();)
    {
      const std::size_t length = module[at] >> 16;
      if (length == 0 || at + length > module.size())
      {
        throw std::runtime_error("a SPIR-V module ends within an instruction");
      }
      this->take(
        module[at] & 0xffff, Instruction(module.data() + at + 1, module.data() + at + length));
      at += length;
    }
  }

  SpirvInterface interface() const
  {
    SpirvInterface found;
    for (const Variable& variable : this->Variables)
    {
      if (variable.In == StorageOutput && this->Locations.count(variable.Id) > 0)
      {
        found.Outputs = std::max(found.Outputs, this->Locations.at(variable.Id) + 1);
      }
      // A uniform that is not used may have the number of another one.
      if (variable.In != StorageOutput && this->Used.count(variable.Id) > 0)
      {
        const auto type = this->Types.find(this->Pointees.at(variable.Pointer));
        if (type == this->Types.end() || this->Bindings.count(variable.Id) == 0 ||
            !found.Bindings.emplace(this->Bindings.at(variable.Id), type->second).second)
        {
          throw std::runtime_error("a uniform has no type or binding that this program knows");
        }
      }
    }
    return found;
  }

private:
  struct Variable
  {
    std::uint32_t Id, Pointer;
    Storage In;
  };

  void take(std::uint32_t operation, const Instruction& words)
  {
    switch (operation)
    {
      case OpDecorate:
        if (words[1] == DecorationLocation)
        {
          this->Locations[words[0]] = words[2];
        }
        else if (words[1] == DecorationBinding)
        {
          this->Bindings[words[0]] = words[2];
        }
        break;
      case OpTypeImage:
        this->Types[words[0]] = { words[2] == DimensionBuffer
                                    ? VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER
                                    : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
          1 };
        break;
      case OpTypeSampledImage:
        this->Types[words[0]] = this->Types.at(words[1]);
        break;
      case OpTypeArray:
        if (this->Types.count(words[1]) > 0)
        {
          this->Types[words[0]] = { this->Types.at(words[1]).Type, this->Constants.at(words[2]) };
        }
        break;
      case OpTypeStruct:
        this->Types[words[0]] = { VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1 };
        break;
      case OpTypePointer:
        this->Pointees[words[0]] = words[2];
        break;
      case OpConstant:
        this->Constants[words[1]] = words[2];
        break;
      case OpVariable:
        if (words[2] == StorageUniformConstant || words[2] == StorageUniform ||
            words[2] == StorageOutput)
        {
          this->Variables.push_back({ words[1], words[0], static_cast<Storage>(words[2]) });
        }
        break;
      case OpLoad:
      case OpAccessChain:
      case OpInBoundsAccessChain:
        this->Used.insert(words[2]);
        break;
      case OpFunctionCall:
        this->Used.insert(words.begin() + 3, words.end());
        break;
    }
  }

  Numbers Locations, Bindings, Pointees, Constants; // by the number of what has it
  std::map<std::uint32_t, SpirvBinding> Types;
  std::vector<Variable> Variables;
  std::set<std::uint32_t> Used;
};
} // namespace

SpirvWords readSpirv(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream)
  {
    throw std::runtime_error(file + " can't be read");
  }
  SpirvWords words(static_cast<std::size_t>(stream.tellg()) / sizeof(std::uint32_t));
  stream.seekg(0);
  stream.read(reinterpret_cast<char*>(words.data()),
    static_cast<std::streamsize>(words.size() * sizeof(std::uint32_t)));
  if (!stream || words.size() < HeaderWords || words[0] != Magic)
  {
    throw std::runtime_error(file + " is no SPIR-V");
  }
  return words;
}

SpirvInterface interfaceOf(const SpirvWords& module) { return Reader(module).interface(); }
} // namespace tetmarch::gpu
