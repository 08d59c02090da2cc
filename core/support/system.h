// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <system_error>
#include <thread>

/// What Gonio asks of the operating system and the standard library of C++ does not have: files by offset, the priority
/// of a thread, memory, terminals, the processor, folders of the user, signals. system.cpp alone knows POSIX (the test
/// `layers` checks it), so a port to another system writes this file anew.
namespace gonio::system {

/// An open file, closed with the object. Functions return the system's error, or one that is false.
class File {
 public:
  File() = default;
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// For reading. Opening a pipe or a device does not wait for its other end.
  std::error_code openForReading(const std::filesystem::path& path);
  /// Creates a file for reading and writing, whose name is `prefix`, a dot and six characters, and which only this user
  /// may read. Sets `name` to it.
  std::error_code createUnique(const std::filesystem::path& prefix, std::filesystem::path& name);

  bool isOpen() const { return descriptor_ >= 0; }
  /// Whether it is a file with bytes at offsets: no folder, device, pipe or socket. Sets `size` to its bytes.
  bool isRegular(std::uint64_t& size) const;
  /// At most `target.size()` bytes. Sets `count` to how many were read, 0 at the end of the file. From any thread.
  std::error_code readAt(std::uint64_t offset, std::span<std::byte> target, std::size_t& count) const;
  /// All bytes. From any thread.
  std::error_code writeAt(std::uint64_t offset, std::span<const std::byte> content);
  /// Waits until the disk has what was written.
  std::error_code flush();
  /// The error of writing that some file systems report only here.
  std::error_code close();

 private:
  int descriptor_ = -1;
};

/// Removes the directory entry of a file that was created by File::createUnique() and stays open: it vanishes when it
/// is closed, even if the program is killed.
void removeWhileOpen(const std::filesystem::path& name);

/// Makes the names in a folder survive a power failure. Not every file system can: no error.
void flushFolder(const std::filesystem::path& folder);

/// The permissions that this process gives to new files.
std::filesystem::perms permissionsOfNewFiles();

/// Writing beyond the limit of the size of files (`ulimit -f`) becomes an error of writing, not the end of the program.
void reportTooLargeFiles();

/// Freed memory below 256 MB stays with the process for its next allocations, since the system clears each page that it
/// gives out. For programs that end when their work is done. No effect where the allocator has no such settings.
void keepFreedMemory();

/// The calling thread gets about a quarter of the time of a normal thread where others want to run: with idle priority
/// it would never run on a busy machine. No effect where the system has no priorities of threads.
void lowerThreadPriority();

/// Seconds that the processor has spent on this thread, so that other work on the machine does not count; of the clock
/// on the wall where the system does not tell.
double threadSeconds();

/// Such as "AMD EPYC 7B13"; "unknown processor" where the system does not tell.
std::string processorName();

/// A time in UTC.
std::tm utc(std::time_t time);

/// Whether standard error is a terminal, which interprets escape sequences.
bool standardErrorIsTerminal();

/// The folder for data of this user's programs that can be made again ($XDG_CACHE_HOME, else ~/.cache); empty if there
/// is none.
std::filesystem::path cacheFolder();

/// While it exists, the first SIGINT, SIGTERM or SIGHUP asks the work to stop, so that no temporary file remains.
/// Another one ends the program at once; within half a second it counts as the same request. Signals that the parent
/// process ignores (`nohup`) stay ignored. Only one instance may exist in a process.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  std::stop_token token() const { return stop_.get_token(); }

 private:
  void watch(const std::stop_token& end);

  std::stop_source stop_;
  std::jthread watcher_;
};

/// Ends the process by the signal that requested the stop, as its parent expects of an interrupted program (a shell
/// then ends its loop, too). Without a signal it returns. No StopOnSignal may exist.
void endByReceivedSignal();

}  // namespace gonio::system
