// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/interrupt.h"

#include <atomic>
#include <chrono>
#include <csignal>

namespace gonio::tool {

namespace {
std::atomic<bool> interrupted = false;
}

StopOnInterrupt::StopOnInterrupt() : watcher_([this](const std::stop_token& end) { watch(end); }) {
  std::signal(SIGINT, [](int) {
    interrupted = true;
    std::signal(SIGINT, SIG_DFL);
  });
}

StopOnInterrupt::~StopOnInterrupt() { std::signal(SIGINT, SIG_DFL); }

void StopOnInterrupt::watch(const std::stop_token& end) {
  while (!end.stop_requested()) {
    if (interrupted) stop_.request_stop();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

}  // namespace gonio::tool
