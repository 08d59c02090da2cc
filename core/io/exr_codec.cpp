// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/exr_codec.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>

#include "core/support/error.h"

namespace gonio::io {

namespace {

constexpr int maxSide = 32768;
constexpr long long maxPixels = 1LL << 27;
/// A constant picture in the densest codec stays below: each chunk of at most 256 rows has a header and an entry.
constexpr std::size_t maxExrPixelsPerByte = 16384;

class MemoryInput final : public Imf::IStream {
 public:
  explicit MemoryInput(std::span<const std::byte> bytes) : IStream("memory"), bytes_(bytes) {}

  bool read(char target[], int count) override {
    if (count < 0 || std::uint64_t(count) > bytes_.size() - position_)
      throw Error("the picture ends at byte " + std::to_string(bytes_.size()) + ", expected more");
    std::memcpy(target, bytes_.data() + position_, std::size_t(count));
    position_ += std::uint64_t(count);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = std::min<std::uint64_t>(position, bytes_.size()); }

 private:
  std::span<const std::byte> bytes_;
  std::uint64_t position_ = 0;
};

class MemoryOutput final : public Imf::OStream {
 public:
  MemoryOutput() : OStream("memory") {}

  void write(const char source[], int count) override {
    if (position_ + std::size_t(count) > bytes_.size()) bytes_.resize(position_ + std::size_t(count));
    std::memcpy(bytes_.data() + position_, source, std::size_t(count));
    position_ += std::size_t(count);
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
};

/// OpenEXR allocates what an attribute says it takes before it looks for its bytes. This walks the attributes of all
/// headers first: name, type, int32 size, value; an empty name ends a header, and an empty header those of many parts.
void checkAttributeSizes(std::span<const std::byte> bytes) {
  constexpr std::uint32_t manyPartsFlag = 0x1000;
  std::size_t at = 2 * sizeof(std::uint32_t);
  const auto fail = [&](const std::string& found) {
    throw Error("found " + found + " at byte " + std::to_string(at) + " of " + std::to_string(bytes.size()) +
                ", expected a whole OpenEXR header");
  };
  const auto number = [&](std::size_t offset) {
    std::uint32_t value = 0;
    if (offset + sizeof value > bytes.size()) fail("the end");
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
  };
  const auto skipText = [&] {
    const auto end = std::find(bytes.begin() + std::ptrdiff_t(std::min(at, bytes.size())), bytes.end(), std::byte{0});
    if (end == bytes.end()) fail("a name without an end");
    const bool empty = std::size_t(end - bytes.begin()) == at;
    at = std::size_t(end - bytes.begin()) + 1;
    return !empty;
  };
  const bool manyParts = number(sizeof(std::uint32_t)) & manyPartsFlag;
  for (bool anyAttribute = true; anyAttribute;) {
    anyAttribute = false;
    while (skipText()) {
      anyAttribute = manyParts;
      skipText();
      const std::uint32_t size = number(at);
      at += sizeof size;
      if (size > bytes.size() - at) fail("an attribute of " + std::to_string(size) + " bytes");
      at += size;
    }
  }
}

/// Names of the channels for red, green, blue; all three the luminance where there is nothing else.
std::array<std::string, 3> colourChannels(const Imf::ChannelList& channels) {
  std::string names;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel)
    names += std::string(names.empty() ? "" : ", ") + channel.name();
  std::array<std::string, 3> colours{"R", "G", "B"};
  if (!channels.findChannel("R") && channels.findChannel("Y")) colours.fill("Y");
  for (const std::string& colour : colours) {
    const Imf::Channel* channel = channels.findChannel(colour);
    if (!channel) throw Error("found the channels " + names + ", expected R, G, B or Y");
    if (channel->xSampling != 1 || channel->ySampling != 1)
      throw Error("found the channel " + colour + " with fewer samples than pixels, expected one a pixel");
  }
  return colours;
}

/// Describes where OpenEXR finds (or puts) pixel (0, 0) of interleaved floats: its data window may start anywhere.
Imf::Slice slice(float* first, std::size_t stride, const Imath::Box2i& window, int width) {
  return Imf::Slice::Make(Imf::FLOAT, first, window, stride, stride * std::size_t(width));
}

Image decode(std::span<const std::byte> bytes) {
  checkAttributeSizes(bytes);
  MemoryInput stream(bytes);
  Imf::InputFile file(stream);
  const Imath::Box2i window = file.header().dataWindow();
  const long long width = 1LL + window.max.x - window.min.x, height = 1LL + window.max.y - window.min.y;
  checkImageSize(width, height, bytes.size(), maxExrPixelsPerByte);
  const std::array<std::string, 3> colours = colourChannels(file.header().channels());

  Image image(static_cast<int>(width), static_cast<int>(height));
  // One channel can fill only one slice of a frame buffer: a luminance is read once and copied.
  const bool grey = colours[0] == colours[1];
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < (grey ? 1 : colours.size()); ++i)
    frame.insert(colours[i], slice(&image.pixels[0].x + i, sizeof(glm::vec3), window, image.width));
  if (file.header().channels().findChannel("A")) {
    image.alpha.resize(image.pixels.size());
    frame.insert("A", slice(image.alpha.data(), sizeof(float), window, image.width));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  if (grey)
    for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(pixel.x);
  return image;
}

std::vector<std::byte> encode(const Image& image, const std::map<std::string, std::string>& attributes) {
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, text] : attributes) header.insert(name, Imf::StringAttribute(text));
  Imf::FrameBuffer frame;
  const Imath::Box2i window = header.dataWindow();
  // OpenEXR's slices are not const, though writing only reads them.
  float* pixels = const_cast<float*>(&image.pixels[0].x);
  constexpr const char* colours[] = {"R", "G", "B"};
  for (int i = 0; i < 3; ++i) {
    header.channels().insert(colours[i], Imf::Channel(Imf::FLOAT));
    frame.insert(colours[i], slice(pixels + i, sizeof(glm::vec3), window, image.width));
  }
  if (!image.alpha.empty()) {
    header.channels().insert("A", Imf::Channel(Imf::FLOAT));
    frame.insert("A", slice(const_cast<float*>(image.alpha.data()), sizeof(float), window, image.width));
  }
  MemoryOutput stream;
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    file.writePixels(image.height);
  }
  return stream.take();
}

