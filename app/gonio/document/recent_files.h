// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStringList>

class QSettings;

namespace gonio::app {

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
