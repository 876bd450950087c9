// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A clipping plane and a cropping box; both can be taken hold of in the picture.
 */
#ifndef tetmarch_CutsPanel_h
#define tetmarch_CutsPanel_h

#include <QWidget>

class QCheckBox;

namespace tetmarch
{
class Model;

class CutsPanel : public QWidget
{
  Q_OBJECT

public:
  explicit CutsPanel(Model& model, QWidget* parent = nullptr);

  /// Whether plane and box are seen in the picture.
  bool AreHandlesWanted() const;

Q_SIGNALS:
  void HandlesChanged();

private:
  Model& Shown;
  QCheckBox* Handles;
};

} // namespace tetmarch

#endif
