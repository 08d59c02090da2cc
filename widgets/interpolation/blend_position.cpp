// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/blend_position.h"

#include <algorithm>
#include <cmath>

namespace gonio::widgets {

namespace {

constexpr int triangle = 3;
constexpr double side = 1, top = 0.067, bottom = 0.933;  // an equilateral triangle in the middle of the square

double clampedFraction(double x) { return std::clamp(x, 0.0, 1.0); }
double dot(const QPointF& a, const QPointF& b) { return QPointF::dotProduct(a, b); }

/// The fraction of the way from a to b that is nearest to p.
double nearestFraction(const QPointF& p, const QPointF& a, const QPointF& b) {
  return clampedFraction(dot(p - a, b - a) / dot(b - a, b - a));
}

}  // namespace

std::vector<double> weightsAt(int materials, const QPointF& place) {
  const double u = place.x(), v = place.y();
  if (materials == minBlended) return {1 - u, u};
  if (materials == triangle) return {std::max(0.0, 1 - u - v), u, v};
  return {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
}

QPointF cornerPosition(int corner) { return {corner % 2 ? 1.0 : 0.0, corner >= 2 ? 1.0 : 0.0}; }

QPointF centrePosition(int materials) {
  if (materials == minBlended) return {0.5, 0};
  return materials == triangle ? QPointF(1 / 3.0, 1 / 3.0) : QPointF(0.5, 0.5);
}

QPointF nearestPosition(int materials, const QPointF& place) {
  const double u = place.x(), v = place.y();
  if (materials == minBlended) return {clampedFraction(u), 0};
  if (materials != triangle) return {clampedFraction(u), clampedFraction(v)};
  if (u >= 0 && v >= 0 && u + v <= 1) return place;
  // On the edges, in the metric of the drawing; in fractions of an edge the corners come out exactly.
  const QPointF p = drawnAt(materials, place);
  const std::vector<QPointF> corners = drawnCorners(materials);
  QPointF best;
  double bestDistance = HUGE_VAL;
  for (int from = 0; from < triangle; ++from) {
    const int to = (from + 1) % triangle;
    const double fraction = nearestFraction(p, corners[std::size_t(from)], corners[std::size_t(to)]);
    const QPointF candidate = (1 - fraction) * cornerPosition(from) + fraction * cornerPosition(to);
    const QPointF away = drawnAt(materials, candidate) - p;
    if (dot(away, away) >= bestDistance) continue;
    bestDistance = dot(away, away);
    best = candidate;
  }
  return best;
}

QPointF pathPosition(int materials, double t) {
  if (materials == minBlended) return {t, 0};
  return materials == triangle ? QPointF(t / 2, t / 2) : QPointF(t, t);
}

std::vector<QPointF> drawnCorners(int materials) {
  if (materials == minBlended) return {{0, 0.5}, {1, 0.5}};
  if (materials == triangle) return {{side / 2, top}, {0, bottom}, {side, bottom}};
  return {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
}

QPointF drawnAt(int materials, const QPointF& place) {
  const std::vector<QPointF> corners = drawnCorners(materials);
  QPointF drawn = corners[0] + place.x() * (corners[1] - corners[0]);
  if (materials > minBlended) drawn += place.y() * (corners[2] - corners[0]);
  return drawn;
}

QPointF positionDrawnAt(int materials, const QPointF& drawn) {
  const std::vector<QPointF> corners = drawnCorners(materials);
  const QPointF p = drawn - corners[0], a = corners[1] - corners[0];
  if (materials == minBlended) return {dot(p, a) / dot(a, a), 0};
  const QPointF b = corners[2] - corners[0];
  const double determinant = a.x() * b.y() - a.y() * b.x();
  return {(p.x() * b.y() - p.y() * b.x()) / determinant, (a.x() * p.y() - a.y() * p.x()) / determinant};
}

}  // namespace gonio::widgets
