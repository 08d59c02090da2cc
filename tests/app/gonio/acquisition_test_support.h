// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTemporaryDir>

#include "app/gonio/acquisition/acquisition_session.h"
#include "core/materials/material.h"
#include "core/models/registry.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/table_file.h"

namespace gonio::app::test_support {

inline rendering::RenderOptions smallPicture() { return {.width = 24, .height = 24, .samples = 4, .density = {}}; }

/// A small training set as files, beside a material that is none of it.
struct SmallLibrary {
  QTemporaryDir folder;
  TrainingSet training;
  QString subject = write("subject", {0.3, 0.12, 0.06}, 0.32);

  SmallLibrary() {
    for (const double roughness : {0.15, 0.25, 0.4, 0.6})
      for (const double albedo : {0.1, 0.5})
        training.ids << write(QString("m%1-%2").arg(roughness).arg(albedo), Rgb(albedo, 0.5 * albedo, 0.2), roughness);
    training.name = "small";
  }

  QString write(const QString& name, const Rgb& albedo, double roughness) {
    const HalfDifferenceGrid grid{16, 16, 24};
    const models::Model& model = models::findModel("ggx");
    models::ParameterValues values = models::defaultParameters(model.spec());
    values.values[0] = albedo;
    values.values[*model.spec().find("roughness")] = Rgb(roughness);
    const QString path = folder.filePath(name + ".binary");
    test::writeTable(*bakeTable(*model.instantiate(values), grid), path.toStdString());
    return path;
  }

  PlanSettings settings(int samples = 8) const {
    PlanSettings settings;
    settings.training = training;
    settings.samples = samples;
    return settings;
  }
};

}  // namespace gonio::app::test_support
