// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "widgets/preview/gl/preview_comparison.h"

namespace gonio::widgets {

/// Draws the colour map of a kind of difference as a bar.
void drawColourBar(QPainter& painter, const QRect& bar, DifferenceKind kind);

/// Legend of a difference picture: the colour map with numbers, the quantity and its unit.
class FalseColourLegend : public QWidget {
  Q_OBJECT

 public:
  explicit FalseColourLegend(QWidget* parent = nullptr);

  /// @param range the difference shown in the last colour of the map.
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
