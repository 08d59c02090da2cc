// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QApplication>
#include <functional>
#include <optional>
#include <vector>

class QCommandLineParser;

namespace gonio::app {

class MainWindow;

/// The editor with tools for work on Gonio itself: pictures of the editor and of the library (scripts/screenshots.sh,
/// scripts/thumbnails.sh), and times. They are hidden options of the command line (development.cpp lists them), and
/// only in builds with tests.
class DevelopmentApplication : public QApplication {
 public:
  using QApplication::QApplication;

  static void addOptions(QCommandLineParser& parser);
  /// Does what the options ask for. @param openFiles opens the files of the command line. @return the exit code of the
  /// program; nullopt if no option is set: this is a usual run.
  std::optional<int> run(const QCommandLineParser& parser, const std::function<void(MainWindow& first)>& openFiles);

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
  /// Number of events, number of events longer than 50 ms, and the slowest kinds of events, one per line. The time of
  /// an event includes events sent during its handling. Events that open a menu or a dialog are not counted, but the
  /// events of the menu or dialog are.
  QString eventTimes() const;

  bool m_timing = false;
  std::vector<Handled> m_stack;
  qint64 m_events = 0;
  std::vector<Long> m_long;
};

}  // namespace gonio::app
