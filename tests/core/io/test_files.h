// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <turbojpeg.h>

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/support/error.h"

/// What the tests of the readers share: bytes, files in the test output folder, error texts.
namespace gonio::test {

using Bytes = std::vector<std::byte>;

template <typename T>
void append(Bytes& bytes, const T& value) {
  bytes.resize(bytes.size() + sizeof(T));
  std::memcpy(bytes.data() + bytes.size() - sizeof(T), &value, sizeof(T));
}

/// @param rgb width x height x 3 values.
inline Bytes jpegFile(const std::vector<unsigned char>& rgb, int width, int height) {
  constexpr int quality = 95;
  const std::unique_ptr<void, int (*)(void*)> encoder(tjInitCompress(), tjDestroy);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  if (tjCompress2(encoder.get(), rgb.data(), width, 0, height, TJPF_RGB, &buffer, &size, TJSAMP_444, quality, 0) != 0)
    throw Error(tjGetErrorStr2(encoder.get()));
  const std::unique_ptr<unsigned char, void (*)(unsigned char*)> jpeg(buffer, tjFree);
  return {reinterpret_cast<const std::byte*>(buffer), reinterpret_cast<const std::byte*>(buffer) + size};
}

/// A file of the test output folder; its folders are made.
inline std::filesystem::path outputPath(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(GONIO_TEST_OUTPUT_DIR) / name;
  std::filesystem::create_directories(path.parent_path());
  return path;
}

/// An empty folder of the test output: what an earlier run left is removed.
inline std::filesystem::path emptyFolder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(GONIO_TEST_OUTPUT_DIR) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::filesystem::path writeFile(const std::string& name, std::span<const std::byte> bytes) {
  const std::filesystem::path path = outputPath(name);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return path;
}

inline Bytes readFile(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::span<const std::byte> bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// The text of the Error that `work` throws, or "" when it throws none.
template <typename Work>
std::string errorOf(Work work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace gonio::test
