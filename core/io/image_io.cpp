// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/image_io.h"

#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include "core/io/atomic_file.h"
#include "core/io/byte_source.h"
#include "core/io/exr_codec.h"
#include "core/io/hdr_codec.h"
#include "core/support/error.h"

namespace gonio::io {

namespace {

void checkShape(bool matches, int width, int height) {
  if (!matches || width < 1 || height < 1)
    throw Error("an image of " + std::to_string(width) + " x " + std::to_string(height) +
                " pixels cannot be written: expected at least one pixel, and as many values as the size requires");
}

}  // namespace

ImageFile readImageFile(std::span<const std::byte> bytes) {
  if (isExr(bytes)) return decodeExr(bytes);
  if (isHdr(bytes)) return decodeHdr(bytes);
  throw Error("found neither the signature of OpenEXR nor that of Radiance HDR, expected one of these formats");
}

ImageFile readImageFile(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return readImageFile(FileSource(path).readAll()); });
}

Image readImage(std::span<const std::byte> bytes) { return readImageFile(bytes).image; }

Image readImage(const std::filesystem::path& path) { return readImageFile(path).image; }

void writeExr(const Image& image, const std::filesystem::path& path,
              const std::map<std::string, std::string>& attributes) {
  const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  const std::vector<std::byte> bytes = withFileInErrors(path, [&] {
    checkShape(image.pixels.size() == count && (image.alpha.empty() || image.alpha.size() == count), image.width,
               image.height);
    return encodeExr(image, attributes);
  });
  writeFileAtomically(path, bytes);
}

std::vector<std::byte> encodePng(const std::vector<unsigned char>& rgba, int width, int height) {
  std::vector<std::byte> bytes;
  checkShape(rgba.size() == std::size_t(width) * std::size_t(height) * 4, width, height);
  const auto collect = [](void* user, void* data, int count) {
    const std::span added(static_cast<const std::byte*>(data), std::size_t(count));
    auto& target = *static_cast<std::vector<std::byte>*>(user);
    target.insert(target.end(), added.begin(), added.end());
  };
  if (!stbi_write_png_to_func(collect, &bytes, width, height, 4, rgba.data(), 4 * width))
    throw Error("the PNG encoder ran out of memory");
  return bytes;
}

void writePng(const std::vector<unsigned char>& rgba, int width, int height, const std::filesystem::path& path) {
  writeFileAtomically(path, withFileInErrors(path, [&] { return encodePng(rgba, width, height); }));
}

}  // namespace gonio::io
