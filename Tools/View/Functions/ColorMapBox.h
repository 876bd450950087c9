// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef tetmarch_ColorMapBox_h
#define tetmarch_ColorMapBox_h

#include <QComboBox>

class vtkColorTransferFunction;

namespace tetmarch
{

/// The colour maps by name, each with a small picture.
class ColorMapBox : public QComboBox
{
  Q_OBJECT

public:
  explicit ColorMapBox(QWidget* parent = nullptr);

  /// Shows the name of the map whose points the function has; nothing if it has others.
  void ShowMapOf(vtkColorTransferFunction* color);

Q_SIGNALS:
  void MapChosen(const QString& name);

protected:
  void paintEvent(QPaintEvent* event) override;
};

} // namespace tetmarch

#endif
