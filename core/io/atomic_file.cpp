// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <list>
#include <utility>
#include <vector>

#include "core/support/error.h"

namespace gonio::io {

namespace {

namespace fs = std::filesystem;

/// For mkstemp().
std::string unusedName(const fs::path& target) { return target.string() + ".XXXXXX"; }

/// A temporary file that is removed again unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) : target_(target), name_(unusedName(target)) {
    descriptor_ = ::mkstemp(name_.data());
    if (descriptor_ < 0) fail();
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::span<const std::byte> content) {
    while (!content.empty()) {
      const ssize_t count = ::write(descriptor_, content.data(), content.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      content = content.subspan(static_cast<std::size_t>(count));
    }
  }

  void flush() {
    if (::fchmod(descriptor_, targetMode()) != 0 || ::fsync(descriptor_) != 0) fail();
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail();
  }

  void replaceTarget() {
    if (::rename(name_.c_str(), target_.c_str()) != 0) fail();
    renamed_ = true;
  }

 private:
  [[noreturn]] void fail() const { throw Error(target_.string() + ": cannot be written: " + std::strerror(errno)); }

  /// The mode of the file that is replaced, or what the process gives new files (mkstemp would leave them private).
  mode_t targetMode() const {
    struct stat status {};
    if (::stat(target_.c_str(), &status) == 0) return status.st_mode & 0777;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
  }

  fs::path target_;
  std::string name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

/// A file that is about to be replaced. It has a second name as long as this object exists, where the file system has
/// hard links.
class OldFile {
 public:
  explicit OldFile(fs::path target) : target_(std::move(target)) {
    struct stat status {};
    existed_ = ::lstat(target_.c_str(), &status) == 0;
    if (!existed_) return;
    std::string name = unusedName(target_);
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0) return;
    ::close(descriptor);
    ::unlink(name.c_str());
    if (::link(target_.c_str(), name.c_str()) == 0) secondName_ = name;
  }
  ~OldFile() {
    if (!secondName_.empty()) ::unlink(secondName_.c_str());
  }
  OldFile(const OldFile&) = delete;
  OldFile& operator=(const OldFile&) = delete;

  const fs::path& target() const { return target_; }
  /// Undoes the replacement. @return false if that is impossible.
  bool restore() {
    if (!existed_) return ::unlink(target_.c_str()) == 0;
    if (secondName_.empty() || ::rename(secondName_.c_str(), target_.c_str()) != 0) return false;
    secondName_.clear();
    return true;
  }

 private:
  fs::path target_;
  bool existed_ = false;
  std::string secondName_;
};

/// Makes the rename itself survive a power failure. Not every file system can: no error.
void flushFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

/// The file that is replaced: through a link the one that it points to, not the link.
fs::path targetOf(const fs::path& path) {
  if (path.native().find('\0') != std::string::npos)
    throw Error(std::string(path.c_str()) + ": cannot be written: found a NUL character in the path");
  std::error_code ignored;
  fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
  const auto refuse = [&](const char* found) {
    throw Error(path.string() + ": cannot be written: found " + found + ", expected the name of a file");
  };
  if (target.filename().empty() || fs::is_directory(target, ignored)) refuse("a folder");
  // Renaming would replace /dev/null itself.
  if (fs::is_other(target, ignored)) refuse("a device, a pipe or a socket");
  return target;
}

/// @throws Error that extends `cause`, if a file cannot be restored.
void restoreAll(std::list<OldFile>& replaced, const Error& cause) {
  std::string lost;
  for (OldFile& file : replaced)
    if (!file.restore()) lost += (lost.empty() ? "" : ", ") + file.target().string();
  if (!lost.empty()) throw Error(std::string(cause.what()) + "; already replaced: " + lost);
}

}  // namespace

void checkWritable(const fs::path& path) { TemporaryFile(targetOf(path)); }

bool isOneOf(const fs::path& path, std::span<const fs::path> files) {
  std::error_code ignored;
  return std::ranges::any_of(files, [&](const fs::path& file) { return fs::equivalent(path, file, ignored); });
}

void writeFileAtomically(const fs::path& path, std::span<const std::byte> content) {
  const FileContent file{path, content};
  writeFilesAtomically(std::span(&file, 1));
}

void writeFilesAtomically(std::span<const FileContent> files) {
  std::list<TemporaryFile> written;
  std::vector<fs::path> targets;
  for (const FileContent& file : files) {
    targets.push_back(targetOf(file.path));
    written.emplace_back(targets.back());
    written.back().write(file.content);
    written.back().flush();
  }
  std::list<OldFile> replaced;
  try {
    for (TemporaryFile& file : written) {
      // A single file needs no second name: nothing can fail after its rename.
      if (targets.size() > 1) replaced.emplace_back(targets[replaced.size()]);
      file.replaceTarget();
    }
  } catch (const Error& error) {
    if (!replaced.empty()) replaced.pop_back();  // the one that failed is as it was
    restoreAll(replaced, error);
    throw;
  }
  for (const fs::path& target : targets) flushFolder(target.parent_path());
}

void writeFileAtomically(const fs::path& path, const std::string& text) {
  writeFileAtomically(path, std::as_bytes(std::span(text)));
}

ScratchFile::ScratchFile(const std::filesystem::path& folder, std::uint64_t bytes) : folder_(folder) {
  std::error_code unknown;
  const auto space = std::filesystem::space(folder, unknown);
  if (!unknown && space.available < bytes)
    throw Error(folder.string() + ": a temporary file of " + std::to_string(bytes / 1'000'000) +
                " MB is needed here, and the folder has " + std::to_string(space.available / 1'000'000) +
                " MB of free space; set the environment variable TMPDIR to use another folder");
  std::string name = (folder / "gonio.XXXXXX").string();
  descriptor_ = ::mkstemp(name.data());
  if (descriptor_ < 0) fail("cannot be created");
  ::unlink(name.c_str());
}

ScratchFile::~ScratchFile() { ::close(descriptor_); }

void ScratchFile::write(std::uint64_t offset, std::span<const float> values) {
  auto bytes = std::as_bytes(values);
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(descriptor_, bytes.data(), bytes.size(), off_t(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("cannot be written");
    bytes = bytes.subspan(std::size_t(count));
    offset += std::uint64_t(count);
  }
}

void ScratchFile::read(std::uint64_t offset, std::span<float> values) const {
  auto bytes = std::as_writable_bytes(values);
  while (!bytes.empty()) {
    const ssize_t count = ::pread(descriptor_, bytes.data(), bytes.size(), off_t(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count == 0) errno = ENODATA;
    if (count <= 0) fail("cannot be read");
    bytes = bytes.subspan(std::size_t(count));
    offset += std::uint64_t(count);
  }
}

void ScratchFile::fail(const char* what) const {
  throw Error(folder_.string() + ": a temporary file " + what + ": " + std::strerror(errno));
}

}  // namespace gonio::io
