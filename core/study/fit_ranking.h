// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/render_picture.h"
#include "core/study/accuracy_study.h"

namespace gonio::study {

/// One row of the ranking of models: a fit and its accuracy.
struct RankedFit {
  fitting::FitResult fit;
  double renderedSnr = 0;  ///< in comparisonScene(), dB; +infinity for equal pictures, NaN for a black reference
  Image picture;           ///< the fitted model in that scene, linear RGB
  std::size_t parameterCount = 0;  ///< fitting::fittedParameterCount()
};

struct RankingOptions {
  fitting::FitOptions fit;
  std::vector<const models::Model*> models;  ///< empty: all registered models, in order
  /// Options of the pictures. `lobe` is replaced by the reference's.
  RenderOptions picture = smallComparisonPicture();
  /// Called after each model, in order, on the calling thread.
  std::function<void(const RankedFit&)> modelDone = {};
};

/// The accuracy study (runStudy()) of parametric fits only, without the times of evaluations and frames. Deterministic
/// for any number of threads. All models together take 10 to 12 s for a MERL table on two cores.
/// @return one row per model, in order. A stop request returns the completed rows; rankFits() never throws Cancelled.
std::vector<RankedFit> rankFits(const StudySubject& subject, const RankingOptions& options = {},
                                const TaskControl& control = {});

/// Sorts by the error of a metric, or by the rendered SNR if `metric` is empty, best first and NaN last.
void sortRanking(std::vector<RankedFit>& ranking, std::optional<metrics::BrdfMetric> metric);

}  // namespace gonio::study
