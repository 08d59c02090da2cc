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
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::io {

namespace {

constexpr long long maxSide = 32768;
constexpr long long maxPixels = 1LL << 27;
constexpr std::uint64_t maxLineBufferBytes = std::uint64_t(1) << 29;
/// A constant picture in the densest codec stays below: each chunk of at most 256 rows has a header and an entry.
constexpr std::size_t maxExrPixelsPerByte = 16384;
constexpr std::size_t startBytes = 8;  // magic number and version
constexpr std::uint32_t manyPartsFlag = 0x1000;
constexpr std::size_t channelBytes = 16;  // type, linearity, sampling of a channel, after its name

using Bytes = std::span<const std::byte>;

/// The bytes that values of a type have, where that does not vary.
const std::map<std::string_view, std::size_t>& fixedSizes() {
  static const std::map<std::string_view, std::size_t> sizes = {{"box2f", 16},
                                                                {"box2i", 16},
                                                                {"chromaticities", 32},
                                                                {"compression", 1},
                                                                {"deepImageState", 1},
                                                                {"double", 8},
                                                                {"envmap", 1},
                                                                {"float", 4},
                                                                {"int", 4},
                                                                {"keycode", 28},
                                                                {"lineOrder", 1},
                                                                {"m33d", 72},
                                                                {"m33f", 36},
                                                                {"m44d", 128},
                                                                {"m44f", 64},
                                                                {"rational", 8},
                                                                {"tiledesc", 9},
                                                                {"timecode", 8},
                                                                {"v2d", 16},
                                                                {"v2f", 8},
                                                                {"v2i", 8},
                                                                {"v3d", 24},
                                                                {"v3f", 12},
                                                                {"v3i", 12}};
  return sizes;
}

/// Takes values one after another and never beyond the end.
class Cursor {
 public:
  explicit Cursor(Bytes bytes, std::size_t at = 0) : bytes_(bytes), at_(at) {}

  bool atEnd() const { return at_ == bytes_.size(); }
  Bytes take(std::size_t count) {
    if (count > bytes_.size() - at_) fail("a value of " + std::to_string(count) + " bytes");
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }
  std::int32_t number() {
    std::int32_t value = 0;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view text() {
    const std::string_view rest(reinterpret_cast<const char*>(bytes_.data()) + at_, bytes_.size() - at_);
    const std::size_t length = rest.find('\0');
    if (length == rest.npos) fail("a name without a terminating zero");
    at_ += length + 1;
    return rest.substr(0, length);
  }
  [[noreturn]] void fail(const std::string& found) const {
    throw Error("found " + found + " at byte " + std::to_string(at_) + " of " + std::to_string(bytes_.size()) +
                ", expected a whole OpenEXR header");
  }

 private:
  Bytes bytes_;
  std::size_t at_;
};

/// The properties of a file that determine the sizes of the buffers.
struct Layout {
  std::array<std::int32_t, 4> window{};  ///< of the data: min x, min y, max x, max y
  std::size_t channels = 0;
  int compression = 0;

  /// At most: four bytes per sample, one chunk.
  std::uint64_t lineBufferBytes(std::uint64_t width) const {
    constexpr int dwab = 9;
    return width * channels * 4 * (compression == dwab ? 256 : 32);
  }
};

std::size_t countChannels(Bytes value) {
  Cursor cursor(value);
  std::size_t count = 0;
  for (; !cursor.text().empty(); ++count) cursor.take(channelBytes);
  if (!cursor.atEnd()) cursor.fail("bytes after the list of channels");
  return count;
}

/// Throws unless the value has the bytes that a reader of its type takes.
void checkValue(std::string_view type, Bytes value) {
  const auto fixed = fixedSizes().find(type);
  bool matches = fixed == fixedSizes().end() || fixed->second == value.size();
  if (type == "floatvector") matches = value.size() % 4 == 0;
  if (type == "chlist") countChannels(value);
  Cursor cursor(value);
  if (type == "preview") {
    const auto width = std::uint32_t(cursor.number()), height = std::uint32_t(cursor.number());
    matches = width <= maxSide && height <= maxSide && value.size() == 8 + std::uint64_t(width) * height * 4;
  }
  if (type == "stringvector")
    while (!cursor.atEnd()) cursor.take(std::uint32_t(cursor.number()));
  if (!matches) cursor.fail("a value of type " + std::string(type) + " in " + std::to_string(value.size()) + " bytes");
}

void checkLayout(const Layout& layout, std::size_t fileBytes) {
  const long long width = 1LL + layout.window[2] - layout.window[0], height = 1LL + layout.window[3] - layout.window[1];
  checkImageSize(width, height, fileBytes, maxExrPixelsPerByte);
  const std::uint64_t lineBytes = layout.lineBufferBytes(std::uint64_t(width));
  if (lineBytes > maxLineBufferBytes)
    throw Error("found lines of " + std::to_string(width) + " pixels with " + std::to_string(layout.channels) +
                " channels, which need a buffer of " + std::to_string(lineBytes) + " bytes, expected at most " +
                std::to_string(maxLineBufferBytes));
}

/// One header, up to the empty name at its end. @return whether it had any attribute.
bool checkOneHeader(Cursor& cursor, std::size_t fileBytes) {
  Layout layout;
  bool any = false;
  for (std::string_view name = cursor.text(); !name.empty(); name = cursor.text()) {
    any = true;
    const std::string_view type = cursor.text();
    const Bytes value = cursor.take(std::uint32_t(cursor.number()));
    checkValue(type, value);
    if (name == "dataWindow" && type == "box2i") std::memcpy(layout.window.data(), value.data(), value.size());
    if (name == "channels" && type == "chlist") layout.channels = countChannels(value);
    if (name == "compression" && type == "compression") layout.compression = int(value[0]);
  }
  if (any) checkLayout(layout, fileBytes);
  return any;
}

/// Checks all headers of an OpenEXR file: every attribute value must have exactly the announced size, and image and
/// line buffers must have reasonable sizes. Needed because OpenEXR 3.1 reads values of known types regardless of the
/// announced size, and allocates the announced size of unknown types before it reads them. @throws Error that states
/// what was found, and where.
void checkExrHeader(Bytes bytes) {
  Cursor start(bytes, 0);
  start.take(startBytes - sizeof(std::int32_t));
  const bool manyParts = std::uint32_t(start.number()) & manyPartsFlag;
  Cursor cursor(bytes, startBytes);
  while (checkOneHeader(cursor, bytes.size()) && manyParts) continue;
}

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

void checkImageSize(long long width, long long height, std::size_t fileBytes, std::size_t maxPixelsPerByte) {
  const std::string size = "found an image of " + std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width < 1 || height < 1 || width > maxSide || height > maxSide || width * height > maxPixels)
    throw Error(size + ", expected 1 to " + std::to_string(maxSide) + " per side and at most " +
                std::to_string(maxPixels) + " in total");
  if (std::size_t(width * height) / maxPixelsPerByte > fileBytes)
    throw Error(size + " in " + std::to_string(fileBytes) + " bytes, expected a longer file");
}

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
