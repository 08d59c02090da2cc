// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <vector>

#include "core/brdf/value_bound.h"
#include "core/math/types.h"

namespace gonio::editing {

/// The factor s(theta) of an edited highlight H', per channel: s(theta_i) s(theta_o) H' has the directional albedo of
/// the highlight before the edit, and is reciprocal if H' is. Linear between nodes that are evenly spaced in (x + x^2)
/// / 2, x = sqrt(1 - cos theta): 5 degrees apart at normal incidence, 2 degrees at 80 degrees.
struct AlbedoScale {
  static constexpr std::size_t nodes = 32;

  std::array<Rgb, nodes> values = [] {
    std::array<Rgb, nodes> ones;
    ones.fill(Rgb(1));
    return ones;
  }();

  Rgb operator()(double cosine) const;
  /// Contains the factors of all cosines of a range.
  RgbRange over(const Range& cosines) const;
  /// Of a node, from 1 down to nearly 0.
  static double cosineOf(std::size_t node);
};

/// The directional albedo of the edited highlight at a node, as a matrix row: how much of it goes to outgoing
/// directions near each of the nodes.
struct AlbedoNode {
  std::array<Rgb, AlbedoScale::nodes> edited{};
  Rgb before{0};  ///< albedo of the highlight before the edit

  /// Splits a contribution H' cos theta_o d omega_o between the two nearest nodes.
  void add(double cosine, const Rgb& contribution);
};

/// Pairs of one polar angle of wi and weights cos theta_o d omega_o, with which a sum over a BRDF's values is its
/// directional albedo: a product rule over the half vector, uniform in log tan theta_h, in which highlights of all
/// widths are smooth, and in its azimuth. The rings of each azimuth are shifted, so that together they are denser.
struct AlbedoQuadrature {
  std::vector<DirectionPair> pairs;  ///< both directions above the horizon
  std::vector<double> weights;

  /// About 400 pairs. @param cosine of theta_i, in (0, 1]. @param narrowest alpha of the narrowest highlight. @param
  /// isIsotropic otherwise four azimuths of wi, for the mean over them. @param isMirrorSymmetric
  /// (Brdf::isMirrorSymmetric()) of an isotropic BRDF half of the pairs suffice.
  AlbedoQuadrature(double cosine, double narrowest, bool isIsotropic, bool isMirrorSymmetric);

 private:
  void add(const Direction& wi, double narrowest, int azimuths, double part);
};

/// Finds s with s_i sum_k edited_ik s_k = before_i for each node i by Sinkhorn's iteration for symmetric matrices
/// (Knight, Ruiz and Ucar 2014, "A Symmetry Preserving Algorithm for Matrix Scaling"). A node and channel of which one
/// of the albedos is not positive keeps s = 1. s is in [1/64, 64].
AlbedoScale albedoScale(const std::array<AlbedoNode, AlbedoScale::nodes>& nodes);

}  // namespace gonio::editing
