// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QString>
#include <vector>

namespace gonio::app {

/// An application that can measure for how long each event blocks the GUI thread. The time of an event includes events
/// sent during its handling. Events that open a menu or a dialog are not counted, but the events of the menu or dialog
/// are.
class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  /// Starts timing.
  void startTiming() { m_timing = true; }
  /// Number of events, number of events longer than 50 ms, and the slowest kinds of events, one per line.
  [[nodiscard]] QString eventTimes() const;

  bool notify(QObject* receiver, QEvent* event) override;

 private:
  /// An event that is being handled.
  struct Handled {
    int loopLevel;
    bool hasNestedLoop;
  };
  struct Long {
    QString what;
    qint64 nanoseconds;
  };

  bool timed(QObject* receiver, QEvent* event);

  bool m_timing = false;
  std::vector<Handled> m_stack;
  qint64 m_events = 0;
  std::vector<Long> m_long;
};

}  // namespace gonio::app
