// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The fields of an NRRD header, as text.
#ifndef TetMarchImageFilesNrrdFields_h
#define TetMarchImageFilesNrrdFields_h

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tetmarch
{

struct NrrdFields
{
  std::map<std::string, std::string> Texts; // by the name in lower case without blanks
  std::vector<std::string> ListedFiles;
  bool IsList = false;
  bool EndsByBlankLine = false;
  std::uint64_t End = 0; // the header's end in the file

  /** nullptr if there is no such field. */
  const std::string* find(const std::string& name) const;
  /** Throws ImageFileError if there is no such field. */
  const std::string& get(const std::string& name) const;
};

/** Throws ImageFileError. */
NrrdFields readNrrdFields(const std::string& path);

} // namespace tetmarch

#endif
