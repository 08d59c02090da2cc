// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <QStringList>
#include <memory>

#include "core/dictionary/principal_components.h"

namespace gonio::app {

/// Materials from which an acquisition learns what materials are like.
struct TrainingSet {
  QString name;     ///< for people: "measured materials of the library"
  QStringList ids;  ///< as materials::readMaterial() takes them

  bool operator==(const TrainingSet&) const = default;
};

/// materials::libraryTrainingPaths().
TrainingSet libraryTraining();
/// The bundled library's measured materials, its near-measured copies of MERL, and its published fits.
TrainingSet measuredTraining();
TrainingSet nearMeasuredTraining();
TrainingSet fittedTraining();
/// The material files of a folder, not of its subfolders; no ids where there are none.
TrainingSet folderTraining(const QString& folder);

/// What a material is called whatever file holds it: "cc_iris_purple_gem" of "library:rgl/cc_iris_purple_gem" and of
/// "cc_iris_purple_gem_rgb.bsdf".
QString baseName(const QString& id);
/// Those that are not this material or a copy of it under the same name.
QStringList without(const QStringList& ids, const QString& id);

/// Reads the materials one after another and learns their principal components. About a second each where a
/// material is no table. Memory: PrincipalComponents.
/// @throws Error naming the file; Cancelled.
std::shared_ptr<const dictionary::PrincipalComponents> learnBasis(const QStringList& ids,
                                                                  const TaskControl& control = {});

}  // namespace gonio::app
