// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPointF>
#include <vector>

namespace gonio::widgets {

/// Positions between two to four materials and their weights. A place is
///   for two materials (t, 0): t = 0 is the first, 1 the second
///   for three (u, v), u + v <= 1: the weights of the second and the third
///   for four (u, v): from the first to the second, from the first to the third; (1, 1) is the fourth
/// with u, v in [0, 1].
inline constexpr int minBlended = 2, maxBlended = 4;

/// One weight per material, in [0, 1], with sum 1; exactly 1 and 0 at a corner. Barycentric for three materials,
/// bilinear for four.
std::vector<double> weightsAt(int materials, const QPointF& place);
/// The place where a material has the weight 1.
QPointF cornerPlace(int corner);
/// The place with equal weights.
QPointF middlePlace(int materials);
/// The nearest valid place, in the geometry of the pad.
QPointF nearestPlace(int materials, const QPointF& place);

/// The path of a strip of pictures from the first material: to the second of two, to the middle of the second and
/// third, or to the fourth. @param t in [0, 1].
QPointF wayPlace(int materials, double t);

/// Corners of the pad in a unit square, y down: an equilateral triangle with the first material on top, or the square.
/// Two materials lie on a line.
std::vector<QPointF> drawnCorners(int materials);
/// Conversion of a place to the unit square, and back (the result may be outside the pad).
QPointF drawnAt(int materials, const QPointF& place);
QPointF placeDrawnAt(int materials, const QPointF& drawn);

}  // namespace gonio::widgets
