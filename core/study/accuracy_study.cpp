// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/accuracy_study.h"

#include <chrono>

#include "core/metrics/brdf_metrics.h"
#include "core/rendering/render_picture.h"

namespace gonio::study {

namespace {

/// Fraction of the progress that the reference's picture takes; the representations divide the rest evenly.
constexpr double referenceShare = 0.02;
/// Fraction of a representation's progress that making it takes; the rest is measuring it.
constexpr double buildShare = 0.6;
constexpr std::size_t maxFrames = 3;
constexpr double enoughSeconds = 1;

/// Renders frames until their time is known.
double frameMilliseconds(const RenderedComparison& comparison, const Brdf& brdf, const TaskControl& stop) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> frames;
  double total = 0;
  while (frames.size() < maxFrames && total < 1000 * enoughSeconds) {
    const auto start = Clock::now();
    comparison.trace(brdf, stop);
    frames.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    total += frames.back();
  }
  return quantile(std::move(frames), 0.5);
}

MeasuredRepresentation measure(const Representation& representation, const BuiltRepresentation& built,
                               const Brdf& measurement, const RenderedComparison& comparison,
                               const StudyOptions& options, const TaskControl& stop) {
  MeasuredRepresentation studied{
      .record = {.representation = representation, .bytes = built.bytes, .encodeSeconds = built.encodeSeconds},
      .brdf = built.brdf,
      .picture = {},
      .tabulated = built.tabulated,
      .fit = built.fit};
  StudyRecord& record = studied.record;
  if (options.timed) record.evaluation = measureEvaluation(*built.brdf, stop);
  if (options.timed) record.frameMilliseconds = frameMilliseconds(comparison, *built.brdf, stop);
  ComparisonPicture picture = comparison.render(*built.brdf, stop);
  record.renderedSnr = comparison.signalToNoiseRatio(picture);
  studied.picture = std::move(picture.image);
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

std::vector<StudyRecord> runStudy(const StudySubject& subject, std::span<const Representation> representations,
                                  const StudyOptions& options, const TaskControl& control) {
  std::vector<StudyRecord> records;
  try {
    const RenderedComparison comparison(options.scene ? *options.scene : comparisonScene(), *subject.reference,
                                        options.picture, control.between(0, referenceShare));
    if (options.referenceRendered) options.referenceRendered(comparison.reference());
    RepresentationBuilder builder(subject, options.build, representations);
    const double fraction = (1 - referenceShare) / double(std::max<std::size_t>(1, representations.size()));
    for (const Representation& representation : representations) {
      const double begin = referenceShare + double(records.size()) * fraction;
      const BuiltRepresentation built =
          builder.build(representation, control.between(begin, begin + buildShare * fraction));
      const MeasuredRepresentation studied = measure(representation, built, *subject.reference, comparison, options,
                                                     {.stop = control.stop, .progress = {}});
      records.push_back(studied.record);
      if (options.measured) options.measured(studied);
      control.report(begin + fraction);
    }
    control.report(1);
  } catch (const Cancelled&) {
  }
  return records;
}

}  // namespace gonio::study
