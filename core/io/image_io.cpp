// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/image_io.h"

#include <spng.h>
#include <turbojpeg.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <vector>

#include "core/io/atomic_file.h"
#include "core/io/byte_source.h"
#include "core/io/exr_codec.h"
#include "core/io/hdr_codec.h"
#include "core/support/error.h"

namespace gonio::io {

namespace {

/// Deflate shrinks to a thousandth, and a byte holds eight pixels of one bit; JPEG is less dense.
constexpr std::size_t maxEncodedPixelsPerByte = 16384;

bool isPng(std::span<const std::byte> bytes) {
  constexpr unsigned char magic[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  return bytes.size() >= sizeof magic && std::memcmp(bytes.data(), magic, sizeof magic) == 0;
}

bool isJpeg(std::span<const std::byte> bytes) {
  constexpr unsigned char magic[] = {0xff, 0xd8, 0xff};
  return bytes.size() >= sizeof magic && std::memcmp(bytes.data(), magic, sizeof magic) == 0;
}

/// Values that are stored as `maximum` become 1. @param channels values per pixel, of which the first three count
template <class Value>
Image storedImage(int width, int height, const std::vector<Value>& values, std::size_t channels) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      image.pixels[i][channel] =
          float(values[channels * i + std::size_t(channel)]) / float(std::numeric_limits<Value>::max());
  return image;
}

using Png = std::unique_ptr<spng_ctx, void (*)(spng_ctx*)>;

/// @param flags 0 to read, SPNG_CTX_ENCODER to write.
Png makePng(int flags) {
  Png png(spng_ctx_new(flags), spng_ctx_free);
  if (!png) throw std::bad_alloc();
  return png;
}

void checkPng(int code, const char* what) {
  if (code != 0) throw Error(std::string(what) + " (" + spng_strerror(code) + ")");
}

Image decodePng(std::span<const std::byte> bytes) {
  const char* what = "found a PNG image that cannot be read";
  const Png png = makePng(0);
  checkPng(spng_set_png_buffer(png.get(), bytes.data(), bytes.size()), what);
  spng_ihdr header;
  checkPng(spng_get_ihdr(png.get(), &header), what);
  checkImageSize(header.width, header.height, bytes.size(), maxEncodedPixelsPerByte);
  constexpr std::size_t channels = 4;
  std::vector<std::uint16_t> values(channels * header.width * header.height);
  checkPng(spng_decode_image(png.get(), values.data(), values.size() * sizeof values[0], SPNG_FMT_RGBA16, 0), what);
  return storedImage(int(header.width), int(header.height), values, channels);
}

/// A file that is damaged or cut off is refused too, which the decoder only warns of.
Image decodeJpeg(std::span<const std::byte> bytes) {
  const std::unique_ptr<void, int (*)(void*)> decoder(tjInitDecompress(), tjDestroy);
  if (!decoder) throw std::bad_alloc();
  const auto check = [&](int code) {
    if (code != 0)
      throw Error(std::string("found a JPEG image that cannot be read (") + tjGetErrorStr2(decoder.get()) + ")");
  };
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0, height = 0, sampling = 0, colours = 0;
  check(tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height, &sampling, &colours));
  if (width == 0) throw Error("found a JPEG image that cannot be read (it ends before its pixels)");
  checkImageSize(width, height, bytes.size(), maxEncodedPixelsPerByte);
  constexpr std::size_t channels = 3;
  std::vector<unsigned char> values(channels * std::size_t(width) * std::size_t(height));
  check(tjDecompress2(decoder.get(), data, bytes.size(), values.data(), width, 0, height, TJPF_RGB,
                      TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS));
  return storedImage(width, height, values, channels);
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
  if (isPng(bytes)) return decodePng(bytes);
  if (isJpeg(bytes)) return decodeJpeg(bytes);
  throw Error("found neither the signature of PNG nor that of JPEG, expected one of these formats");
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
  checkShape(rgba.size() == std::size_t(width) * std::size_t(height) * 4, width, height);
  const char* what = "the PNG image cannot be encoded";
  const Png png = makePng(SPNG_CTX_ENCODER);
  spng_ihdr header{};
  header.width = std::uint32_t(width);
  header.height = std::uint32_t(height);
  header.bit_depth = 8;
  header.color_type = SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
  checkPng(spng_set_ihdr(png.get(), &header), what);
  checkPng(spng_set_option(png.get(), SPNG_ENCODE_TO_BUFFER, 1), what);
  checkPng(spng_encode_image(png.get(), rgba.data(), rgba.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE), what);
  std::size_t size = 0;
  int code = 0;
  const std::unique_ptr<void, void (*)(void*)> buffer(spng_get_png_buffer(png.get(), &size, &code), std::free);
  checkPng(code, what);
  const auto* bytes = static_cast<const std::byte*>(buffer.get());
  return {bytes, bytes + size};
}

void writePng(const std::vector<unsigned char>& rgba, int width, int height, const std::filesystem::path& path) {
  writeFileAtomically(path, withFileInErrors(path, [&] { return encodePng(rgba, width, height); }));
}

}  // namespace gonio::io
