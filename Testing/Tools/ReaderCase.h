// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A folder for the files of one test of the readers
 */
#ifndef tetmarch_testing_ReaderCase_h
#define tetmarch_testing_ReaderCase_h

#include "DatasetReader.h"
#include "Failure.h"
#include "Messages.h"

#include "vtkNew.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

class ReaderCase : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { tetmarch::Messages::Install(); } // which counts VTK's errors
  void SetUp() override
  {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = std::filesystem::temp_directory_path() /
                   ("tetmarch-" + std::string(test->test_suite_name()) + "-" + test->name());
    std::filesystem::create_directories(this->Folder);
  }
  void TearDown() override { std::filesystem::remove_all(this->Folder); }

  std::string GetPath(const std::string& name) const { return (this->Folder / name).string(); }

  template <typename Writer>
  std::string Write(const char* name, vtkDataObject* data) const
  {
    vtkNew<Writer> writer;
    writer->SetFileName(this->GetPath(name).c_str());
    writer->SetInputDataObject(data);
    writer->Write();
    EXPECT_TRUE(std::filesystem::exists(this->GetPath(name)));
    return this->GetPath(name);
  }

  std::string WriteText(const std::string& name, const std::string& text) const
  {
    std::ofstream(this->GetPath(name), std::ios::binary) << text;
    return this->GetPath(name);
  }

  /// Why the file can't be drawn, or "accepted".
  static std::string GetError(const std::string& path, std::optional<int> timeStep = std::nullopt,
    const tetmarch::RawOptions& rawOptions = {})
  {
    try
    {
      tetmarch::ReadVolume(path, timeStep, rawOptions);
    }
    catch (const tetmarch::Failure& failure)
    {
      return failure.what();
    }
    return "accepted";
  }

  std::filesystem::path Folder;
};

#endif
