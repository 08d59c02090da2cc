// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/atomic_file.h"

#include <algorithm>
#include <list>
#include <utility>
#include <vector>

#include "core/support/error.h"

namespace gonio::io {

namespace {

namespace fs = std::filesystem;

/// A temporary file that is removed again unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) : target_(target) { check(file_.createUnique(target, name_)); }
  ~TemporaryFile() {
    std::error_code ignored;
    if (!renamed_ && !name_.empty()) fs::remove(name_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::span<const std::byte> content) { check(file_.writeAt(0, content)); }

  void flush() {
    std::error_code error;
    fs::permissions(name_, targetPermissions(), error);
    check(error);
    check(file_.flush());
    check(file_.close());
  }

  void replaceTarget() {
    std::error_code error;
    fs::rename(name_, target_, error);
    check(error);
    renamed_ = true;
  }

 private:
  void check(const std::error_code& error) const {
    if (error) throw Error(target_.string() + ": cannot be written: " + error.message());
  }

  /// Those of the file that is replaced, or what the process gives new files: this one is private.
  fs::perms targetPermissions() const {
    std::error_code error;
    const fs::file_status status = fs::status(target_, error);
    return fs::exists(status) ? status.permissions() & fs::perms::all : system::permissionsOfNewFiles();
  }

  fs::path target_;
  fs::path name_;
  system::File file_;
  bool renamed_ = false;
};

/// A file that is about to be replaced. It has a second name as long as this object exists, where the file system has
/// hard links.
class OldFile {
 public:
  explicit OldFile(fs::path target) : target_(std::move(target)) {
    std::error_code failed;
    existed_ = fs::exists(fs::symlink_status(target_, failed));
    if (!existed_) return;
    system::File unused;
    fs::path name;
    if (unused.createUnique(target_, name)) return;
    system::removeWhileOpen(name);
    fs::create_hard_link(target_, name, failed);
    if (!failed) secondName_ = name;
  }
  ~OldFile() {
    std::error_code ignored;
    if (!secondName_.empty()) fs::remove(secondName_, ignored);
  }
  OldFile(const OldFile&) = delete;
  OldFile& operator=(const OldFile&) = delete;

  const fs::path& target() const { return target_; }
  /// Undoes the replacement. @return false if that is impossible.
  bool restore() {
    std::error_code error;
    if (!existed_) return fs::remove(target_, error);
    if (secondName_.empty()) return false;
    fs::rename(secondName_, target_, error);
    if (error) return false;
    secondName_.clear();
    return true;
  }

 private:
  fs::path target_;
  bool existed_ = false;
  fs::path secondName_;
};

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
  for (const fs::path& target : targets) system::flushFolder(target.parent_path());
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
  std::filesystem::path name;
  if (const auto error = file_.createUnique(folder / "gonio", name)) fail("cannot be created", error);
  system::removeWhileOpen(name);
}

void ScratchFile::write(std::uint64_t offset, std::span<const float> values) {
  if (const auto error = file_.writeAt(offset, std::as_bytes(values))) fail("cannot be written", error);
}

void ScratchFile::read(std::uint64_t offset, std::span<float> values) const {
  auto bytes = std::as_writable_bytes(values);
  while (!bytes.empty()) {
    std::size_t count = 0;
    if (const auto error = file_.readAt(offset, bytes, count)) fail("cannot be read", error);
    if (count == 0) fail("cannot be read", std::make_error_code(std::errc::no_message_available));
    bytes = bytes.subspan(count);
    offset += count;
  }
}

void ScratchFile::fail(const char* what, const std::error_code& reason) const {
  throw Error(folder_.string() + ": a temporary file " + what + ": " + reason.message());
}

}  // namespace gonio::io
