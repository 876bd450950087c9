// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What main() runs: the first argument names it. Each suite of tests adds itself.
 */
#ifndef tetmarch_Programs_h
#define tetmarch_Programs_h

#include <QStringList>
#include <QtTest>

#include <functional>
#include <map>

namespace tetmarch
{

/// Gets the words of the command without the name by which it was chosen. Returns the exit status.
using Program = std::function<int(const QStringList& arguments)>;

inline std::map<QString, Program>& GetPrograms()
{
  static std::map<QString, Program> programs;
  return programs;
}

inline bool AddProgram(const char* name, const Program& program)
{
  return GetPrograms().emplace(QString::fromLatin1(name), program).second;
}

template <class Suite>
int RunSuite(const QStringList& arguments)
{
  Suite suite;
  return QTest::qExec(&suite, arguments);
}

} // namespace tetmarch

/// For the file of a suite, once.
#define TETMARCH_ADD_SUITE(Suite)                                                                  \
  [[maybe_unused]] static const bool Suite##IsAdded =                                              \
    tetmarch::AddProgram(#Suite, tetmarch::RunSuite<Suite>)

#endif
