// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/support/system.h"

#include <fcntl.h>
#include <semaphore.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gonio::system {

namespace {

namespace fs = std::filesystem;

std::error_code lastError() { return {errno, std::generic_category()}; }

/// Of a call that returns -1 if it fails.
std::error_code errorOf(int result) { return result == 0 ? std::error_code() : lastError(); }

fs::path folderVariable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

File::~File() { close(); }

std::error_code File::openForReading(const fs::path& path) {
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  return isOpen() ? std::error_code() : lastError();
}

std::error_code File::createUnique(const fs::path& prefix, fs::path& name) {
  std::string text = prefix.string() + ".XXXXXX";
  descriptor_ = ::mkstemp(text.data());
  if (!isOpen()) return lastError();
  name = text;
  return {};
}

bool File::isRegular(std::uint64_t& size) const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return false;
  size = std::uint64_t(status.st_size);
  return true;
}

std::error_code File::readAt(std::uint64_t offset, std::span<std::byte> target, std::size_t& count) const {
  for (;;) {
    const ssize_t read = ::pread(descriptor_, target.data(), target.size(), off_t(offset));
    if (read < 0 && errno == EINTR) continue;
    if (read < 0) return lastError();
    count = std::size_t(read);
    return {};
  }
}

std::error_code File::writeAt(std::uint64_t offset, std::span<const std::byte> content) {
  while (!content.empty()) {
    const ssize_t count = ::pwrite(descriptor_, content.data(), content.size(), off_t(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return lastError();
    content = content.subspan(std::size_t(count));
    offset += std::uint64_t(count);
  }
  return {};
}

std::error_code File::flush() { return errorOf(::fsync(descriptor_)); }

std::error_code File::close() {
  if (!isOpen()) return {};
  const int result = ::close(descriptor_);
  descriptor_ = -1;
  return errorOf(result);
}

void removeWhileOpen(const fs::path& name) { ::unlink(name.c_str()); }

void flushFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

fs::perms permissionsOfNewFiles() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return fs::perms(0666 & ~mask);
}

void reportTooLargeFiles() { std::signal(SIGXFSZ, SIG_IGN); }

void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int most = 256 << 20;
  mallopt(M_TRIM_THRESHOLD, most);
  mallopt(M_MMAP_THRESHOLD, most);
#endif
}

void lowerThreadPriority() {
#ifdef __linux__
  // Elsewhere the number names a process, not a thread.
  constexpr int niceness = 5;
  setpriority(PRIO_PROCESS, id_t(gettid()), niceness);
#endif
}

double threadSeconds() {
  timespec time{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0) return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string processorName() {
  std::ifstream facts("/proc/cpuinfo");
  for (std::string line; std::getline(facts, line);)
    if (line.starts_with("model name"))
      if (const auto at = line.find(": "); at != std::string::npos) return line.substr(at + 2);
  return "unknown processor";
}

std::tm utc(std::time_t time) {
  std::tm result{};
  gmtime_r(&time, &result);
  return result;
}

bool standardErrorIsTerminal() { return isatty(STDERR_FILENO) != 0; }

fs::path cacheFolder() {
  // Relative paths are invalid by the XDG specification.
  if (const fs::path cache = folderVariable("XDG_CACHE_HOME"); cache.is_absolute()) return cache;
  const fs::path home = folderVariable("HOME");
  return home.empty() ? fs::path() : home / ".cache";
}

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
