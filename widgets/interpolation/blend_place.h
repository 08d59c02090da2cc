// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPointF>
#include <vector>

namespace gonio::widgets {

/// Where the hand is between two to four materials, and what each of them weighs there. A place is
///   of two materials    (t, 0): t = 0 is the first, 1 the second
///   of three            (u, v), u + v <= 1: the fractions of the second and the third
///   of four             (u, v): from the first to the second, from the first to the third; (1, 1) is the fourth
/// with u, v in [0, 1].
inline constexpr int minBlended = 2, maxBlended = 4;

/// One weight a material, in [0, 1], with the sum 1; at a corner exactly 1 and 0. Three: barycentric; four: bilinear.
std::vector<double> weightsAt(int materials, const QPointF& place);
/// Where a material is alone.
QPointF cornerPlace(int corner);
/// Where no material is nearer than another.
QPointF middlePlace(int materials);
/// The nearest place that there is, as the pad is drawn.
QPointF nearestPlace(int materials, const QPointF& place);

/// The way from the first material that a strip of pictures follows: to the second of two, to the middle of the second
/// and the third, to the fourth. @param t in [0, 1].
QPointF wayPlace(int materials, double t);

/// Corners of the pad in a unit square, y down: an equilateral triangle with the first material on top, or the square.
/// Two materials lie on a line.
std::vector<QPointF> drawnCorners(int materials);
/// A place in that unit square, and back (which may lie outside of the pad).
QPointF drawnAt(int materials, const QPointF& place);
QPointF placeDrawnAt(int materials, const QPointF& drawn);

}  // namespace gonio::widgets
