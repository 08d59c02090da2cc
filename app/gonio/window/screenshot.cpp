// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/screenshot.h"

#include <QApplication>
#include <QTextStream>
#include <QWidget>

namespace gonio::app {

namespace {
constexpr int checkMilliseconds = 200;
/// A window counts as settled when nothing happened for this many checks: one task may start the next.
constexpr int neededChecks = 4;
}  // namespace

Screenshot::Screenshot(QWidget& window, std::function<bool()> isSettled, const QString& path, double maxWaitSeconds)
    : QObject(&window),
      m_window(window),
      m_isSettled(std::move(isSettled)),
      m_path(path),
      m_maxWaitSeconds(maxWaitSeconds) {
  m_elapsed.start();
  m_timer.setInterval(checkMilliseconds);
  connect(&m_timer, &QTimer::timeout, this, &Screenshot::check);
  m_timer.start();
}

void Screenshot::check() {
  m_settledChecks = m_isSettled() ? m_settledChecks + 1 : 0;
  const bool late = double(m_elapsed.elapsed()) > 1000 * m_maxWaitSeconds;
  if (m_settledChecks < neededChecks && !late) return;
  m_timer.stop();
  const int quality = m_path.endsWith(".jpg") ? 90 : -1;  // -1: that of the format
  const bool saved = m_window.grab().save(m_path, nullptr, quality);
  if (!saved) QTextStream(stderr) << tr("gonio: cannot write %1\n").arg(m_path);
  QApplication::exit(saved ? 0 : 1);
}

}  // namespace gonio::app

#include "moc_screenshot.cpp"
