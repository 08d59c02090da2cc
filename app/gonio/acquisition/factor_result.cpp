// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/factor_result.h"

#include "core/support/file_in_errors.h"

namespace gonio::app {

FactorResultPtr measureFactors(const FactorSettings& settings, const AcquisitionReferencePtr& reference,
                               const TaskControl& control) {
  acquisition::FactorReadings readings{.plan = acquisition::planFactors(settings.plan), .values = {}};
  readings.values = acquisition::measure(*reference->table, readings.plan.plan, settings.noise);
  return predictFromReadings(readings, settings.bound, reference, control);
}

FactorResultPtr predictFromReadings(const acquisition::FactorReadings& readings, acquisition::FactorBound bound,
                                    const AcquisitionReferencePtr& reference, const TaskControl& control) {
  constexpr double predictedFraction = 0.5;
  auto result = std::make_shared<FactorResult>();
  result->readings = readings;
  result->curves = acquisition::factorMeasurement(readings.plan, readings.values);
  result->support = acquisition::supportOf(result->curves);
  result->table =
      bakeTable(*acquisition::predictFromFactors(result->curves, bound),
                reference ? reference->table->grid() : HalfDifferenceGrid(), control.between(0, predictedFraction));
  static_cast<ComparedPicture&>(*result) =
      comparedPicture(*result->table, reference, control.between(predictedFraction, 1));
  return result;
}

FactorReadingsFile readFactorReadings(const QString& path, acquisition::FactorAxes axes) {
  FactorReadingsFile file{path, acquisition::readFactorReadings(path.toStdString(), axes), {}};
  const auto named = acquisition::axesOfFactorMethod(file.readings.plan.plan.method);
  try {
    return withAxes(std::move(file), named.value_or(axes));
  } catch (const Error& error) {
    if (named) throw;
    throw Error(
        std::string(error.what()) +
        "\nThe file does not state its axes (comment \"# method: factors, AXES\"), so the selected ones were used. "
        "Select the axes of the readings, then open the file again.");
  }
}

FactorReadingsFile withAxes(FactorReadingsFile file, acquisition::FactorAxes axes) {
  return withFileInErrors(file.path.toStdString(), [&] {
    file.readings.plan.axes = axes;
    file.readings.plan.plan.method = acquisition::factorMethod(axes);
    file.curves = acquisition::factorMeasurement(file.readings.plan, file.readings.values);
    return file;
  });
}

}  // namespace gonio::app
