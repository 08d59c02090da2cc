// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/brdf/data_transform.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/support/task_control.h"

namespace gonio::factorization {

/// The forms of the separable model over projected-deviation coordinates.
enum class PdvForm {
  twoFactors,   ///< F1(theta_R) F2(|Dp|): round highlights (Tongbuasirilai et al. 2017, Paper B)
  threeFactors  ///< F1(theta_R) F2(|Dp|) F3(phi) (Tongbuasirilai et al. 2019, Paper C; dissertation eq. 4.25)
};

/// One separable term of one colour channel: values at the nodes. `f3` has one entry in the form with two factors.
struct PdvTerm {
  std::vector<double> f1, f2, f3;
  bool operator==(const PdvTerm&) const = default;
};

/// A reflectance as sums of products of curves, in a transformed domain:
///   y(theta_R, |Dp|, |phi|) = sum_l F1_l(theta_R) F2_l(|Dp|) F3_l(|phi|),  rho = the inverse transform of max(0, y).
/// F2 and F3 of a term have a largest value of 1 in size; F1 carries its strength. The first term is not negative.
/// Symmetric about the plane of incidence; not reciprocal: theta_R is the angle of the viewer. A value.
struct PdvFactors {
  PdvForm form = PdvForm::threeFactors;
  DataTransform transform = DataTransform::logPlus;
  std::vector<double> thetaNodes;                ///< of theta_R, rad, strictly increasing from 0
  std::vector<double> deviationNodes;            ///< of |Dp|, strictly increasing from 0
  std::vector<double> phiNodes;                  ///< of |phi|, rad, from 0 to pi; one node in the form with two factors
  std::array<std::vector<PdvTerm>, 3> channels;  ///< red, green, blue: as many terms in each
  /// The largest y of the measurement: sums of products can shoot over it, by a factor of e^y in reflectance.
  double highest = 0;

  int terms() const { return int(channels[0].size()); }
  /// The model with only its first terms.
  PdvFactors truncated(int terms) const;
  bool operator==(const PdvFactors&) const = default;
};

/// How much the squared error of y counts in a cell.
enum class PdvWeights {
  uniform,  ///< all cells the same: Tongbuasirilai et al. 2019. Crowded nodes at grazing angles decide
  /// cos theta_i cos theta_o times both projected solid angles times (d rho / d y)^(1/2), and 2e-5 of the mean of that
  /// in all cells. The squared error of rho cos theta_i cos theta_o, to first order, has the power 2, by which
  /// highlights drown the rest; the power 0 lets highlights shoot over (docs/factors.md has the trials).
  projectedSolidAngle
};

struct PdvOptions {
  PdvForm form = PdvForm::threeFactors;
  DataTransform transform = DataTransform::logPlus;
  int terms = 10;  ///< [1, 20]
  PdvWeights weights = PdvWeights::projectedSolidAngle;
  /// Nodes of |Dp|; empty: deviationNodes() of the material.
  std::vector<double> deviationNodes = {};
};
inline constexpr int maxPdvTerms = 20;

struct PdvFactorization {
  PdvFactors factors;
  /// |y - y^| / |y| in the weighted norm over all channels, for 0, 1, .. terms: never rises; the first is 1, or 0 for a
  /// black material.
  std::vector<double> residuals;
  std::size_t cells = 0;  ///< on the disk that were measured
  double seconds = 0;
  std::vector<double> termSeconds = {};  ///< from the start to where 0, 1, .. terms are known: what so many cost alone
};

/// Factorises a table: term after term the best rank-one tensor of what the terms before left, over the cells that
/// count. Deterministic. About 1 s for ten terms of three factors in RGB on two cores.
/// @throws Cancelled; Error when the count of terms or the nodes are out of range.
PdvFactorization factorizePdv(const TabulatedBrdf& table, const PdvOptions& options = {},
                              const TaskControl& control = {});

/// The reflectance that factors stand for, straight from the curves (monotone cubics between the nodes), no table.
/// Importance sampling is that of its first term (core/factorization/pdv_sampler.h), tabulated when it is first used.
std::shared_ptr<const Brdf> makePdvBrdf(const PdvFactors& factors);
/// The factors of such a BRDF; null for all others.
std::shared_ptr<const PdvFactors> pdvFactorsOf(const Brdf& brdf);

}  // namespace gonio::factorization
