// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPointF>
#include <vector>

namespace gonio::widgets {

/// Positions between two to four materials and their weights. A position is
///   for two materials (t, 0): t = 0 is the first, 1 the second
///   for three (u, v), u + v <= 1: the weights of the second and the third
///   for four (u, v): u runs from the first to the second, v from the first to the third; (1, 1) is the fourth
/// with u, v in [0, 1].
inline constexpr int minBlended = 2, maxBlended = 4;

/// One weight per material, in [0, 1], with sum 1; exactly 1 and 0 at a corner. Barycentric for three materials,
/// bilinear for four.
std::vector<double> weightsAt(int materials, const QPointF& position);
/// The position where a material has the weight 1.
QPointF cornerPosition(int corner);
/// The position with equal weights.
QPointF centrePosition(int materials);
/// The nearest valid position, in the geometry of the pad.
QPointF nearestPosition(int materials, const QPointF& position);

/// The position at t on the path that the strip of images shows. It starts at the first material and ends at the second
/// of two, midway between the second and the third of three, or at the fourth of four. @param t in [0, 1].
QPointF pathPosition(int materials, double t);

/// Corners of the pad in a unit square, y down: an equilateral triangle with the first material on top, or the square.
/// Two materials lie on a line.
std::vector<QPointF> drawnCorners(int materials);
/// Conversion of a position to the unit square, and back (the result may be outside the pad).
QPointF drawnAt(int materials, const QPointF& position);
QPointF positionDrawnAt(int materials, const QPointF& drawn);

}  // namespace gonio::widgets
