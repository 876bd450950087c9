// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Programs.h"
#include "PythonScript.h"
#include "SavedCase.h"
#include "ViewStateJson.h"

#include <QFile>
#include <QtTest>

namespace tetmarch
{

/// Sessions as texts.
class SessionTest : public ViewCase
{
  Q_OBJECT

private Q_SLOTS:
  void AStateComesBackFromItsText();
  void BadSessionsAreRefused();
};
TETMARCH_ADD_SUITE(SessionTest);

void SessionTest::AStateComesBackFromItsText()
{
  ViewState state;
  const std::string first = WriteState(state);
  state.Data.File = "a folder/it's \"é\".vtu";
  state.Data.TimeStep = 7;
  state.Data.Component = -1;
  state.Functions.Color = { { { 0.1, 1.0 / 3.0, 0.0, 1.0, 0.5, 0.25 } } };
  state.Functions.ColorSpace = 3;
  state.Functions.Opacity = { { { -1e-300, 0.0, 0.5, 0.0 } }, { { 1e300, 1.0, 0.1, 0.9 } } };
  state.Camera.Position = { { 0.1, 0.2, 1.0 / 7.0 } };
  state.IsoValues = { 1.0, 1.0 / 3.0 };
  state.BlendMode = 5;
  AddLight(state);
  AddCuts(state);
  ShowCells(state);
  const std::string text = WriteState(state);
  QVERIFY(text != first);
  state.Data.Array = "caf\xe9"; // a name of a file that knows no UTF-8
  QCOMPARE(ReadState(WriteState(state)).Data.Array, std::string("caf\xef\xbf\xbd"));
  QVERIFY(WriteScript(state, false).find("caf\xef\xbf\xbd") != std::string::npos);
  const ViewState read = ReadState(text);
  QCOMPARE(WriteState(read), text);
  QCOMPARE(read.Camera.Position[2], 1.0 / 7.0);
  QCOMPARE(read.Functions.Opacity[0][0], -1e-300);
  QCOMPARE(read.Settings.ShadowMethod, state.Settings.ShadowMethod);
}

void SessionTest::BadSessionsAreRefused()
{
  this->OpenPicture(GetData("bonsai_small.vti"));
  const Pixels before = this->Draw();
  const QString path = this->Folder.filePath(QStringLiteral("bad.json"));
  const QByteArray kind = "{\"kind\": \"tetmarch-view session\", ";
  const std::pair<QByteArray, const char*> texts[] = { { "{", "not JSON" },
    { "[1, 2]", "lacks \"kind\"" }, { kind + "\"camera\": 3}", "camera must be an object" },
    { kind + "\"accuracy\": {\"tolerance\": \"x\"}}", "tolerance is \"x\"" },
    { kind + "\"picture\": {\"blend\": \"mixed\"}}", "blend is \"mixed\"" },
    { kind + "\"camera\": {\"position\": [1, 2]}}", "position is [1,2]" } };
  for (const auto& [text, why] : texts)
  {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
    file.close();
    this->Window->Open(path);
    const QString message = this->TakeMessage();
    QVERIFY2(message.contains(path) && message.contains(QLatin1String(why)), qPrintable(message));
  }
  QCOMPARE(Compare(before, this->Draw()).Bytes, std::size_t(0));
}

} // namespace tetmarch

#include "SessionTest.moc"
