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

#include "core/io/exr_header_check.h"
#include "core/support/error.h"
#include "core/support/plain_text.h"

namespace gonio::io {

namespace {

/// OpenEXR allocates whole tiles, of any size that a header says.
constexpr int maxTileSide = 2048;

class MemoryInput final : public Imf::IStream {
 public:
  explicit MemoryInput(std::span<const std::byte> bytes) : IStream("memory"), bytes_(bytes) {}

  bool read(char target[], int count) override {
    if (count < 0 || std::uint64_t(count) > bytes_.size() - position_)
      throw Error("the image ends at byte " + std::to_string(bytes_.size()) + ", expected " + std::to_string(count) +
                  " bytes from byte " + std::to_string(position_));
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
      throw Error("found the channel " + colour + " with fewer samples than pixels, expected one per pixel");
  }
  return colours;
}

/// Describes where OpenEXR finds (or puts) pixel (0, 0) of interleaved floats: its data window may start anywhere.
Imf::Slice slice(float* first, std::size_t stride, const Imath::Box2i& window, int width) {
  return Imf::Slice::Make(Imf::FLOAT, first, window, stride, stride * std::size_t(width));
}

Image decode(std::span<const std::byte> bytes) {
  checkExrHeader(bytes);
  MemoryInput stream(bytes);
  Imf::InputFile file(stream);
  const Imath::Box2i window = file.header().dataWindow();
  const std::array<std::string, 3> colours = colourChannels(file.header().channels());

  Image image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
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
  for (const auto& [name, text] : attributes) header.insert(name, Imf::StringAttribute(plainText(text)));
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
  static std::once_flag limitSet;
  std::call_once(limitSet, [] { Imf::Header::setMaxTileSize(maxTileSide, maxTileSide); });
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

}  // namespace gonio::io
