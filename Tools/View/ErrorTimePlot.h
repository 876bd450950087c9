// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Error bound over the time of a frame, a point for each setting that was tried; both by powers of
 * ten.
 */
#ifndef tetmarch_ErrorTimePlot_h
#define tetmarch_ErrorTimePlot_h

#include <QWidget>

#include <vector>

namespace tetmarch
{

class ErrorTimePlot : public QWidget
{
  Q_OBJECT

public:
  explicit ErrorTimePlot(QWidget* parent = nullptr);

  struct Point
  {
    double Seconds;
    double Error;
    QString Setting; // a new point of the same setting replaces the old one
  };
  void Add(const Point& point);
  void Clear();
  const std::vector<Point>& GetPoints() const { return this->Points; }

  QSize sizeHint() const override { return { 260, 190 }; }
  QSize minimumSizeHint() const override { return { 180, 170 }; }

protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

private:
  QRectF GetFrame() const;
  QPointF Place(const Point& point) const;

  std::vector<Point> Points;
  QString Last;
};

} // namespace tetmarch

#endif
