// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/image_io.h"

#include <algorithm>
#include <cstring>
#include <memory>

#define STBI_NO_STDIO
#include <stb/stb_image.h>
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include "core/io/atomic_file.h"
#include "core/io/byte_source.h"
#include "core/io/exr_codec.h"
#include "core/support/error.h"

namespace gonio::io {

namespace {

/// Run-length coding stores at best 127 pixels in 8 bytes.
constexpr std::size_t maxHdrPixelsPerByte = 16;
constexpr int stbBufferBytes = 128;

/// Feeds stb, and notices when it wants more than there is: left alone it would go on with zeros, or for ever. What it
/// gets then are run lengths that end its loops.
struct HdrStream {
  std::span<const std::byte> bytes;
  std::size_t position = 0;
  bool endedEarly = false;

  static int read(void* user, char* target, int count) {
    HdrStream& stream = *static_cast<HdrStream*>(user);
    const std::size_t given = std::min(std::size_t(count), stream.bytes.size() - stream.position);
    std::memcpy(target, stream.bytes.data() + stream.position, given);
    stream.position += given;
    // A refill of the buffer may come back short; a pixel may not.
    if (given > 0 && (count == stbBufferBytes || given == std::size_t(count))) return int(given);
    stream.endedEarly = true;
    std::memset(target + given, 0xff, std::size_t(count) - given);
    return count;
  }
  static void skip(void* user, int count) {
    HdrStream& stream = *static_cast<HdrStream*>(user);
    const std::size_t left = stream.bytes.size() - stream.position;
    stream.position += std::min(left, std::size_t(std::max(count, 0)));
  }
  static int atEnd(void* user) {
    const HdrStream& stream = *static_cast<HdrStream*>(user);
    return stream.position >= stream.bytes.size();
  }
};

constexpr stbi_io_callbacks hdrCallbacks = {HdrStream::read, HdrStream::skip, HdrStream::atEnd};

bool isHdr(std::span<const std::byte> bytes) {
  for (const std::string_view signature : {"#?RADIANCE\n", "#?RGBE\n"})
    if (bytes.size() >= signature.size() && std::memcmp(bytes.data(), signature.data(), signature.size()) == 0)
      return true;
  return false;
}

/// Whether the lines of the header, an empty one and the line of the size are all there: stb looks for their ends.
bool hasWholeHeader(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t emptyLine = text.find("\n\n");
  return emptyLine != text.npos && text.find('\n', emptyLine + 2) != text.npos;
}

Image decodeHdr(std::span<const std::byte> bytes) {
  int width = 0, height = 0, channels = 0;
  HdrStream header{bytes};
  if (!hasWholeHeader(bytes) || !stbi_info_from_callbacks(&hdrCallbacks, &header, &width, &height, &channels))
    throw Error("found a Radiance HDR header without '-Y HEIGHT +X WIDTH' and 'FORMAT=32-bit_rle_rgbe', expected both");
  checkImageSize(width, height, bytes.size(), maxHdrPixelsPerByte);
  HdrStream stream{bytes};
  const std::unique_ptr<float, decltype(&stbi_image_free)> pixels(
      stbi_loadf_from_callbacks(&hdrCallbacks, &stream, &width, &height, &channels, 3), stbi_image_free);
  if (stream.endedEarly)
    throw Error("the Radiance HDR image ends at byte " + std::to_string(bytes.size()) + ", before its last line");
  if (!pixels) throw Error(std::string("found a corrupt Radiance HDR image (") + stbi_failure_reason() + ")");
  Image image(width, height);
  std::memcpy(image.pixels.data(), pixels.get(), image.pixels.size() * sizeof(glm::vec3));
  return image;
}

void checkShape(bool matches, int width, int height) {
  if (!matches || width < 1 || height < 1)
    throw Error("an image of " + std::to_string(width) + " x " + std::to_string(height) +
                " pixels cannot be written: expected at least one pixel, and as many values as the size requires");
}

}  // namespace

Image readImage(std::span<const std::byte> bytes) {
  if (isExr(bytes)) return decodeExr(bytes);
  if (isHdr(bytes)) return decodeHdr(bytes);
  throw Error("found neither the signature of OpenEXR nor that of Radiance HDR, expected one of these formats");
}

Image readImage(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return readImage(FileSource(path).readAll()); });
}

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
