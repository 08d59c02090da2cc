// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <QStringList>
#include <memory>

#include "core/dictionary/principal_components.h"

namespace gonio::app {

/// The materials from which an acquisition learns its principal components.
struct TrainingSet {
  QString name;     ///< name in the interface, e.g. "measured materials of the library"
  QStringList ids;  ///< as materials::readMaterial() takes them

  bool operator==(const TrainingSet&) const = default;
};

/// The default training set: the measured materials of the bundled library, and near-measured copies of materials that
/// are not among them (materials::libraryTrainingPaths()).
TrainingSet libraryTraining();
/// The measured materials of the bundled library.
TrainingSet measuredTraining();
/// The near-measured copies of MERL materials in the bundled library.
TrainingSet nearMeasuredTraining();
/// The published fits in the bundled library.
TrainingSet fittedTraining();
/// The files of measured materials (MaterialFormat::isMeasurement) in a folder, not in its subfolders; no ids if there
/// are none.
TrainingSet folderTraining(const QString& folder);

/// Name of a material independent of its file, in lower case: "cc_iris_purple_gem" for "library:rgl/cc_iris_purple_gem"
/// and for "cc_iris_purple_gem_rgb.bsdf".
QString baseName(const QString& id);
/// The ids without this material and copies of it, which have the same baseName().
QStringList without(const QStringList& ids, const QString& id);

/// Maximum number of components with a fixed ridge, which permits more components than samples. The time for the
/// uncertainty grows with the square of their number, and a component takes about 4 MB.
inline constexpr int maxComponents = 100;

/// Reads the materials one after another and learns their first principal components. About a second per material that
/// is not a table. Memory: see learnPrincipalComponents().
/// @throws Error that names the file, or if there are fewer than two materials; Cancelled.
std::shared_ptr<const dictionary::PrincipalComponents> learnBasis(const QStringList& ids, int components,
                                                                  const TaskControl& control = {});

}  // namespace gonio::app
