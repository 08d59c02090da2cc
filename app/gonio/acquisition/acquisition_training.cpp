// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_training.h"

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>

#include "app/gonio/document/material_files.h"
#include "core/materials/bundled_library.h"
#include "core/materials/material.h"
#include "core/materials/material_formats.h"

namespace gonio::app {

namespace {

struct AcquisitionTrainingText {
  Q_DECLARE_TR_FUNCTIONS(AcquisitionTraining)
};

QStringList libraryIds(const QString& collection) {
  QStringList ids;
  for (const materials::LibraryEntry& entry : materials::bundledLibrary())
    if (const QString id = QString::fromStdString(entry.id); id.startsWith(collection))
      ids << QString::fromUtf8(materials::libraryScheme.data(), qsizetype(materials::libraryScheme.size())) + id;
  return ids;
}

}  // namespace

TrainingSet libraryTraining() {
  QStringList ids;
  for (const std::string& path : materials::libraryTrainingPaths()) ids << QString::fromStdString(path);
  return {AcquisitionTrainingText::tr("measured materials and near-measured copies"), ids};
}
TrainingSet measuredTraining() {
  return {AcquisitionTrainingText::tr("measured materials of the library"), libraryIds(QStringLiteral("rgl/"))};
}
TrainingSet nearMeasuredTraining() {
  return {AcquisitionTrainingText::tr("near-measured copies of MERL"), libraryIds(QStringLiteral("merl-copy/"))};
}
TrainingSet fittedTraining() {
  return {AcquisitionTrainingText::tr("published fits of the library"), libraryIds(QStringLiteral("sgd/"))};
}

TrainingSet folderTraining(const QString& folder) {
  const QDir dir(folder);
  TrainingSet set{AcquisitionTrainingText::tr("files of %1").arg(dir.dirName()), {}};
  for (const QFileInfo& file : dir.entryInfoList(measurementFilePatterns(), QDir::Files | QDir::Readable, QDir::Name))
    if (const materials::MaterialFormat* format = materials::formatOfFile(file.filesystemAbsoluteFilePath());
        format && format->isMeasurement)
      set.ids << file.absoluteFilePath();
  return set;
}

QString baseName(const QString& id) {
  static const QRegularExpression ending(QStringLiteral("(_rgb|_spec)?(\\.[a-z]+)?$"),
                                         QRegularExpression::CaseInsensitiveOption);
  return id.section('/', -1).remove(ending).toLower();
}

QStringList without(const QStringList& ids, const QString& id) {
  if (id.isEmpty()) return ids;
  QStringList kept;
  for (const QString& one : ids)
    if (one != id && baseName(one) != baseName(id)) kept << one;
  return kept;
}

std::shared_ptr<const dictionary::PrincipalComponents> learnBasis(const QStringList& ids, int components,
                                                                  const TaskControl& control) {
  if (ids.size() < 2)
    throw Error("The training set has " + std::to_string(ids.size()) + (ids.size() == 1 ? " material" : " materials") +
                "; it needs at least 2.");
  const auto load = [&](std::size_t material) {
    const std::string id = ids[qsizetype(material)].toStdString();
    return materials::readMaterial(id, {control.stop, {}}).tabulated({control.stop, {}});
  };
  return std::make_shared<const dictionary::PrincipalComponents>(
      dictionary::learnPrincipalComponents(std::size_t(ids.size()), load, {.maxComponents = components}, control));
}

}  // namespace gonio::app
