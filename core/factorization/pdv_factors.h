// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "core/brdf/data_transform.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/support/task_control.h"

namespace gonio::factorization {

/// The forms of the separable model over projected-deviation coordinates (Tongbuasirilai 2023, "Data-Driven Approaches
/// for Sparse Reflectance Modeling and Acquisition").
enum class PdvForm {
  twoFactors,   ///< F1(theta_R) F2(|Dp|): rotationally symmetric highlights (Tongbuasirilai et al. 2017)
  threeFactors  ///< F1(theta_R) F2(|Dp|) F3(phi) (Tongbuasirilai et al. 2019; Tongbuasirilai 2023, eq. 4.25)
};

/// One separable term of one colour channel: values at the nodes. `f3` has one entry in the two-factor form.
struct PdvTerm {
  std::vector<double> f1, f2, f3;
  bool operator==(const PdvTerm&) const = default;
};

/// A BRDF as sums of products of curves, in a transformed domain:
///   y(theta_R, |Dp|, |phi|) = sum_l F1_l(theta_R) F2_l(|Dp|) F3_l(|phi|), rho = the inverse transform of y,
/// limited to [lowest, highest]; for y < 0 the transform is continued as an odd function.
/// The largest absolute value of F2, and that of F3, is 1 in each term; F1 contains the scale. The first term is not
/// negative. Symmetric about the plane of incidence; not reciprocal, because theta_R is the viewer's angle.
struct PdvFactors {
  PdvForm form = PdvForm::threeFactors;
  DataTransform transform = DataTransform::logPlus;
  std::vector<double> thetaNodes;                ///< of theta_R, rad, strictly increasing from 0
  std::vector<double> deviationNodes;            ///< of |Dp|, strictly increasing from 0
  std::vector<double> phiNodes;                  ///< of |phi|, rad, from 0 to pi; one node in the two-factor form
  std::array<std::vector<PdvTerm>, 3> channels;  ///< red, green, blue, with the same number of terms
  /// Upper bound of y: the largest y of the measurement. Sums of products can overshoot it, which an inverse logarithm
  /// would amplify.
  double highest = 0;
  /// Lower bound of y, <= 0: the smallest y of the measurement; 0 where no value is negative.
  double lowest = 0;

  int terms() const { return int(channels[0].size()); }
  /// The model of the first `terms` terms.
  PdvFactors truncated(int terms) const;
  bool operator==(const PdvFactors&) const = default;
};

/// Weight of the squared error of y in a cell.
enum class PdvWeights {
  equal,  ///< 1 for all cells (Tongbuasirilai et al. 2019); dense nodes at grazing angles dominate
  /// cos theta_i cos theta_o times the projected solid angles of light and viewer times (d rho / d y)^(1/2), plus 2e-5
  /// of the mean weight in all cells. With power 2 instead of 1/2 it would be the squared error of rho cos theta_i cos
  /// theta_o to first order, where highlights dominate; with power 0 highlights overshoot (docs/results/factors.md
  /// compares them).
  projectedSolidAngle
};

/// Names in JSON and on the command line, in the order of PdvWeights.
inline constexpr std::array<std::string_view, 2> pdvWeightNames{"equal", "projected-solid-angle"};

/// Numbers of nodes of theta_R and |phi| of the published method, which are the default.
inline constexpr int pdvThetaNodes = 90, pdvPhiNodes = 180;
inline constexpr int maxPdvNodes = 4096;

struct PdvOptions {
  PdvForm form = PdvForm::threeFactors;
  DataTransform transform = DataTransform::logPlus;
  int terms = 10;  ///< [1, 20]
  PdvWeights weights = PdvWeights::projectedSolidAngle;
  /// Nodes of |Dp|; empty: deviationNodes() of the material.
  std::vector<double> deviationNodes = {};
  /// Numbers of nodes of theta_R and |phi|, [2, maxPdvNodes], at equal distances. The two-factor form has no |phi|.
  int thetaNodes = pdvThetaNodes, phiNodes = pdvPhiNodes;
  /// Improves all terms together after they were found one by one (core/factorization/joint_terms.h). The squared error
  /// is never larger; the first terms of the result alone are then not the best model with that number of terms.
  bool joint = false;
};
inline constexpr int maxPdvTerms = 20;
/// Maximum number of terms of makePdvBrdf(): those of a blend of 16 materials (BlendForm::continuous).
inline constexpr int maxEvaluatedTerms = 1 + 16 * (maxPdvTerms - 1);

/// The options of the published method (Tongbuasirilai et al. 2017 and 2019; Tongbuasirilai 2023, eq. 4.24 to 4.26):
/// ln(1 + rho), equal weights of all cells, and libraryDeviationNodes() for all materials.
PdvOptions publishedPdvOptions(PdvForm form, int terms);
/// The same options with 60 nodes of theta_R and 30 of |phi|, which halves the bytes of a term. These curves are
/// smooth: twice as many terms in the same bytes are more accurate (docs/results/factors.md).
PdvOptions compactPdvOptions(PdvOptions options);

struct PdvFactorization {
  PdvFactors factors;
  /// |y - y^| / |y| in the weighted norm over all channels, for 0, 1, ... terms; never increases. The first is 1, or 0
  /// for a black material. With PdvOptions::joint the last is that of the joint terms, the others those of the terms
  /// found one by one.
  std::vector<double> residuals;
  std::size_t cells = 0;  ///< number of cells on the disk with data
  double seconds = 0;
  std::vector<double> termSeconds = {};  ///< time until 0, 1, ... terms were computed
};

/// Factorises a table: each term is the best rank-one approximation of the residual of the terms before, over the cells
/// with data; with PdvOptions::joint these are the start of a joint fit of all terms. Deterministic. About 1 s for ten
/// terms of three factors in RGB on two cores, a few seconds more for a joint fit. @throws Cancelled; Error if
/// the number of terms or the nodes are out of range.
PdvFactorization factorizePdv(const TabulatedBrdf& table, const PdvOptions& options = {},
                              const TaskControl& control = {});

/// The BRDF of factors, evaluated from the curves (monotone cubic between the nodes). Importance sampling follows the
/// first term (core/factorization/pdv_brdf.h), which is tabulated at the first sample. @throws Error for more than
/// maxEvaluatedTerms terms.
std::shared_ptr<const Brdf> makePdvBrdf(const PdvFactors& factors);
/// The factors of a BRDF from makePdvBrdf(); null for others.
std::shared_ptr<const PdvFactors> pdvFactorsOf(const Brdf& brdf);

}  // namespace gonio::factorization
