// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSize>
#include <QTimer>

namespace gonio::app {

class MainWindow;

/// Saves a picture of a window when everything in it is settled, or after the longest wait, and ends the program.
class Screenshot : public QObject {
  Q_OBJECT

 public:
  Screenshot(MainWindow& window, const QString& path, double longestWaitSeconds);

 private:
  void check();

  MainWindow& m_window;
  QString m_path;
  double m_longestWaitSeconds;
  QElapsedTimer m_elapsed;
  QTimer m_timer;
  int m_settledChecks = 0;
};

}  // namespace gonio::app
