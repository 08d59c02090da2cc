// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/image_io.h"

#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#define STBI_NO_STDIO
#include <stb/stb_image.h>

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

/// Whether a JPEG file has its end marker, without which stb reads zeros. Segments before the scan are passed over:
/// thumbnails in them have such markers of their own.
bool reachesItsEnd(std::span<const std::byte> jpeg) {
  constexpr unsigned marker = 0xff, startOfScan = 0xda, endOfImage = 0xd9;
  const auto at = [&](std::size_t i) { return std::to_integer<unsigned>(jpeg[i]); };
  std::size_t i = 2;
  while (i + 4 <= jpeg.size() && at(i) == marker && at(i + 1) != startOfScan)
    i += at(i + 1) == marker ? 1 : 2 + (at(i + 2) << 8 | at(i + 3));
  for (; i + 2 <= jpeg.size(); ++i)
    if (at(i) == marker && at(i + 1) == endOfImage) return true;
  return false;
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

Image readEncodedImage(std::span<const std::byte> bytes) {
  constexpr std::size_t maxPixelsPerByte = 16384;  // deflate shrinks to a thousandth; eight pixels of one bit a byte
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  if (bytes.size() > std::size_t(std::numeric_limits<int>::max()))
    throw Error("found more than 2 GB, expected an image");
  const int size = int(bytes.size());
  const bool isJpeg = size > 2 && data[0] == 0xff && data[1] == 0xd8;
  if (isJpeg && !reachesItsEnd(bytes)) throw Error("found a JPEG image without its end, expected a whole one");
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) failEncoded();
  checkImageSize(width, height, bytes.size(), maxPixelsPerByte);
  const std::unique_ptr<stbi_us, void (*)(void*)> values(
      stbi_load_16_from_memory(data, size, &width, &height, &channels, 3), stbi_image_free);
  if (!values) failEncoded();
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      image.pixels[i][channel] = float(values.get()[3 * i + std::size_t(channel)]) / 65535.0f;
  return image;
}

Image readEncodedImage(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return readEncodedImage(FileSource(path).readAll()); });
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
