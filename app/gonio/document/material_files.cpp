// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/material_files.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>

#include "core/documents/edit_document.h"
#include "core/formats/formats.h"
#include "widgets/inputs/menu_text.h"

namespace gonio::app {

namespace {

struct MaterialFilesText {
  Q_DECLARE_TR_FUNCTIONS(MaterialFiles)
};

QString toQt(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }

QStringList patterns(bool (*isWanted)(const materials::MaterialFormat&)) {
  QStringList result;
  for (const materials::MaterialFormat* format : materials::materialFormats())
    if (isWanted(*format))
      for (const std::string_view suffix : format->suffixes) result << '*' + toQt(suffix);
  result.removeDuplicates();
  return result;
}

/// "MERL file (*.binary)" for each format.
QStringList filters(bool (*isWanted)(const materials::MaterialFormat&)) {
  QStringList result;
  for (const materials::MaterialFormat* format : materials::materialFormats())
    if (isWanted(*format)) result << formatFilter(*format);
  return result;
}

QString materialsAndDocuments() {
  return MaterialFilesText::tr("Materials and documents (%1 *%2)")
      .arg(materialFilePatterns().join(' '), documentSuffix());
}

}  // namespace

QStringList materialFilePatterns() { return patterns(materials::isAnyFormat); }
QStringList measurementFilePatterns() { return patterns(materials::isMeasurement); }

QString materialFilter() { return materialsAndDocuments() + ";;" + MaterialFilesText::tr("All files (*)"); }

QString openFilter() {
  const QStringList all = QStringList{materialsAndDocuments()} + filters(materials::isAnyFormat) +
                          QStringList{MaterialFilesText::tr("Gonio document (*%1)").arg(documentSuffix()),
                                      MaterialFilesText::tr("All files (*)")};
  return all.join(";;");
}

QString formatFilter(const materials::MaterialFormat& format) {
  return QStringLiteral("%1 (*%2)").arg(toQt(format.label), toQt(format.suffix()));
}

QString formatSuffix(const materials::MaterialFormat& format) { return toQt(format.suffix()); }
QString tableSuffix() { return formatSuffix(formats::merlFormat); }

bool isDocument(const QString& path) { return documents::isDocumentName(path.toStdString()); }
QString documentSuffix() { return toQt(documents::documentSuffix); }

QString shortName(const QString& id) {
  const QString last = id.section('/', -1);
  return id.startsWith(QLatin1String("library:")) ? widgets::spacedName(last) : last;
}

QString materialName(const QString& id) {
  const QString last = id.section('/', -1);
  return id.startsWith(QLatin1String("library:")) ? last : QFileInfo(last).completeBaseName();
}

QStringList distinctNames(const QStringList& ids) {
  QStringList plain, names;
  for (const QString& id : ids) plain << materialName(id);
  for (qsizetype i = 0; i < ids.size(); ++i) {
    const bool bundled = ids[i].startsWith(QLatin1String("library:"));
    const QString other = bundled ? ids[i].section(':', -1).section('/', -2, -2) : QFileInfo(ids[i]).suffix();
    QString name = plain.count(plain[i]) > 1 ? plain[i] + '_' + other : plain[i];
    while (names.contains(name)) name += '_';
    names << name;
  }
  return names;
}

namespace {
const QString settingsKey = QStringLiteral("recentFiles");
const QString bundledPrefix = QStringLiteral("library:");
}  // namespace

RecentFiles::RecentFiles(QSettings& settings)
    : m_settings(settings), m_paths(settings.value(settingsKey).toStringList()) {}

void RecentFiles::add(const QString& path) {
  const QString absolute = path.startsWith(bundledPrefix) ? path : QFileInfo(path).absoluteFilePath();
  m_paths.removeAll(absolute);
  m_paths.prepend(absolute);
  while (m_paths.size() > limit) m_paths.removeLast();
  store();
}

void RecentFiles::clear() {
  m_paths.clear();
  store();
}

bool RecentFiles::exists(const QString& path) { return path.startsWith(bundledPrefix) || QFileInfo::exists(path); }

void RecentFiles::store() { m_settings.setValue(settingsKey, m_paths); }

}  // namespace gonio::app
