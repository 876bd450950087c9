// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a picture is saved and copied as draws it again, to the last bit.
 */
#ifndef tetmarch_SavedCase_h
#define tetmarch_SavedCase_h

#include "ViewCase.h"

#include <QMetaType>

class QProcess;

namespace tetmarch
{

/// Of a view.
using Change = void (*)(ViewState&);

// Those that several scenes have.
void AddLight(ViewState& s);
void AddCuts(ViewState& s);
void ShowCells(ViewState& s);

class SavedCase : public ViewCase
{
  Q_OBJECT

protected:
  /// That of the open window: by tetmarch-render, by Python, and by a session in a new window.
  void CheckPicture();

private:
  /// The picture that is shown, in which there is something.
  void TakePicture();
  void StartCommand(QProcess& process);
  void StartScript(QProcess& process);
  void CheckProgram(QProcess& process, const char* picture);
  void CheckSession();
  void CheckSame(const QString& path);

  Pixels Shown;
};

} // namespace tetmarch

Q_DECLARE_METATYPE(tetmarch::Change)

#endif
