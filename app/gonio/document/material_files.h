// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStringList>

#include "core/materials/material_formats.h"

class QSettings;

namespace gonio::app {

/// The formats of materials (core/materials/material_formats.h) as filters for Qt's dialogs and folders. When a file is
/// opened, its content decides, not its name.

/// Patterns of the files shown in dialogs and folders of the library: "*.binary", "*.bsdf", ...
QStringList materialFilePatterns();
/// Patterns of measured materials only, for training sets from a folder.
QStringList measurementFilePatterns();

/// "Materials and documents (..);;All files (*)".
QString materialFilter();
/// The same with additional filters for each format.
QString openFilter();
/// File filter of a format for dialogs, e.g. "RGL file (*.bsdf)".
QString formatFilter(const materials::MaterialFormat& format);
/// Suffix of written files of a format, e.g. ".binary".
QString formatSuffix(const materials::MaterialFormat& format);
/// Suffix of the editor's default format, e.g. ".binary".
QString tableSuffix();

/// Whether the suffix is that of a .gonio document.
bool isDocument(const QString& path);
QString documentSuffix();

/// The name of a material for display: that of the file, or of a bundled material, with spaces for underscores.
QString shortName(const QString& id);
/// Name of a material: "chrome" for "library:merl-copy/chrome" and for "/data/chrome.binary".
QString materialName(const QString& id);
/// Distinct names of several materials: equal names are extended with their source or suffix, e.g. "paper_rgl".
QStringList distinctNames(const QStringList& ids);

/// The last opened files, newest first, at most ten, stored in the settings. Missing files stay listed, because their
/// drive may be reconnected.
class RecentFiles {
 public:
  static constexpr int limit = 10;

  explicit RecentFiles(QSettings& settings);

  const QStringList& paths() const { return m_paths; }
  void add(const QString& path);
  void clear();
  /// Whether a path can be opened now; bundled materials always.
  static bool exists(const QString& path);

 private:
  void store();

  QSettings& m_settings;
  QStringList m_paths;
};

}  // namespace gonio::app
