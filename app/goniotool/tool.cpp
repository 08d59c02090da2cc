// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/tool.h"

#include <cstdio>
#include <memory>

#include "core/support/system.h"

namespace gonio::tool {

void eraseProgress() {
  if (system::standardErrorIsTerminal()) std::fputs("\r\033[K", stderr);
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TaskControl Tool::control(const std::string& what) const {
  const bool isTerminal = system::standardErrorIsTerminal();
  if (!showProgress && !isTerminal) return {stop, {}};
  const auto last = std::make_shared<int>(-1);
  return {stop, [=](double fraction) {
            const int percent = static_cast<int>(fraction * 100);
            // A log gets a line every 5 %.
            if (percent <= *last || (!isTerminal && percent < 100 && percent < *last + 5)) return;
            *last = percent;
            if (isTerminal && percent >= 100)
              eraseProgress();
            else
              std::fprintf(stderr, isTerminal ? "\r%s %d %%" : "%s %d %%\n", what.c_str(), percent);
          }};
}

}  // namespace gonio::tool
