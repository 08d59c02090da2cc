// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/scratch_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "core/support/error.h"

namespace gonio::io {

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
