// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QString>
#include <vector>

namespace gonio::app {

/// The application, which can time its events: how long each kept the window from answering the next. An event includes
/// what it sends at once; one that opens a menu or a dialog is not counted, those of the menu are.
class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  /// From here on events are timed.
  void startTiming() { m_timing = true; }
  /// How many events there were, how many took longer than 50 ms, and the longest kinds, one per line.
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
