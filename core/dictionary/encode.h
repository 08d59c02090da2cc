// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/dictionary/dictionary.h"
#include "core/dictionary/signals.h"
#include "core/support/task_control.h"

namespace gonio::dictionary {

/// How the coefficients of a code are chosen.
enum class CodingMethod {
  /// The largest projections, which over an orthonormal dictionary are the least-squares fit, chosen again after each
  /// update of the invalid cells (Blumensath and Davies 2009, "Iterative Hard Thresholding for Compressed Sensing").
  iterativeHardThresholding,
  basisPursuit  ///< by the smallest sum of absolute values (core/dictionary/alternatives/basis_pursuit.h), then least
                ///< squares
};

/// Names in JSON, in Python and on the command line, in the order of CodingMethod.
inline constexpr std::array<std::string_view, 2> codingMethodNames{"iterative-hard-thresholding", "basis-pursuit"};

struct EncodeOptions {
  std::size_t coefficients = 1024;  ///< maximum per channel; a quantised file with that many has 2.0 to 2.8 kB
  /// If set, uses only as many coefficients as needed for a squared error of the signal (with cell scaling if `scaled`)
  /// of at most this fraction of its energy.
  std::optional<double> relativeError;
  /// If set, maximum size of the packed code, quantised (truncatedToBytes()).
  std::optional<std::size_t> bytes;
  std::vector<DataTransform> transforms{DataTransform::logPlus, DataTransform::cosineLog};
  double gamma = 2;          ///< g of the gamma error (exponent 1/g) that selects the transform, [1, 3]
  int refinements = 15;      ///< rounds that update the invalid cells, see encode()
  int trialRefinements = 3;  ///< rounds before the transform is selected; the others refine the selected one
  CodingMethod method = CodingMethod::iterativeHardThresholding;
  /// Whether signals have cell scaling (GridGeometry::cellScaling). Over an ensemble that was trained without it they
  /// never have it.
  bool scaled = true;
  bool sharedDictionary = true;  ///< whether one dictionary serves all channels where that costs little, see encode()
  bool bounded = true;      ///< whether decoded values are limited by the range of the table (ChannelCode::highest)
  bool solidAngles = true;  ///< whether the gamma error weights the cells by projected solid angles; else equally
  bool quantised =
      false;  ///< whether values are rounded as in a quantised file (quantised()), before errors are measured
};

/// The options of the published method (Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling
/// and Acquisition", eq. 4.37 to 4.39 and section 4.3.2.4): one projection of the unscaled transformed values, in which
/// invalid cells repeat the last valid value along theta_h (signalsOf()), without refinement, over the best dictionary
/// of each channel; no bounds; and an unweighted gamma error. The published number of coefficients, 262 per channel,
/// was chosen there for a comparison at the size of the factors of Bagher et al. 2016 (here 2.7 kB for the code in half
/// precision, 3.3 kB for the factors in single precision).
EncodeOptions publishedEncodeOptions(std::size_t coefficients = 262);

/// The largest sparsity of dictionaries that are learned from reciprocal materials by default. Those for more
/// coefficients are learned from both orders of the directions (resources/ATTRIBUTIONS.md).
inline constexpr int commonSparsity = 256;

/// The code of one transform.
struct EncodedCandidate {
  SparseCode code;
  /// Mean over the valid cells to 85 degrees, weighted by the projected solid angles of both directions, of
  /// (rho^(1/gamma) - rho'^(1/gamma))^2, rho in 1/sr (Tongbuasirilai 2023, section 4.3.2.4, there without weights, as
  /// with EncodeOptions::solidAngles false).
  double gammaError = 0;
  /// Mean of (rho - rho')^2, 1/sr^2, over the same cells with the same weights; for information only.
  double squaredError = 0;
};

/// A sentence for each channel in which the code loses the brightest cell: it decodes to less than a tenth.
std::vector<std::string> lostPeaks(const TabulatedBrdf& table, const TabulatedBrdf& decoded);

struct EncodeResult {
  SparseCode code;                           ///< of the candidate with the smallest gamma error; the first among equals
  std::vector<EncodedCandidate> candidates;  ///< in the order of the transforms
  double seconds = 0;
};

/// The table on the grid that the codes of an ensemble have: the ensemble's, or its whole circle if the table has both
/// orders of the directions. @throws Cancelled.
std::shared_ptr<const TabulatedBrdf> onCodeGrid(const std::shared_ptr<const TabulatedBrdf>& table,
                                                const Ensemble& ensemble, const TaskControl& control = {});

/// Encodes materials as sparse codes over an ensemble. Immutable.
class Encoder {
 public:
  /// @param ensemble must outlive this object.
  explicit Encoder(const Ensemble& ensemble);

