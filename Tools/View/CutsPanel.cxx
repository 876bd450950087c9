// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CutsPanel.h"

#include "Model.h"
#include "PanelParts.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace tetmarch
{

CutsPanel::CutsPanel(Model& model, QWidget* parent)
  : QWidget(parent)
  , Shown(model)
  , Handles(new QCheckBox(tr("Show their handles in the picture")))
{
  auto* layout = new QVBoxLayout(this);
  auto* clip =
    MakeCheck(model, tr("Clipping plane"), [](ViewState& s) -> bool& { return s.Cuts.Clip; });
  clip->setObjectName(QStringLiteral("clip"));
  layout->addWidget(clip);
  auto* row = new QHBoxLayout;
  layout->addLayout(row);
  for (int axis = 0; axis < 3; ++axis)
  {
    auto* button = new QPushButton(tr("Across %1").arg(QChar('x' + axis)));
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this,
      [this, axis]
      {
        this->Shown.Edit(
          [axis](ViewState& s)
          {
            s.Cuts.Clip = true;
            s.Cuts.Normal = { { 0.0, 0.0, 0.0 } };
            s.Cuts.Normal[axis] = 1.0;
          });
      });
  }
  auto* flip = new QPushButton(tr("Other side"));
  row->addWidget(flip);
  connect(flip, &QPushButton::clicked, this,
    [this]
    {
      this->Shown.Edit(
        [](ViewState& s)
        {
          for (double& part : s.Cuts.Normal)
          {
            part = part == 0.0 ? 0.0 : -part;
          }
        });
    });

  auto* crop =
    MakeCheck(model, tr("Cropping box"), [](ViewState& s) -> bool& { return s.Cuts.Crop; });
  crop->setObjectName(QStringLiteral("crop"));
  layout->addWidget(crop);
  auto* whole = new QPushButton(tr("Box around all of the data"));
  layout->addWidget(whole);
  connect(whole, &QPushButton::clicked, this,
    [this]
    {
      if (this->Shown.HasData())
      {
        this->Shown.Edit([this](ViewState& s) { s.Cuts.Box = this->Shown.GetScene().GetBounds(); });
      }
    });
  this->Handles->setChecked(true);
  layout->addWidget(this->Handles);
  connect(this->Handles, &QCheckBox::toggled, this, &CutsPanel::HandlesChanged);
  auto* help = new QLabel(tr("Drag the plane's arrow to turn it and its edges to move it; drag the "
                             "balls on the box's faces."));
  help->setWordWrap(true);
  layout->addWidget(help);
  layout->addStretch(1);
}

bool CutsPanel::AreHandlesWanted() const { return this->Handles->isChecked(); }

} // namespace tetmarch
