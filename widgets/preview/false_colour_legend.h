// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "widgets/preview/gl/preview_comparison.h"

namespace gonio::widgets {

/// A bar of the colours of a kind of difference, from the first to the last.
void drawColourBar(QPainter& painter, const QRect& bar, DifferenceKind kind);

/// What the colours of a difference mean: a bar of the map with its numbers, the quantity and its unit.
class FalseColourLegend : public QWidget {
  Q_OBJECT

 public:
  explicit FalseColourLegend(QWidget* parent = nullptr);

  /// @param range the difference that has the last colour.
  void setDifference(DifferenceKind kind, double range);
  double range() const { return m_range; }

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  DifferenceKind m_kind = DifferenceKind::absolute;
  double m_range = 1;
};

}  // namespace gonio::widgets
