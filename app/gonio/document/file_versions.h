// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QByteArray>
#include <QHash>
#include <QString>

namespace gonio::app {

/// The documents that this editor has read or written, each with a digest of its content at that time. Before a file is
/// replaced, its digest shows whether another program has written to it since.
class FileVersions {
 public:
  /// SHA-256 of the file's content; empty if there is no such file or it cannot be read.
  static QByteArray digest(const QString& path);

  void remember(const QString& path, const QByteArray& digest);
  /// Whether the file was remembered and now has other content. False for a file that no longer exists, since saving
  /// then loses nothing. Reads the file.
  bool hasChanged(const QString& path) const;

 private:
  QHash<QString, QByteArray> m_digests;  ///< by absolute path
};

}  // namespace gonio::app
