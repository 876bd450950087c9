// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// To be loaded before libexpat (LD_PRELOAD): its parsers put nothing off. Plugin/README.md says
// why.
#include <dlfcn.h>

struct XML_ParserStruct;

namespace
{

// libexpat's own function; null if that version has none.
template <class Function>
Function* ofLibexpat(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" XML_ParserStruct* XML_ParserCreate(const char* encoding)
{
  auto* create = ofLibexpat<XML_ParserStruct*(const char*)>("XML_ParserCreate");
  XML_ParserStruct* parser = create ? create(encoding) : nullptr;
  auto* putOff =
    ofLibexpat<unsigned char(XML_ParserStruct*, unsigned char)>("XML_SetReparseDeferralEnabled");
  if (parser && putOff)
  {
    putOff(parser, 0);
  }
  return parser;
}
