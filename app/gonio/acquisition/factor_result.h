// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/acquisition/acquisition_result.h"
#include "core/acquisition/factor_prediction.h"
#include "core/acquisition/factor_readings_file.h"

namespace gonio::app {

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
FactorResultPtr measureFactors(const FactorSettings& settings, const AcquisitionReferencePtr& reference,
                               const TaskControl& control = {});
/// The same for given readings. @param reference may be null. @throws Error, Cancelled.
FactorResultPtr predictFromReadings(const acquisition::FactorReadings& readings, acquisition::FactorBound bound,
                                    const AcquisitionReferencePtr& reference, const TaskControl& control = {});

/// Readings from a file (core/acquisition/factor_readings_file.h) and their curves over two coordinates
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
