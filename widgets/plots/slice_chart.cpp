// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/slice_chart.h"

#include "core/rendering/error_maps.h"

namespace gonio::widgets {

QCPColorGradient viridisGradient() {
  constexpr int stops = 32;
  QCPColorGradient gradient;
  gradient.clearColorStops();
  for (int i = 0; i <= stops; ++i) {
    const DisplayColour colour = viridis(double(i) / stops);
    gradient.setColorStopAt(double(i) / stops, QColor(colour[0], colour[1], colour[2]));
  }
  gradient.setNanHandling(QCPColorGradient::nhTransparent);
  return gradient;
}

QCPColorGradient plainGradient(const QColor& colour) {
  QCPColorGradient gradient;
  gradient.setColorStops({{0, colour}, {1, colour}});
  gradient.setNanHandling(QCPColorGradient::nhTransparent);
  return gradient;
}

QSharedPointer<QCPAxisTicker> thetaHTicker(plots::ThetaHSpacing spacing) {
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  const QList<int> marks = spacing == plots::ThetaHSpacing::linear ? QList<int>{0, 15, 30, 45, 60, 75, 90}
                                                                   : QList<int>{0, 1, 5, 10, 20, 30, 45, 60, 90};
  for (const int mark : marks) ticker->addTick(plots::thetaHFraction(spacing, radians(mark)), QString::number(mark));
  return ticker;
}

QSharedPointer<QCPAxisTicker> thetaDTicker() {
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (int mark = 0; mark <= 90; mark += 15) ticker->addTick(mark, QString::number(mark));
  return ticker;
}

}  // namespace gonio::widgets
