// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Variants/ShaderStage.h"

#include <gtest/gtest.h>

namespace
{
using tetmarch::hasFewFragmentUnits;
using tetmarch::marchesByCompute;
using tetmarch::ShaderStage;

TEST(ShaderStage, GpusForDataCentresAreKnownByTheirNames)
{
  for (const char* renderer : { "NVIDIA H100 80GB HBM3/PCIe/SSE2", "NVIDIA H200/PCIe/SSE2",
         "NVIDIA H100 PCIe", "NVIDIA GH200 480GB", "NVIDIA B200" })
  {
    EXPECT_TRUE(hasFewFragmentUnits(renderer)) << renderer;
  }
  for (const char* renderer : { "", "llvmpipe (LLVM 15.0.6, 256 bits)",
         "NVIDIA GeForce RTX 4090/PCIe/SSE2", "NVIDIA A100-SXM4-80GB/PCIe/SSE2", "Quadro P2000",
         "AMD Radeon RX 6800 (radeonsi, navi21, LLVM 15.0.6)", "Intel(R) UHD Graphics 630" })
  {
    EXPECT_FALSE(hasFewFragmentUnits(renderer)) << renderer;
  }
}

TEST(ShaderStage, IsWhatIsAskedForOrWhatIsFaster)
{
  EXPECT_FALSE(marchesByCompute(ShaderStage::Automatic, { true, false }));
  EXPECT_TRUE(marchesByCompute(ShaderStage::Automatic, { true, true }));
  EXPECT_FALSE(marchesByCompute(ShaderStage::Fragment, { true, true }));
  EXPECT_TRUE(marchesByCompute(ShaderStage::Compute, { true, false }));
}
} // namespace
