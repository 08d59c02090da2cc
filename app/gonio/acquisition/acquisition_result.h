// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QString>
#include <functional>
#include <optional>

#include "core/acquisition/factor_plan.h"
#include "core/acquisition/factor_prediction.h"
#include "core/acquisition/reconstruction.h"
#include "core/rendering/render_picture.h"

namespace gonio::app {

/// The measured material, with which the reconstruction is compared: its table and its picture.
struct AcquisitionReference {
  QString id;  ///< file or library id; empty: none
  QString name;
  std::shared_ptr<const TabulatedBrdf> table;
  std::unique_ptr<const rendering::RenderedComparison> comparison;
  QImage picture;
};
using AcquisitionReferencePtr = std::shared_ptr<const AcquisitionReference>;

/// Size and samples of the pictures of references and reconstructions.
rendering::RenderOptions acquisitionPicture();

/// Makes a reference. Renders its picture in a few tenths of a second. @throws Cancelled.
AcquisitionReferencePtr acquisitionReference(const QString& id, const QString& name,
                                             std::shared_ptr<const TabulatedBrdf> table,
                                             const rendering::RenderOptions& picture, const TaskControl& control = {});
/// The same for a material that is read first. @throws Error that names the file; Cancelled.
AcquisitionReferencePtr readAcquisitionReference(const QString& id, const rendering::RenderOptions& picture,
                                                 const TaskControl& control = {});

/// Errors of a reconstruction against its reference.
struct AcquisitionError {
  double renderedSnr = 0;  ///< dB, in comparisonScene()
  double logError = 0;     ///< metrics::BrdfMetric::log
};

/// A picture of a reconstructed material and its differences from the reference.
struct ComparedPicture {
  QImage picture;
  std::optional<AcquisitionError> error;  ///< absent without a reference
  QImage errorMap;                        ///< differences of luminance in false colour; null without a reference
  double errorRange = 0;  ///< the difference shown in the last colour of errorMap, in the scene's unit of radiance
};

/// Renders a table and compares it with a reference, which may be null. Takes a few tenths of a second. @throws
/// Cancelled.
ComparedPicture comparedPicture(const TabulatedBrdf& table, const AcquisitionReferencePtr& reference,
                                const TaskControl& control = {});

/// A reconstruction with its pictures and errors.
struct AcquisitionResult : ComparedPicture {
  std::shared_ptr<const acquisition::Reconstruction> reconstruction;
  double deviationRange = 0;  ///< widgets::automaticRange() of the cells' standard deviations; 0 if they are unknown
};
using AcquisitionResultPtr = std::shared_ptr<const AcquisitionResult>;

struct AcquisitionInput {
  std::shared_ptr<const dictionary::PrincipalComponents> basis;
  acquisition::SamplingPlan plan;
  acquisition::MeasuredValues values;
  acquisition::ReconstructionOptions options;

  /// The input reduced to its first samples.
  AcquisitionInput prefix(std::size_t samples) const;
};

/// Reconstructs a material, in a few seconds. @param reference may be null. @throws Error, Cancelled.
AcquisitionResultPtr acquire(const AcquisitionInput& input, const AcquisitionReferencePtr& reference,
                             const TaskControl& control = {});

/// The numbers of samples at which an error curve up to m samples is measured: at most twelve, ascending, the last is
/// m.
std::vector<int> curveCounts(int m);
/// Measures the error of reconstructions from increasing numbers of samples. @param measured called on this thread with
/// each result.
/// @throws Error, Cancelled.
void measureCurve(const AcquisitionInput& input, const AcquisitionReferencePtr& reference,
                  const std::function<void(int samples, const AcquisitionError& error)>& measured,
                  const TaskControl& control = {});

struct FactorSettings {
  acquisition::FactorPlanOptions plan;
  acquisition::FactorBound bound = acquisition::FactorBound::readings;
  acquisition::MeasurementNoise noise;
};

/// A factor measurement: the readings, their curves, and the predicted material with its picture and error.
struct FactorResult : ComparedPicture {
  acquisition::FactorReadings readings;
  acquisition::FactorMeasurement curves;
  acquisition::FactorSupport support;
  std::shared_ptr<const TabulatedBrdf> table;
};
using FactorResultPtr = std::shared_ptr<const FactorResult>;

/// Simulates the readings of both curves of a reference and predicts the material, in about a second. @param reference
/// not null. @throws Error, Cancelled.
FactorResultPtr predictFromSimulation(const FactorSettings& settings, const AcquisitionReferencePtr& reference,
                                      const TaskControl& control = {});
/// The same for given readings. @param reference may be null. @throws Error, Cancelled.
FactorResultPtr predictFromReadings(const acquisition::FactorReadings& readings, acquisition::FactorBound bound,
                                    const AcquisitionReferencePtr& reference, const TaskControl& control = {});

/// Readings from a file (core/acquisition/factor_plan.h) and their curves over two coordinates
/// (acquisition::FactorAxes).
struct FactorReadingsFile {
  QString path;
  acquisition::FactorReadings readings;
  acquisition::FactorMeasurement curves;

  /// "READINGS.csv"
  QString name() const { return path.section('/', -1); }
};

/// Reads a file. @param axes the coordinates if the file names none.
/// @throws Error that names the file if it cannot be read, or if the readings are not two curves over these
/// coordinates: one in the mirror direction, one at a fixed angle.
FactorReadingsFile readFactorReadings(const QString& path, acquisition::FactorAxes axes);
/// The same readings over other coordinates. @throws Error that names the file if they are not two curves over them.
FactorReadingsFile withAxes(FactorReadingsFile file, acquisition::FactorAxes axes);

}  // namespace gonio::app
