// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a page: compressed, each content once, as text in elements of their own.
#ifndef TetMarchWebPagePageArrays_h
#define TetMarchWebPagePageArrays_h

#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tetmarch
{

class PageArrays
{
public:
  struct Row
  {
    std::string Type; // "uint8", "uint16", "uint32", "float32"
    std::size_t Count = 0;
    int Shuffled = 0;  // number of interleaved bytes that were put apart; 0: none
    int Parts = 0;     // elements
    int FirstPart = 0; // the element "a<FirstPart>"
  };

  /**
   * Add an array and return its index, that of an equal array if there is one. texelBytes: numbers
   * that belong together; their bytes are put apart, so that they compress better. Throws
   * std::bad_alloc.
   */
  int add(const std::string& type, const void* data, std::size_t bytes, int texelBytes);

  const std::vector<Row>& rows() const { return this->Rows; }
  /** The elements, as markup. */
  void write(std::ostream& stream) const;

private:
  using Content = std::pair<std::string, std::string>; // type, hash
  std::map<Content, int> Known;
  std::vector<Row> Rows;
  std::vector<std::string> Texts; // base64
};

/** The size in bytes of a number of that type. */
int sizeOfNumber(const std::string& type);

} // namespace tetmarch

#endif
