// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/charts/plot_style.h"

namespace gonio::widgets {

namespace {

QColor blended(const QColor& a, const QColor& b, double share) {
  const auto mix = [share](int x, int y) { return int(x + (y - x) * share); };
  return QColor(mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue()));
}

}  // namespace

PlotStyle PlotStyle::of(const QPalette& palette) {
  const QColor base = palette.color(QPalette::Base), text = palette.color(QPalette::Text);
  return {base, text, blended(base, text, 0.18), palette.color(QPalette::Highlight), base.lightness() < 128};
}

PlotStyle PlotStyle::paper() { return {Qt::white, Qt::black, QColor(0xd8, 0xd8, 0xd8), QColor(0x2a, 0x6c, 0xab)}; }

QColor PlotStyle::colour(SeriesRole role) const {
  // Blue and orange stay apart for all common kinds of colour blindness; at least 4.5:1 on the backgrounds.
  switch (role) {
    case SeriesRole::fit:
      return dark ? QColor(0x62, 0xb5, 0xf0) : QColor(0x00, 0x62, 0xad);
    case SeriesRole::edited:
      return dark ? QColor(0xff, 0xa0, 0x50) : QColor(0xb0, 0x45, 0x00);
    case SeriesRole::measured:
      break;
  }
  return text;
}

QPen PlotStyle::pen(SeriesRole role) const {
  QPen pen(colour(role), 1.8, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  if (role == SeriesRole::fit) pen.setDashPattern({5, 2.5});
  if (role == SeriesRole::edited) pen.setDashPattern({8, 2.5, 1.5, 2.5});
  return pen;
}

}  // namespace gonio::widgets
