// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSize>
#include <QTimer>
#include <functional>

class QWidget;

namespace gonio::app {

/// Saves a picture of a window once everything in it is settled, or after the maximum wait, and ends the program.
class Screenshot : public QObject {
  Q_OBJECT

 public:
  Screenshot(QWidget& window, std::function<bool()> isSettled, const QString& path, double maxWaitSeconds);

 private:
  void check();

  QWidget& m_window;
  std::function<bool()> m_isSettled;
  QString m_path;
  double m_maxWaitSeconds;
  QElapsedTimer m_elapsed;
  QTimer m_timer;
  int m_settledChecks = 0;
};

}  // namespace gonio::app
