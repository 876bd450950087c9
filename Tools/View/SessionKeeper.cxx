// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SessionKeeper.h"

#include "MainWindow.h"
#include "Messages.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QStandardPaths>
#include <QToolBar>

namespace tetmarch
{

SessionKeeper::SessionKeeper(MainWindow& window, const QString& folder)
  : Window(window)
  , Kept(folder)
  , Abandoned(FindAbandonedSession(folder))
{
  Model& model = window.GetModel();
  connect(&model, &Model::LoadingChanged, this,
    [this](bool busy)
    {
      if (busy)
      {
        this->Keep();
      }
    });
  connect(&model, &Model::DataChanged, this, [this] { this->IsNew = true; });
  connect(&model, &Model::Rendered, this,
    [this]
    {
      if (this->IsNew)
      {
        this->TakeShown();
      }
    });
  if (this->Abandoned)
  {
    this->MakeOffer();
  }
}

QString SessionKeeper::GetFolder()
{
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
         QStringLiteral("/sessions");
}

void SessionKeeper::Keep()
{
  Model& model = this->Window.GetModel();
  if (model.HasData() && !this->Kept.Keep(model.GetState()) && !this->Warned)
  {
    this->Warned = true;
    PrintMessage(
      "warning", "cannot write '" + this->Kept.GetPath().toStdString() +
                   "', so the session is lost if the program crashes while it reads a file");
  }
}

void SessionKeeper::MakeOffer()
{
  this->Offer = new QToolBar(tr("Kept session"));
  this->Offer->setObjectName(QStringLiteral("offer"));
  const QString file =
    QFileInfo(QString::fromStdString(this->Abandoned->State.Data.File)).fileName();
  auto* text =
    new QLabel(tr("  tetmarch-view ended unexpectedly. The session with %1 was kept, %2.  ")
                 .arg(file, QLocale().toString(this->Abandoned->Time, QLocale::ShortFormat)));
  text->setTextFormat(Qt::PlainText);
  this->Offer->addWidget(text);
  QAction* restore = this->Offer->addAction(tr("Restore"), this, &SessionKeeper::Restore);
  restore->setObjectName(QStringLiteral("restore"));
  QAction* discard = this->Offer->addAction(tr("Discard"), this, &SessionKeeper::EndOffer);
  discard->setObjectName(QStringLiteral("discard"));
  this->Window.addToolBar(Qt::TopToolBarArea, this->Offer);
}

void SessionKeeper::Restore()
{
  this->Offer->hide();
  this->Restoring = true;
  this->Window.GetModel().OpenState(this->Abandoned->State);
}

// Only now, since the program may have crashed on these data.
void SessionKeeper::TakeShown()
{
  this->IsNew = false;
  this->Keep();
  const std::string shown = this->Window.GetModel().GetState().Data.File;
  if (this->Restoring && this->Abandoned && shown == this->Abandoned->State.Data.File)
  {
    this->EndOffer();
  }
}

void SessionKeeper::EndOffer()
{
  this->Offer->hide();
  QFile::remove(this->Abandoned->Path);
  this->Abandoned.reset();
}

} // namespace tetmarch
