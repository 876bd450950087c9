// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plain text in aligned columns.
 */
#ifndef tetmarch_TextTable_h
#define tetmarch_TextTable_h

#include <string>
#include <vector>

namespace tetmarch
{

/**
 * One line a row, columns two spaces apart. The first row has the titles, and the others have as
 * many texts. Columns are aligned to the right, but for the last one.
 */
std::string FormatTable(const std::vector<std::vector<std::string>>& rows);

/// With the given number of significant digits, but "0" for 0 and "-" for NaN.
std::string FormatNumber(double number, int digits);

/// With the given number of decimals.
std::string FormatFixed(double number, int digits);

} // namespace tetmarch

#endif
