// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/rendered_comparison.h"
#include "core/study/accuracy_study.h"

namespace gonio::study {

/// One row of the ranking of models: what a fit of it gives, and costs.
struct RankedFit {
  fitting::FitResult fit;
  double renderedSnr = 0;          ///< dB in comparisonScene(); +infinity for equal pictures, NaN for a black reference
  Image picture;                   ///< the fitted model in that scene, linear RGB
  std::size_t parameterCount = 0;  ///< numbers that the fit finds, see fitting::fittedParameterCount()
};

struct RankingOptions {
  fitting::FitOptions fit;
  std::vector<const models::Model*> models;  ///< none: all registered ones, in their order
  /// Of each row; the lobe is the reference's.
  RenderOptions picture = smallComparisonPicture();
  /// Called after each model, in their order, on the calling thread.
  std::function<void(const RankedFit&)> modelDone = {};
};

/// The accuracy study (runStudy) of parametric fits alone, without the times of evaluations and frames. Deterministic
/// for any number of threads. All models together take under 60 s for a MERL table on 2 cores.
/// @return a row a model, in their order. A stop request returns the rows that are done; it never throws Cancelled.
std::vector<RankedFit> rankFits(const StudySubject& subject, const RankingOptions& options = {},
                                const TaskControl& control = {});

/// Best first, by the error of a metric or, with none, by the rendered SNR; what is not a number comes last.
void sortRanking(std::vector<RankedFit>& ranking, std::optional<metrics::BrdfMetric> metric);

}  // namespace gonio::study
