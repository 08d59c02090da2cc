// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/dictionary/signals.h"
#include "core/dictionary/sparse_code.h"
#include "core/support/task_control.h"

namespace gonio::dictionary {

struct EncodeOptions {
  std::size_t coefficients = 262;  ///< per channel, at most (dissertation 4.3.2.4: 262, the size of Bagher et al. 2016)
  /// Fewer coefficients where the squared error of the signal, scaled by GridGeometry::importance, is then at most this
  /// fraction of its energy.
  std::optional<double> relativeError;
  /// Fewer coefficients where the packed code would have more bytes than this.
  std::optional<std::size_t> bytes;
  std::vector<DataTransform> transforms{DataTransform::logPlus, DataTransform::cosineLog};
  double gamma = 2;          ///< of the error by which the transform is chosen, in [1, 3]
  int refinements = 15;      ///< rounds in which the invalid cells take the code's own values
  int trialRefinements = 3;  ///< those of them that each transform gets; the others are for the chosen one
};

/// One transform that was tried.
struct EncodedCandidate {
  SparseCode code;
  /// Mean over the valid cells to 85 degrees, weighted by the projected solid angles of both directions, of
  /// (rho^(1/gamma) - rho'^(1/gamma))^2, rho in 1/sr (dissertation 4.3.2.4, where all cells count the same).
  double gammaError = 0;
  /// Mean of (rho - rho')^2 over the same cells with the same weights: what the selection does not go by.
  double squaredError = 0;
};

struct Encoded {
  SparseCode code;  ///< that of the candidate with the least gamma error; the first among equals
  std::vector<EncodedCandidate> candidates;  ///< in the order of the transforms
  double seconds = 0;
};

/// Prepares an ensemble for encoding many materials. Immutable.
class Encoder {
 public:
  /// @param ensemble must live on.
  explicit Encoder(const Ensemble& ensemble);

  /// For each transform and channel: the dictionary that holds most of the signal in its largest coefficients, those
  /// coefficients (the exact minimiser: the dictionaries are orthonormal), and rounds in which the invalid cells, whose
  /// values nobody sees, take those that the code gives them, so that it spends its coefficients on the valid ones.
  /// The rounds are iterative hard thresholding of the valid cells alone, with the momentum of Beck and Teboulle 2009,
  /// "A Fast Iterative Shrinkage-Thresholding Algorithm for Linear Inverse Problems": each takes the values a step
  /// further in the direction of the last change. The chosen code keeps its trial where more rounds do not lower the
  /// gamma error.
  /// @throws Error when the grid is another; Cancelled.
  Encoded encode(const TabulatedBrdf& table, const EncodeOptions& options = {}, const TaskControl& control = {}) const;
  const Ensemble& ensemble() const { return ensemble_; }

 private:
  struct Attempt;
  void start(Attempt& attempt, DataTransform transform, const TaskControl& control) const;
  void refine(Attempt& attempt, int rounds, const TaskControl& control) const;
  EncodedCandidate finished(const Attempt& attempt) const;
  int chooseDictionary(const Eigen::ArrayXf& signal, std::size_t coefficients) const;

  const Ensemble& ensemble_;
  std::vector<std::array<Eigen::MatrixXf, 3>> matrices_;
};

}  // namespace gonio::dictionary
