// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>

#include "core/math/image.h"
#include "core/rendering/render_picture.h"
#include "core/study/representation_builder.h"
#include "core/study/study_record.h"

namespace gonio::study {

/// What using a material costs on this machine at the moment: the times of a StudyRecord.
struct UseCost {
  EvaluationTime evaluation;
  double frameMilliseconds = 0;
};

/// Measures measureEvaluation() and the time of a frame of comparisonScene() (median of three, or fewer if they take
/// more than 50 ms). Takes about the time of two frames. @throws Cancelled.
UseCost measureUse(const Brdf& brdf, const TaskControl& control = {});

/// How close a material is to the measurement that it stands for, and what using it costs: the numbers of a
/// StudyRecord, for a single one. Every command, the editor and Python take them from here.
struct MaterialQuality {
  std::vector<double>
      errors;              ///< against the measurement in its native form, in the order of metrics::allBrdfMetrics()
  double brdfSnr = 0;      ///< dB, as metrics::brdfSignalToNoiseRatio()
  double renderedSnr = 0;  ///< in comparisonScene(), dB; +infinity for equal pictures, NaN for a black reference
  UseCost cost;
};

/// Measures a material against a measurement. @param used evaluated in the pictures and timed, such as a code. @param
/// decoded the same as a table, from which errors and BRDF SNR are computed faster; null: `used`. @param picture size
/// and samples of the pictures. About two seconds on two cores. @throws Cancelled.
MaterialQuality measureQuality(const Brdf& measurement, const Brdf& used, const TabulatedBrdf* decoded = nullptr,
                               const rendering::RenderOptions& picture = rendering::smallComparisonPicture(),
                               const TaskControl& control = {});

/// A measured representation.
struct MeasuredRepresentation {
  StudyRecord record;
  std::shared_ptr<const Brdf> brdf;
  Image picture;  ///< in the study's scene, linear RGB
  std::function<std::shared_ptr<const TabulatedBrdf>(const TaskControl&)> tabulated;  ///< see BuiltRepresentation
  std::optional<fitting::FitResult> fit;                                              ///< see BuiltRepresentation
};

struct StudyOptions {
  BuildOptions build;
  /// Options of the measured pictures and of the timed frames. `density` is replaced by the reference's.
  rendering::RenderOptions picture = rendering::smallComparisonPicture();
  /// Size and samples of the pictures that are returned, where they differ from those that are measured.
  std::optional<rendering::RenderOptions> shown = {};
  /// Scene of the pictures instead of comparisonScene(); then the rendered SNRs are those of this scene.
  std::optional<rendering::Scene> scene = {};
  /// Whether to measure the times of an evaluation and a frame; false: they are NaN, and only one frame is rendered.
  bool timed = true;
  /// Called after each representation, in order, on the calling thread.
  std::function<void(const MeasuredRepresentation&)> measured = {};
  /// Called first, with the picture of the reference.
  std::function<void(const Image&)> referenceRendered = {};
};

/// Builds representations of one material and measures each: errors by every metric, rendered SNR, bytes, and how long
/// encoding, an evaluation and a frame take on this machine at the moment (a frame: median of three, or fewer if they
/// take more than a second). Errors exclude angles beyond build.fit.maxPolarAngle. Deterministic except for times.
/// About two seconds per representation on two cores.
/// @return one record per representation, in order. A stop request returns the completed records; runStudy() never
/// throws Cancelled.
/// @throws Error as RepresentationBuilder::build().
std::vector<StudyRecord> runStudy(const StudySubject& subject, std::span<const Representation> representations,
                                  const StudyOptions& options = {}, const TaskControl& control = {});

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
  /// Options of the pictures. `density` is replaced by the reference's.
  rendering::RenderOptions picture = rendering::smallComparisonPicture();
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
