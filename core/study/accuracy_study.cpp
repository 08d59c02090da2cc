// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/accuracy_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

#include "core/fitting/fit_parameters.h"
#include "core/metrics/brdf_metrics.h"
#include "core/models/registry.h"
#include "core/rendering/render_picture.h"

namespace gonio::study {

namespace {

/// Fraction of the progress that the reference's picture takes; the representations divide the rest evenly.
constexpr double referenceFraction = 0.02;
/// Fraction of a representation's progress that making it takes; the rest is measuring it.
constexpr double buildFraction = 0.6;
constexpr std::size_t maxFrames = 3;

/// Renders frames until their time is known, or has taken enough.
double frameMilliseconds(double enoughSeconds, const std::function<void()>& render) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> frames;
  double total = 0;
  while (frames.size() < maxFrames && total < 1000 * enoughSeconds) {
    const auto start = Clock::now();
    render();
    frames.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    total += frames.back();
  }
  return quantile(std::move(frames), 0.5);
}

/// For frames: of a study, and of a single act, which a user waits for and for which one frame is usually enough.
constexpr double enoughForStudy = 1, enoughForAct = 0.05;

UseCost useCost(const rendering::RenderedComparison& comparison, const Brdf& brdf, double enoughSeconds,
                const TaskControl& stop) {
  return {measureEvaluation(brdf, stop), frameMilliseconds(enoughSeconds, [&] { comparison.trace(brdf, stop); })};
}

/// The pictures of a study: measured, and shown where other pictures are.
struct StudyPictures {
  rendering::RenderedComparison measured;
  std::optional<rendering::RenderedComparison> shown;

  StudyPictures(const Brdf& reference, const StudyOptions& options, const TaskControl& control)
      : measured(sceneOf(options), reference, options.picture, control.between(0, 0.5)) {
    if (options.shown) shown.emplace(sceneOf(options), reference, *options.shown, control.between(0.5, 1));
  }
  static rendering::Scene sceneOf(const StudyOptions& options) {
    return options.scene ? *options.scene : rendering::comparisonScene();
  }
  const Image& reference() const { return shown ? shown->reference() : measured.reference(); }
};

MeasuredRepresentation measure(const Representation& representation, const BuiltRepresentation& built,
                               const Brdf& measurement, const StudyPictures& pictures, const StudyOptions& options,
                               const TaskControl& stop) {
  MeasuredRepresentation studied{
      .record = {.representation = representation, .bytes = built.bytes, .encodeSeconds = built.encodeSeconds},
      .brdf = built.brdf,
      .picture = {},
      .tabulated = built.tabulated,
      .fit = built.fit};
  StudyRecord& record = studied.record;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const UseCost cost =
      options.timed ? useCost(pictures.measured, *built.brdf, enoughForStudy, stop) : UseCost{{none, none, none}, none};
  record.evaluation = cost.evaluation;
  record.frameMilliseconds = cost.frameMilliseconds;
  rendering::ComparisonPicture picture = pictures.measured.render(*built.brdf, stop);
  record.renderedSnr = pictures.measured.signalToNoiseRatio(picture);
  studied.picture = pictures.shown ? pictures.shown->render(*built.brdf, stop).image : std::move(picture.image);
  stop.throwIfStopped();
  const fitting::FitOptions& fit = options.build.fit;
  const bool useNodes = built.nodes && formOf<TabulatedBrdf>(measurement);
  record.errors =
      built.fit ? built.fit->errors
                : metrics::brdfErrors(measurement, useNodes ? static_cast<const Brdf&>(*built.nodes) : *built.brdf,
                                      fit.maxPolarAngle, fit.gamma);
  stop.throwIfStopped();
  return studied;
}

}  // namespace