  /// For each transform, chooses the dictionary with the most energy in its largest coefficients: with
  /// EncodeOptions::sharedDictionary one for all channels, which makes the file smaller, unless separate dictionaries
  /// have at least a quarter less squared error. Takes these coefficients (the exact minimiser, because the
  /// dictionaries are orthonormal). Then refinement rounds replace the values of invalid cells, which are free, by
  /// those that the code gives them, so that the coefficients represent the valid cells. This is iterative hard
  /// thresholding on the valid cells, with the momentum of Beck and Teboulle 2009, "A Fast Iterative
  /// Shrinkage-Thresholding Algorithm for Linear Inverse Problems". With CodingMethod::basisPursuit the rounds apply
  /// soft thresholding, and as many rounds of least squares follow. The transform with the smallest gamma error after a
  /// few rounds is selected, and its rounds are repeated in double precision, so that codes do not depend on the
  /// instruction set; if all rounds have a larger error than the few, the few are used. A table of both orders of the
  /// directions (onCodeGrid()) is encoded over inBothOrders() of the ensemble, with the largest coefficients of both
  /// parts. If the code of a reciprocal table has a dictionary for more coefficients than commonSparsity, the table is
  /// encoded again without these, and the code with the smaller gamma error is the result: the energy, which chooses
  /// the dictionary, includes the invalid cells. @throws Error if the table has another grid; Cancelled.
  EncodeResult encode(const TabulatedBrdf& table, const EncodeOptions& options = {},
                      const TaskControl& control = {}) const;
  const Ensemble& ensemble() const { return ensemble_; }

 private:
  /// Of each channel, as in ChannelCode.
  using ChannelCoefficients = std::array<std::vector<Coefficient<float>>, 3>;
  struct Trial;
  /// The first rounds of a transform. @param maxSparsity of the dictionaries among which it chooses.
  Trial tried(DataTransform transform, const TabulatedBrdf& table, const EncodeOptions& options, int maxSparsity,
              const TaskControl& control) const;
  EncodeResult encodeOver(int maxSparsity, const TabulatedBrdf& table, const EncodeOptions& options,
                          const TaskControl& control) const;
  EncodedCandidate refined(const Trial& trial, const TabulatedBrdf& table, const EncodeOptions& options,
                           const TaskControl& control) const;
  EncodedCandidate candidate(const Trial& trial, const ChannelCoefficients& coefficients, const TabulatedBrdf& table,
                             const EncodeOptions& options) const;
  bool isScaled(const EncodeOptions& options) const { return options.scaled && ensemble_.scaled; }
  /// The squared error of a signal over each dictionary.
  std::vector<double> dictionaryErrors(const Eigen::ArrayXf& signal, std::size_t coefficients) const;
  /// For each channel, with at most this sparsity.
  std::array<int, 3> chooseDictionaries(const std::array<Eigen::ArrayXf, 3>& signals, const EncodeOptions& options,
                                        int maxSparsity, const TaskControl& control) const;

  const Ensemble& ensemble_;
  std::vector<std::array<Eigen::MatrixXf, 3>> matrices_;  ///< of the dictionaries
};

}  // namespace gonio::dictionary