/// Runs work that may throw OpenEXR's exceptions (all derive from std::exception).
template <typename Work>
auto translatingErrors(Work work) {
  // OpenEXR checks these limits itself while it reads a header, before it allocates its tables.
  static std::once_flag limitsSet;
  std::call_once(limitsSet, [] {
    Imf::Header::setMaxImageSize(maxSide, maxSide);
    Imf::Header::setMaxTileSize(maxSide, maxSide);
  });
  try {
    return work();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& exception) {
    throw Error(std::string("OpenEXR: ") + exception.what());
  }
}

}  // namespace

bool isExr(std::span<const std::byte> bytes) {
  constexpr unsigned char magic[] = {0x76, 0x2f, 0x31, 0x01};
  return bytes.size() >= sizeof magic && std::memcmp(bytes.data(), magic, sizeof magic) == 0;
}

Image decodeExr(std::span<const std::byte> bytes) {
  return translatingErrors([&] { return decode(bytes); });
}

std::vector<std::byte> encodeExr(const Image& image, const std::map<std::string, std::string>& attributes) {
  return translatingErrors([&] { return encode(image, attributes); });
}

void checkImageSize(long long width, long long height, std::size_t fileBytes, std::size_t maxPixelsPerByte) {
  const std::string size = "found a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width < 1 || height < 1 || width > maxSide || height > maxSide || width * height > maxPixels)
    throw Error(size + ", expected 1 to " + std::to_string(maxSide) + " a side and at most " +
                std::to_string(maxPixels) + " in all");
  if (std::size_t(width * height) / maxPixelsPerByte > fileBytes)
    throw Error(size + " in " + std::to_string(fileBytes) + " bytes, expected a longer file");
}

}  // namespace gonio::io