UseCost measureUse(const Brdf& brdf, const TaskControl& control) {
  const TaskControl stop{control.stop, {}};
  const rendering::Scene scene = rendering::comparisonScene();
  rendering::RenderOptions picture = rendering::smallComparisonPicture();
  picture.density = estimateSamplingDensity(brdf);
  control.report(0.3);
  UseCost cost{measureEvaluation(brdf, stop)};
  control.report(0.5);
  cost.frameMilliseconds =
      frameMilliseconds(enoughForAct, [&] { rendering::renderPicture(brdf, scene, picture, stop); });
  return cost;
}

MaterialQuality measureQuality(const Brdf& measurement, const Brdf& used, const TabulatedBrdf* decoded,
                               const rendering::RenderOptions& picture, const TaskControl& control) {
  const rendering::RenderedComparison comparison(measurement, picture, control.between(0, 0.4));
  const TaskControl stop{control.stop, {}};
  MaterialQuality quality;
  quality.renderedSnr = comparison.signalToNoiseRatio(comparison.render(used, stop));
  control.report(0.6);
  const Brdf& compared = decoded ? static_cast<const Brdf&>(*decoded) : used;
  quality.errors = metrics::brdfErrors(measurement, compared);
  stop.throwIfStopped();
  quality.brdfSnr = metrics::brdfSignalToNoiseRatio(measurement, compared);
  control.report(0.8);
  quality.cost = useCost(comparison, used, enoughForAct, stop);
  return quality;
}

std::vector<StudyRecord> runStudy(const StudySubject& subject, std::span<const Representation> representations,
                                  const StudyOptions& options, const TaskControl& control) {
  std::vector<StudyRecord> records;
  try {
    const StudyPictures pictures(*subject.reference, options, control.between(0, referenceFraction));
    if (options.referenceRendered) options.referenceRendered(pictures.reference());
    RepresentationBuilder builder(subject, options.build, representations);
    const double fraction = (1 - referenceFraction) / double(std::max<std::size_t>(1, representations.size()));
    for (const Representation& representation : representations) {
      const double begin = referenceFraction + double(records.size()) * fraction;
      const BuiltRepresentation built =
          builder.build(representation, control.between(begin, begin + buildFraction * fraction));
      const MeasuredRepresentation studied =
          measure(representation, built, *subject.reference, pictures, options, {.stop = control.stop, .progress = {}});
      records.push_back(studied.record);
      if (options.measured) options.measured(studied);
      control.report(begin + fraction);
    }
    control.report(1);
  } catch (const Cancelled&) {
  }
  return records;
}

std::vector<RankedFit> rankFits(const StudySubject& subject, const RankingOptions& options,
                                const TaskControl& control) {
  std::vector<RankedFit> ranking;
  const auto symmetry =
      subject.reference->isIsotropic() ? fitting::DataSymmetry::isotropic : fitting::DataSymmetry::anisotropic;
  const auto add = [&](const MeasuredRepresentation& studied) {
    ranking.push_back({*studied.fit, studied.record.renderedSnr, studied.picture,
                       fitting::fittedParameterCount(studied.fit->model->spec(), symmetry)});
    if (options.modelDone) options.modelDone(ranking.back());
  };
  const StudyOptions study{
      .build = {.fit = options.fit, .dictionary = {}}, .picture = options.picture, .timed = false, .measured = add};
  std::vector<const models::Model*> models = options.models;
  if (models.empty()) models.assign(models::allModels().begin(), models::allModels().end());
  std::vector<Representation> fits;
  for (const models::Model* model : models) fits.push_back(representationById(model->spec().id));
  runStudy(subject, fits, study, control);
  return ranking;
}

void sortRanking(std::vector<RankedFit>& ranking, std::optional<metrics::BrdfMetric> metric) {
  const auto key = [&](const RankedFit& row) {
    const double value = metric ? row.fit.errors[static_cast<std::size_t>(*metric)] : -row.renderedSnr;
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  std::ranges::stable_sort(ranking, {}, key);
}

}  // namespace gonio::study
