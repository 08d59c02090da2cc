// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>

namespace gonio::app {

struct EditorParts;

/// Opens materials one after the other, prints the times until each is read and until its first picture is displayed
/// (up to one frame too long), and ends the program. The first material is opened after one second, so that the start
/// of the program is not included, but the compilation of shaders is.
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
  int m_before = 0;    ///< the preview's last request for the previous material
};

}  // namespace gonio::app
