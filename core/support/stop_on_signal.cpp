// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/support/stop_on_signal.h"

#include <semaphore.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>

namespace gonio::system {

namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

// timeout(1) and some shells send a signal to the process and then to its group.
constexpr std::int64_t sameRequestMs = 500;

std::atomic<int> received = 0;
std::atomic<std::int64_t> receivedAt = 0;  // 0: no signal yet
sem_t wakeUp;

/// On a clock that is never 0.
std::int64_t milliseconds() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000 + 1;
}

void endBy(int signal) {
  std::signal(signal, SIG_DFL);
  ::raise(signal);
}

extern "C" void receive(int signal) {
  const int errorBefore = errno;
  const std::int64_t now = milliseconds();
  std::int64_t first = 0;
  if (receivedAt.compare_exchange_strong(first, now)) {
    received = signal;
    ::sem_post(&wakeUp);
  } else if (now - first > sameRequestMs) {
    endBy(signal);
  }
  errno = errorBefore;
}

void setHandlers() {
  for (const int signal : signals) {
    struct sigaction current {};
    if (::sigaction(signal, nullptr, &current) != 0 || current.sa_handler == SIG_IGN) continue;
    struct sigaction next {};
    next.sa_handler = receive;
    next.sa_flags = SA_RESTART;
    ::sigaction(signal, &next, nullptr);
  }
}

}  // namespace

StopOnSignal::StopOnSignal() {
  ::sem_init(&wakeUp, 0, 0);
  watcher_ = std::jthread([this](const std::stop_token& end) { watch(end); });
  setHandlers();
}

// The handlers stay installed: a first signal that arrives while the program exits only decides how it ends.
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
  if (received != 0) endBy(received);
}

}  // namespace gonio::system
