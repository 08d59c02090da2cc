// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace gonio::app {

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
