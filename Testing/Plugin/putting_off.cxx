// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// To be loaded before libexpat (LD_PRELOAD), for tests: makes any version of it put parsing off.
// libexpat waits for as many bytes again as it has tried in vain; this waits for the end.
#include <dlfcn.h>

#include <map>
#include <mutex>
#include <string>

struct XML_ParserStruct;

namespace
{

struct Parsing
{
  bool PutsOff = true;
  std::string Text;
};

std::mutex& mutex()
{
  static std::mutex instance;
  return instance;
}

std::map<XML_ParserStruct*, Parsing>& parsings()
{
  static std::map<XML_ParserStruct*, Parsing> instance;
  return instance;
}

template <class Function>
Function* ofLibexpat(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" unsigned char XML_SetReparseDeferralEnabled(XML_ParserStruct* parser, unsigned char on)
{
  using Function = unsigned char(XML_ParserStruct*, unsigned char);
  if (auto* own = ofLibexpat<Function>("XML_SetReparseDeferralEnabled"))
  {
    own(parser, on);
  }
  const std::lock_guard<std::mutex> lock(mutex());
  parsings()[parser].PutsOff = on != 0;
  return 1;
}

extern "C" int XML_Parse(XML_ParserStruct* parser, const char* text, int length, int isFinal)
{
  std::string all;
  {
    const std::lock_guard<std::mutex> lock(mutex());
    Parsing& parsing = parsings()[parser];
    parsing.Text.append(text, static_cast<std::size_t>(length));
    if (parsing.PutsOff && !isFinal)
    {
      return 1;
    }
    all.swap(parsing.Text);
  }
  auto* parse = ofLibexpat<int(XML_ParserStruct*, const char*, int, int)>("XML_Parse");
  return parse(parser, all.data(), static_cast<int>(all.size()), isFinal);
}

extern "C" void XML_ParserFree(XML_ParserStruct* parser)
{
  {
    const std::lock_guard<std::mutex> lock(mutex());
    parsings().erase(parser);
  }
  ofLibexpat<void(XML_ParserStruct*)>("XML_ParserFree")(parser);
}
