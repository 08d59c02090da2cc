// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QProcess>

namespace gonio::test {

/// A QProcess that is started by fork(): the thread sanitizer ends a program that uses vfork(), as QProcess does where
/// nothing is to be done in the child before the program starts.
class ChildProcess : public QProcess {
 public:
  ChildProcess() {
    setChildProcessModifier([] {});
  }

  /// Runs a program to its end and returns its exit code; -1 if it does not start or crashes.
  static int execute(const QString& program, const QStringList& arguments) {
    ChildProcess process;
    process.setProcessChannelMode(QProcess::ForwardedChannels);
    process.start(program, arguments);
    return process.waitForFinished(-1) && process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
  }
};

}  // namespace gonio::test
