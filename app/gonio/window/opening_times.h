// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>

namespace gonio::app {

struct EditorParts;

/// Opens materials one after the other, prints how long each takes until it is read and until its first picture is on
/// the screen (at most a frame later), and ends the program. The first material is opened when the window has shown
/// nothing for a second, so that its start does not count; the shaders of its form do.
class OpeningTimes : public QObject {
  Q_OBJECT

 public:
  OpeningTimes(EditorParts& parts, const QStringList& paths, QObject* parent = nullptr);

 private:
  void openNext();
  void adoptMaterial();
  void adoptPicture();

  EditorParts& m_parts;
  QStringList m_paths;
  QElapsedTimer m_elapsed;
  qint64 m_read = -1;  ///< ms; -1: not read yet
  int m_before = 0;    ///< the preview's last request of what was open before
};

}  // namespace gonio::app
