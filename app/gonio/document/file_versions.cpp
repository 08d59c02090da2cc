// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/file_versions.h"

#include <QFileInfo>

#include "core/io/sha256.h"
#include "core/support/error.h"

namespace gonio::app {

namespace {
QString keyOf(const QString& path) { return QFileInfo(path).absoluteFilePath(); }
}  // namespace

QByteArray FileVersions::digest(const QString& path) {
  try {
    return QByteArray::fromStdString(io::sha256Hex(io::FileSource(path.toStdString())));
  } catch (const Error&) {
    return {};
  }
}

void FileVersions::remember(const QString& path, const QByteArray& digest) { m_digests[keyOf(path)] = digest; }

bool FileVersions::hasChanged(const QString& path) const {
  const auto known = m_digests.constFind(keyOf(path));
  if (known == m_digests.constEnd()) return false;
  const QByteArray current = digest(path);
  return !current.isEmpty() && current != *known;
}

}  // namespace gonio::app
