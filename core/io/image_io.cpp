// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/image_io.h"

#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#define STBI_NO_STDIO
#include <stb/stb_image.h>

#include <cstdint>
#include <limits>
#include <memory>

#include "core/io/atomic_file.h"
#include "core/io/byte_source.h"
#include "core/io/exr_codec.h"
#include "core/io/hdr_codec.h"
#include "core/support/error.h"

namespace gonio::io {

namespace {

/// @throws Error that says why stb cannot read the bytes.
[[noreturn]] void failEncoded() {
  throw Error(std::string("found no PNG or JPEG image that can be read (") + stbi_failure_reason() + ")");
}

Image decodeEncoded(std::span<const std::byte> bytes) {
  constexpr std::int64_t mostSide = 32768, mostPixels = std::int64_t(1) << 27;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  if (bytes.size() > std::size_t(std::numeric_limits<int>::max()))
    throw Error("found more than 2 GB, expected an image");
  const int size = int(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) failEncoded();
  if (width > mostSide || height > mostSide || std::int64_t(width) * height > mostPixels)
    throw Error("found " + std::to_string(width) + " x " + std::to_string(height) +
                " pixels, expected at most 32768 per side and 2^27 in total");
  const std::unique_ptr<stbi_us, void (*)(void*)> values(
      stbi_load_16_from_memory(data, size, &width, &height, &channels, 3), stbi_image_free);
  if (!values) failEncoded();
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      image.pixels[i][channel] = float(values.get()[3 * i + std::size_t(channel)]) / 65535.0f;
  return image;
}

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

Image readEncodedImage(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return decodeEncoded(FileSource(path).readAll()); });
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
