// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorTimePlot.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace
{
struct Decades
{
  int First;
  int Last;
};

/// At least two decades around the values.
template <typename Points, typename Value>
Decades GetDecades(const Points& points, Value value, Decades empty)
{
  if (points.empty())
  {
    return empty;
  }
  double least = value(points[0]);
  double most = least;
  for (const auto& point : points)
  {
    least = std::min(least, value(point));
    most = std::max(most, value(point));
  }
  Decades decades{ static_cast<int>(std::floor(std::log10(least))),
    static_cast<int>(std::ceil(std::log10(most))) };
  decades.Last = std::max(decades.Last, decades.First + 2);
  return decades;
}

Decades GetTimes(const std::vector<tetmarch::ErrorTimePlot::Point>& points)
{
  return GetDecades(points, [](const auto& point) { return point.Seconds; }, { -2, 1 });
}

/// No error of a channel is above 1.
Decades GetErrors(const std::vector<tetmarch::ErrorTimePlot::Point>& points)
{
  const Decades decades =
    GetDecades(points, [](const auto& point) { return point.Error; }, { -5, -1 });
  return { std::min(decades.First, -2), std::min(decades.Last, 0) };
}

QString GetPower(int exponent)
{
  return exponent >= -2 && exponent <= 2 ? QString::number(std::pow(10.0, exponent))
                                         : QStringLiteral("1e%1").arg(exponent);
}
} // namespace

namespace tetmarch
{

ErrorTimePlot::ErrorTimePlot(QWidget* parent)
  : QWidget(parent)
{
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  this->setMaximumHeight(260);
}

void ErrorTimePlot::Add(const Point& point)
{
  if (!(point.Seconds > 0.0) || !(point.Error > 0.0) || !std::isfinite(point.Error))
  {
    return;
  }
  const auto same = std::find_if(this->Points.begin(), this->Points.end(),
    [&](const Point& old) { return old.Setting == point.Setting; });
  if (same != this->Points.end())
  {
    *same = point;
  }
  else
  {
    this->Points.push_back(point);
  }
  this->Last = point.Setting;
  this->update();
}

void ErrorTimePlot::Clear()
{
  this->Points.clear();
  this->update();
}

QRectF ErrorTimePlot::GetFrame() const
{
  const QFontMetrics metrics(this->font());
  const double left = metrics.horizontalAdvance(QStringLiteral("1e-5")) + 10.0;
  return { left, metrics.height() + 6.0, this->width() - left - 10.0,
    this->height() - 2.6 * metrics.height() - 12.0 };
}

QPointF ErrorTimePlot::Place(const Point& point) const
{
  const QRectF frame = this->GetFrame();
  const Decades times = GetTimes(this->Points);
  const Decades errors = GetErrors(this->Points);
  const double x = (std::log10(point.Seconds) - times.First) / (times.Last - times.First);
  const double y = (std::log10(point.Error) - errors.First) / (errors.Last - errors.First);
  return { frame.left() + x * frame.width(), frame.bottom() - y * frame.height() };
}

void ErrorTimePlot::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = this->GetFrame();
  const QFontMetrics metrics(this->font());
  QColor lines = this->palette().color(QPalette::WindowText);
  const QColor text = lines;
  lines.setAlphaF(0.15);
  painter.fillRect(frame, this->palette().color(QPalette::Base));

  const Decades times = GetTimes(this->Points);
  const Decades errors = GetErrors(this->Points);
  for (int decade = times.First; decade <= times.Last; ++decade)
  {
    const double x =
      frame.left() + frame.width() * (decade - times.First) / (times.Last - times.First);
    painter.setPen(lines);
    painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
    painter.setPen(text);
    painter.drawText(QRectF(x - 40.0, frame.bottom() + 2.0, 80.0, metrics.height()),
      Qt::AlignHCenter | Qt::AlignTop, GetPower(decade));
  }
  const int stride = std::max(1, (errors.Last - errors.First) / 5);
  for (int decade = errors.First; decade <= errors.Last; decade += stride)
  {
    const double y =
      frame.bottom() - frame.height() * (decade - errors.First) / (errors.Last - errors.First);
    painter.setPen(lines);
    painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y));
    painter.setPen(text);
    painter.drawText(QRectF(0.0, y - 0.5 * metrics.height(), frame.left() - 5.0, metrics.height()),
      Qt::AlignRight | Qt::AlignVCenter, GetPower(decade));
  }
  painter.drawText(QPointF(2.0, metrics.ascent() + 1.0), tr("largest error bound"));
  painter.drawText(
    QRectF(frame.left(), this->height() - metrics.height() - 2.0, frame.width(), metrics.height()),
    Qt::AlignHCenter, tr("seconds a frame"));

  const QColor accent = this->palette().color(QPalette::Highlight);
  for (const Point& point : this->Points)
  {
    const bool last = point.Setting == this->Last;
    painter.setPen(last ? QPen(text, 1.5) : QPen(Qt::NoPen));
    QColor fill = accent;
    fill.setAlphaF(last ? 1.0 : 0.55);
    painter.setBrush(fill);
    painter.drawEllipse(this->Place(point), last ? 5.0 : 4.0, last ? 5.0 : 4.0);
  }
}

bool ErrorTimePlot::event(QEvent* event)
{
  if (event->type() == QEvent::ToolTip)
  {
    const auto* help = static_cast<QHelpEvent*>(event);
    for (const Point& point : this->Points)
    {
      if ((this->Place(point) - help->pos()).manhattanLength() < 10.0)
      {
        QToolTip::showText(help->globalPos(), tr("%1: %2 s, error at most %3")
                                                .arg(point.Setting)
                                                .arg(point.Seconds, 0, 'g', 3)
                                                .arg(point.Error, 0, 'g', 2));
        return true;
      }
    }
    QToolTip::hideText();
    return true;
  }
  return QWidget::event(event);
}

} // namespace tetmarch
