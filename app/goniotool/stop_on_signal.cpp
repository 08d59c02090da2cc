// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/stop_on_signal.h"

#include <semaphore.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>

namespace gonio::tool {

namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

std::atomic<int> received = 0;
sem_t wakeUp;

extern "C" void receive(int signal) {
  const int before = errno;
  received = signal;
  sem_post(&wakeUp);
  errno = before;
}

void setHandlers() {
  for (const int signal : signals) {
    struct sigaction current {};
    if (::sigaction(signal, nullptr, &current) != 0 || current.sa_handler == SIG_IGN) continue;
    struct sigaction next {};
    next.sa_handler = receive;
    // The second signal ends the program.
    next.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    ::sigaction(signal, &next, nullptr);
  }
}

}  // namespace

StopOnSignal::StopOnSignal() {
  ::sem_init(&wakeUp, 0, 0);
  watcher_ = std::jthread([this](const std::stop_token& end) { watch(end); });
  setHandlers();
}

// The handlers stay: a first signal while the program ends is too late to stop any work.
StopOnSignal::~StopOnSignal() {
  watcher_.request_stop();
  ::sem_post(&wakeUp);
}

void StopOnSignal::watch(const std::stop_token& end) {
  while (!end.stop_requested()) {
    if (::sem_wait(&wakeUp) == 0 && received != 0) stop_.request_stop();
  }
}

void endByReceivedSignal() {
  if (received != 0) ::raise(received);
}

}  // namespace gonio::tool
