// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"
#include "core/factorization/half_difference_samples.h"

namespace gonio::baselines {

/// Nodes in half-out coordinates (core/coordinates/half_out.h), rad, each strictly increasing from 0.
struct HalfOutAxes {
  std::vector<double> thetaH;
  std::vector<double> phiH;  ///< of |phi_h|, up to pi
  std::vector<double> thetaO;

  std::size_t size() const { return thetaH.size() * phiH.size() * thetaO.size(); }
  /// thetaO runs fastest, thetaH slowest.
  std::size_t index(std::size_t h, std::size_t p, std::size_t o) const {
    return (h * phiH.size() + p) * thetaO.size() + o;
  }
};

/// Axes with theta_h dense at the highlight, as in MERL tables, and the other angles uniform; polar angles up to
/// maxPolarAngle (core/factorization/deviation_grid.h).
HalfOutAxes makeHalfOutAxes(int thetaHCount, int phiHCount, int thetaOCount);

/// BRDF values at all nodes: the mean of the values at phi_h and -phi_h.
using HalfOutSamples = factorization::NodeSamples<HalfOutAxes>;

/// About 0.1 s for 200,000 nodes. @throws Cancelled.
HalfOutSamples sampleHalfOut(const TabulatedBrdf& table, const HalfOutAxes& axes, const TaskControl& control = {});

/// Weight of a node's squared error in light transport: the measure of its cell in projected solid angles of light and
/// viewer, up to a constant; 0 if invalid.
double projectedMeasure(const HalfOutSamples& samples, std::size_t h, std::size_t p, std::size_t o);

/// A density over a sorted axis with given values at its nodes, linear between them, and its exact inverse. Not
/// normalised. O(log nodes).
class LinearDensity {
 public:
  /// @param nodes strictly increasing; @param values at the nodes, >= 0.
  LinearDensity(const std::vector<double>& nodes, std::vector<double> values);

  double integral() const { return cumulative_.back(); }
  /// The point below which the fraction u in [0, 1) of the integral lies. @param nodes those of the constructor.
  double sample(const std::vector<double>& nodes, double u) const;
  /// 0 beyond the nodes.
  double at(const std::vector<double>& nodes, double x) const;

 private:
  std::vector<double> values_, cumulative_;
};

/// Samples the direction of light for a viewer by its half vector, from a sum of products
///   p(h | wo) = sum_l s_l(theta_o) u_l(theta_h) v_l(|phi_h|) / Z(theta_o),   p_w = p(h | wo) / (4 wo . h):
/// first selects a product in proportion to its integral over the half vectors, then samples theta_h and phi_h from its
/// curves. Lawrence, Rusinkiewicz and Ramamoorthi 2004, "Efficient BRDF Importance Sampling Using a Factored
/// Representation", section 4. Samples with a reflected direction below the horizon fail (density 0).
///
/// Differences from the paper: curves are linear in cos theta_h and in phi_h between their nodes, so that the density
/// is exactly that of the samples. A tenth of the samples is cosine-weighted, as for PDV factors, so that the density
/// is also positive beyond the last node of theta_h; where all products are 0, all samples are cosine-weighted. A
/// viewer along the normal has no azimuth, so phi_h is uniform. Immutable.
class HalfVectorSampler {
 public:
  struct Product {
    std::vector<double> polar, azimuth;  ///< u and v at the nodes, >= 0
    std::vector<double> viewer;          ///< s at the nodes of theta_o, >= 0
  };
  HalfVectorSampler(const HalfOutAxes& axes, const std::vector<Product>& products);

  /// As Brdf::sample() and Brdf::pdf(). O(products).
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  double pdf(const Direction& wi, const Direction& wo) const;

 private:
  struct Curves {
    LinearDensity polar, azimuth;
    std::vector<double> viewer;
  };
  double strength(const Curves& curves, double thetaO) const;
  double total(double thetaO) const;

  std::vector<double> versines_;  ///< 1 - cos theta_h of the nodes
  std::vector<double> phiH_, thetaO_;
  std::vector<Curves> curves_;
};

/// Samples the direction of light for a viewer by its half vector, from a density g over the nodes of half-out
/// coordinates: theta_h by its marginal distribution for theta_o, then |phi_h| by its conditional distribution,
///   p(h | wo) = g(theta_h, |phi_h|, theta_o) / (2 Z(theta_o)),   p_w = p(h | wo) / (4 wo . h).
/// The method of Bilgili, Öztürk and Kurt 2011, "A General BRDF Representation Based on Tensor Decomposition", for
/// isotropic materials. Samples with a reflected direction below the horizon fail (density 0).
///
/// Differences from the paper: g is bilinear in (cos theta_h, phi_h) between the nodes, and one of the two nodes around
/// theta_o is chosen at random with the weights of linear interpolation, so that the density is exactly that of the
/// samples. A tenth of the samples is cosine-weighted, as for PDV factors; where g is 0, all samples are
/// cosine-weighted. For a viewer along the normal, half vectors are uniform in phi_h. Immutable. 32 bytes per node.
class TensorHalfVectorSampler {
 public:
  /// @param density g per solid angle of the half vector, >= 0, in the order of axes.index().
  TensorHalfVectorSampler(const HalfOutAxes& axes, const std::vector<double>& density);

  /// As Brdf::sample() and Brdf::pdf(). O(log nodes).
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  double pdf(const Direction& wi, const Direction& wo) const;

 private:
  /// The density of one viewer: the marginal over theta_h, and over phi_h for each node of theta_h.
  struct Slice {
    LinearDensity polar;
    std::vector<LinearDensity> azimuths;
  };
  /// The nodes about an angle of the viewer that have a density, with the probabilities of their choice.
  struct Choice {
    std::size_t count = 0;
    std::size_t slices[2] = {0, 0};
    double weights[2] = {0, 0};
  };
  Choice choiceOf(double thetaO) const;
  double density(const Slice& slice, double versine, double phi, bool vertical) const;

  std::vector<double> versines_;  ///< 1 - cos theta_h of the nodes
  std::vector<double> phiH_, thetaO_;
  std::vector<Slice> slices_;  ///< one per node of theta_o
};

}  // namespace gonio::baselines
