// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/charts/plot_style.h"

namespace gonio::widgets {

namespace {

QColor blended(const QColor& a, const QColor& b, double fraction) {
  const auto mix = [fraction](int x, int y) { return int(x + (y - x) * fraction); };
  return QColor(mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue()));
}

struct OtherFitStyle {
  QColor onLight, onDark;
  QList<qreal> dashes;
};

/// At least 4.5:1 on the backgrounds, as the other roles.
const OtherFitStyle& otherFitStyle(SeriesRole role) {
  static const OtherFitStyle styles[] = {{QColor(0x00, 0x72, 0x4e), QColor(0x50, 0xd0, 0xa0), {2, 2}},
                                         {QColor(0x99, 0x36, 0x77), QColor(0xee, 0x9a, 0xcc), {10, 3}},
                                         {QColor(0x6b, 0x5c, 0x00), QColor(0xd8, 0xc8, 0x50), {6, 2, 2, 2, 2, 2}},
                                         {QColor(0x5a, 0x41, 0xb4), QColor(0xb6, 0xa2, 0xff), {1, 2.5}},
                                         {QColor(0xa4, 0x26, 0x3a), QColor(0xff, 0x8c, 0x9a), {12, 2, 3, 2}},
                                         {QColor(0x00, 0x6b, 0x7a), QColor(0x54, 0xd0, 0xe0), {4, 4}}};
  return styles[std::size_t(int(role) - int(SeriesRole::otherFit)) % std::size(styles)];
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
      return text;
    case SeriesRole::otherFit:
      break;
  }
  return dark ? otherFitStyle(role).onDark : otherFitStyle(role).onLight;
}

QPen PlotStyle::channelPen(int channel) const {
  const QColor onDark[] = {QColor(0xff, 0x7a, 0x6e), QColor(0x5f, 0xd0, 0x78), QColor(0x7d, 0xb0, 0xff)};
  const QColor onLight[] = {QColor(0xb8, 0x1f, 0x1f), QColor(0x13, 0x70, 0x2c), QColor(0x1f, 0x4f, 0xc0)};
  QPen pen((dark ? onDark : onLight)[channel], 1.8, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  if (channel == 1) pen.setDashPattern({7, 2.5});
  if (channel == 2) pen.setDashPattern({2, 2});
  return pen;
}

QPen PlotStyle::pen(SeriesRole role) const {
  QPen pen(colour(role), 1.8, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  if (role == SeriesRole::fit) pen.setDashPattern({5, 2.5});
  if (role == SeriesRole::edited) pen.setDashPattern({8, 2.5, 1.5, 2.5});
  if (role >= SeriesRole::otherFit) pen.setDashPattern(otherFitStyle(role).dashes);
  return pen;
}

}  // namespace gonio::widgets
