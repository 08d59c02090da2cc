// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QString>
#include <functional>
#include <optional>

#include "core/acquisition/reconstruction.h"
#include "core/rendering/rendered_comparison.h"

namespace gonio::app {

/// A material that is measured, and against which its reconstruction is judged: its table and its picture.
struct AcquisitionReference {
  QString id;  ///< of the file or the library; empty where there is none
  QString name;
  std::shared_ptr<const TabulatedBrdf> table;
  std::unique_ptr<const RenderedComparison> comparison;
  QImage picture;
};
using AcquisitionReferencePtr = std::shared_ptr<const AcquisitionReference>;

/// Size and samples of the pictures: every reconstruction that is compared has one.
RenderOptions acquisitionPicture();

/// Renders the picture: some tenths of a second. @throws Cancelled.
AcquisitionReferencePtr acquisitionReference(const QString& id, const QString& name,
                                             std::shared_ptr<const TabulatedBrdf> table, const RenderOptions& picture,
                                             const TaskControl& control = {});
/// The same of a material that is read first. @throws Error naming the file; Cancelled.
AcquisitionReferencePtr readAcquisitionReference(const QString& id, const RenderOptions& picture,
                                                 const TaskControl& control = {});

/// How far a reconstruction is from its reference.
struct AcquisitionError {
  double renderedSnr = 0;  ///< dB, in comparisonScene()
  double logError = 0;     ///< metrics::BrdfMetric::log
};

/// A reconstruction as it is shown.
struct AcquisitionResult {
  std::shared_ptr<const acquisition::Reconstruction> reconstruction;
  QImage picture;
  std::optional<AcquisitionError> error;  ///< absent without a reference
  QImage errorMap;                        ///< differences of luminance in false colour; null without a reference
  double errorRange = 0;                  ///< the difference that has the last colour, in the scene's unit of radiance
  double deviationRange = 0;              ///< a deviation that nearly all cells are below; 0 where none is known
};
using AcquisitionResultPtr = std::shared_ptr<const AcquisitionResult>;

struct AcquisitionInput {
  std::shared_ptr<const dictionary::PrincipalComponents> basis;
  acquisition::SamplingPlan plan;
  acquisition::MeasuredValues values;
  acquisition::ReconstructionOptions options;

  /// With the first samples alone.
  AcquisitionInput prefix(std::size_t samples) const;
};

/// Some seconds. @param reference may be null. @throws Error, Cancelled.
AcquisitionResultPtr acquire(const AcquisitionInput& input, const AcquisitionReferencePtr& reference,
                             const TaskControl& control = {});

/// Numbers of samples at which a curve up to m is measured: a dozen at most, ascending, the last is m.
std::vector<int> curveCounts(int m);
/// The error of reconstructions from ever more of the samples. @param measured called on this thread with each.
/// @throws Error, Cancelled.
void measureCurve(const AcquisitionInput& input, const AcquisitionReferencePtr& reference,
                  const std::function<void(int samples, const AcquisitionError& error)>& measured,
                  const TaskControl& control = {});

}  // namespace gonio::app
