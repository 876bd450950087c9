// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage/PageArrays.h"

#include "vtk_zlib.h"

#include "vtksys/Base64.h"
#include "vtksys/MD5.h"

#include <algorithm>
#include <array>
#include <new>

namespace tetmarch
{
namespace
{

// Browsers hold strings of half a billion characters. A multiple of 3 bytes, so that only the last
// part ends with padding.
constexpr std::size_t MostBytesOfPart = 96 * 1024 * 1024;

std::string hashOf(const unsigned char* bytes, std::size_t count)
{
  vtksysMD5* md5 = vtksysMD5_New();
  vtksysMD5_Initialize(md5);
  constexpr std::size_t most = 1 << 30; // the length is an int
  for (std::size_t i = 0; i < count; i += most)
  {
    vtksysMD5_Append(md5, bytes + i, static_cast<int>(std::min(most, count - i)));
  }
  std::array<unsigned char, 16> digest;
  vtksysMD5_Finalize(md5, digest.data());
  vtksysMD5_Delete(md5);
  return { digest.begin(), digest.end() };
}

// The first bytes of all texels, then the second ones, ...
std::vector<unsigned char> shuffled(
  const unsigned char* bytes, std::size_t count, std::size_t texel)
{
  std::vector<unsigned char> planes(count);
  const std::size_t texels = count / texel;
  for (std::size_t b = 0; b < texel; ++b)
  {
    for (std::size_t i = 0; i < texels; ++i)
    {
      planes[b * texels + i] = bytes[i * texel + b];
    }
  }
  return planes;
}

// As DecompressionStream("deflate") reads it.
std::vector<unsigned char> deflated(const unsigned char* bytes, std::size_t count)
{
  uLongf size = compressBound(static_cast<uLong>(count));
  std::vector<unsigned char> small(size);
  if (compress2(small.data(), &size, bytes, static_cast<uLong>(count), Z_BEST_COMPRESSION) != Z_OK)
  {
    throw std::bad_alloc();
  }
  small.resize(size);
  return small;
}

std::string base64Of(const unsigned char* bytes, std::size_t count)
{
  std::string text(4 * ((count + 2) / 3) + 4, '\0');
  text.resize(vtksysBase64_Encode(bytes, count, reinterpret_cast<unsigned char*>(text.data()), 0));
  return text;
}

} // namespace

int sizeOfNumber(const std::string& type) { return type == "uint8" ? 1 : type == "uint16" ? 2 : 4; }

int PageArrays::add(const std::string& type, const void* data, std::size_t bytes, int texelBytes)
{
  const auto* given = static_cast<const unsigned char*>(data);
  const Content content{ type, hashOf(given, bytes) };
  if (const auto known = this->Known.find(content); known != this->Known.end())
  {
    return known->second;
  }
  const bool shuffles = texelBytes > 1 && bytes % static_cast<std::size_t>(texelBytes) == 0;
  const std::vector<unsigned char> packed =
    shuffles ? deflated(shuffled(given, bytes, static_cast<std::size_t>(texelBytes)).data(), bytes)
             : deflated(given, bytes);
  Row row;
  row.Type = type;
  row.Count = bytes / static_cast<std::size_t>(sizeOfNumber(type));
  row.Shuffled = shuffles ? texelBytes : 0;
  row.FirstPart = static_cast<int>(this->Texts.size());
  for (std::size_t i = 0; i < packed.size(); i += MostBytesOfPart)
  {
    this->Texts.push_back(
      base64Of(packed.data() + i, std::min(MostBytesOfPart, packed.size() - i)));
    ++row.Parts;
  }
  this->Rows.push_back(row);
  const int index = static_cast<int>(this->Rows.size()) - 1;
  this->Known[content] = index;
  return index;
}

void PageArrays::write(std::ostream& stream) const
{
  for (std::size_t i = 0; i < this->Texts.size(); ++i)
  {
    stream << "<script type=\"application/octet-stream\" id=\"a" << i << "\">" << this->Texts[i]
           << "</script>\n";
  }
}

} // namespace tetmarch
