// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <unistd.h>

#include <QProcess>
#include <csignal>

#include "tests/app/goniotool/goniotool_runner.h"

namespace gonio::test {

struct Interruption {
  int endedBySignal = 0;  ///< 0: the program returned an exit code
  QString error;          ///< standard error
};

/// Starts goniotool and sends it a signal once its standard error contains `progress`, `times` times in a row.
inline Interruption interrupt(const QStringList& arguments, int signal, const QString& progress, int times = 1) {
  constexpr int patienceMs = 60'000;
  QProcess process;
  // A shell starts commands in the background with SIGINT ignored, and the test program may be one of them.
  process.setChildProcessModifier([signal] { std::signal(signal, SIG_DFL); });
  process.start(GONIO_TOOL, arguments);
  process.setReadChannel(QProcess::StandardError);
  Interruption result;
  while (!result.error.contains(progress) && process.waitForReadyRead(patienceMs))
    result.error += QString::fromUtf8(process.readAllStandardError());
  for (int i = 0; i < times; ++i) {
    if (i > 0) ::usleep(1000);
    ::kill(pid_t(process.processId()), signal);
  }
  if (!process.waitForFinished(patienceMs)) return result;
  result.error += QString::fromUtf8(process.readAllStandardError());
  if (process.exitStatus() == QProcess::CrashExit) result.endedBySignal = process.exitCode();
  return result;
}

}  // namespace gonio::test
