// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/exr_codec.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfEnvmap.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "core/io/colour_primaries.h"
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
    if (!channel)
      throw Error("found the channels " + names + ", expected R, G, B or Y (channels of layers are not read)");
    if (channel->xSampling != 1 || channel->ySampling != 1)
      throw Error("found the channel " + colour + " with fewer samples than pixels, expected one per pixel");
  }
  return colours;
}

/// Describes where OpenEXR finds (or puts) pixel (0, 0) of interleaved floats: its data window may start anywhere.
Imf::Slice slice(float* first, std::size_t stride, const Imath::Box2i& window, int width) {
  return Imf::Slice::Make(Imf::FLOAT, first, window, stride, stride * std::size_t(width));
}

bool isLuminanceChroma(const Imf::ChannelList& channels) {
  return channels.findChannel("Y") && (channels.findChannel("RY") || channels.findChannel("BY"));
}

/// Luminance and subsampled chroma (RY, BY) by OpenEXR's own interface, which computes in half precision.
Image decodeLuminanceChroma(std::span<const std::byte> bytes, const Imf::Header& header) {
  // Throws for primaries without a matrix. So does the constructor of the file, but it leaks what it opened
  // (OpenEXR 3.1).
  if (Imf::hasChromaticities(header)) Imf::RGBtoXYZ(Imf::chromaticities(header), 1);
  MemoryInput stream(bytes);
  Imf::RgbaInputFile file(stream);
  const Imath::Box2i window = file.dataWindow();
  Image image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
  const bool hasAlpha = file.channels() & Imf::WRITE_A;
  if (hasAlpha) image.alpha.resize(image.pixels.size());
  std::vector<Imf::Rgba> line(std::size_t(image.width));
  for (int y = window.min.y; y <= window.max.y; ++y) {
    // A stride of 0: every line is read to the same place.
    file.setFrameBuffer(line.data() - window.min.x, 1, 0);
    file.readPixels(y);
    for (int x = 0; x < image.width; ++x) {
      const Imf::Rgba& pixel = line[std::size_t(x)];
      image.at(x, y - window.min.y) = {float(pixel.r), float(pixel.g), float(pixel.b)};
      if (hasAlpha) image.alpha[image.index(x, y - window.min.y)] = pixel.a;
    }
  }
  return image;
}

Image decodeChannels(Imf::InputFile& file) {
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

/// Converts the colours if the file states other primaries than sRGB.
void convertPrimaries(const Imf::Header& header, ImageFile& picture) {
  if (!Imf::hasChromaticities(header)) return;
  const Imf::Chromaticities& found = Imf::chromaticities(header);
  const auto pair = [](const Imath::V2f& xy) { return glm::dvec2(xy.x, xy.y); };
  const ColourPrimaries primaries{pair(found.red), pair(found.green), pair(found.blue), pair(found.white)};
  if (primaries.areSrgb()) return;
  const auto matrix = toSrgbMatrix(primaries);
  if (!matrix) throw Error("found the chromaticities " + primaries.text() + ", expected three colours and a white");
  for (glm::vec3& pixel : picture.image.pixels) pixel = *matrix * glm::dvec3(pixel);
  picture.notes.push_back(primaries.areXyz() ? "X, Y, Z were converted to sRGB"
                                             : "colours were converted to sRGB from the primaries " + primaries.text());
}

/// The picture in the display window; black where it has no data.
void placeInDisplayWindow(const Imf::Header& header, std::size_t fileBytes, ImageFile& picture) {
  const Imath::Box2i &data = header.dataWindow(), &display = header.displayWindow();
  if (data == display) return;
  const long long width = 1LL + display.max.x - display.min.x, height = 1LL + display.max.y - display.min.y;
  checkImageSize(width, height, fileBytes, maxExrPixelsPerByte);
  const auto text = [](const Imath::Box2i& box) {
    return "(" + std::to_string(box.min.x) + ", " + std::to_string(box.min.y) + ") to (" + std::to_string(box.max.x) +
           ", " + std::to_string(box.max.y) + ")";
  };
  if (!data.intersects(display))
    throw Error("found the data window " + text(data) + " outside the display window " + text(display) +
                ", expected an image in it");
  Image placed{int(width), int(height)};
  if (!picture.image.alpha.empty()) placed.alpha.resize(placed.pixels.size());
  for (int y = std::max(data.min.y, display.min.y); y <= std::min(data.max.y, display.max.y); ++y)
    for (int x = std::max(data.min.x, display.min.x); x <= std::min(data.max.x, display.max.x); ++x) {
      const std::size_t from = picture.image.index(x - data.min.x, y - data.min.y),
                        to = placed.index(x - display.min.x, y - display.min.y);
      placed.pixels[to] = picture.image.pixels[from];
      if (!placed.alpha.empty()) placed.alpha[to] = picture.image.alpha[from];
    }
  picture.image = std::move(placed);
  picture.notes.push_back("the data window " + text(data) + " was placed in the display window " + text(display));
}

/// A cube of six faces as a latitude-longitude map, bilinear within each face. OpenEXR looks along +z at longitude 0
/// and has +x on the left there; Gonio's maps look along -z and have +x on the right.
Image latitudeLongitudeOfCube(const Image& cube) {
  const Imath::Box2i window(Imath::V2i(0, 0), Imath::V2i(cube.width - 1, cube.height - 1));
  const int side = Imf::CubeMap::sizeOfFace(window);
  Image map(4 * side, 2 * side);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const double theta = pi * (y + 0.5) / map.height, azimuth = 2 * pi * ((x + 0.5) / map.width - 0.5);
      const Imath::V3f direction(float(-std::sin(theta) * std::sin(azimuth)), float(std::cos(theta)),
                                 float(std::sin(theta) * std::cos(azimuth)));
      Imf::CubeMapFace face{};
      Imath::V2f at;
      Imf::CubeMap::faceAndPixelPosition(direction, window, face, at);
      const auto pixel = [&](int column, int row) {
        const Imath::V2f place = Imf::CubeMap::pixelPosition(
            face, window, Imath::V2f(float(std::clamp(column, 0, side - 1)), float(std::clamp(row, 0, side - 1))));
        return cube.at(std::clamp(int(std::lround(place.x)), 0, cube.width - 1),
                       std::clamp(int(std::lround(place.y)), 0, cube.height - 1));
      };
      const int column = int(std::floor(at.x)), row = int(std::floor(at.y));
      const float right = at.x - float(column), down = at.y - float(row);
      map.at(x, y) = (1 - down) * ((1 - right) * pixel(column, row) + right * pixel(column + 1, row)) +
                     down * ((1 - right) * pixel(column, row + 1) + right * pixel(column + 1, row + 1));
    }
  return map;
}

void convertLayout(const Imf::Header& header, ImageFile& picture) {
  if (!Imf::hasEnvmap(header) || Imf::envmap(header) == Imf::ENVMAP_LATLONG) return;
  const Image& image = picture.image;
  if (Imf::envmap(header) != Imf::ENVMAP_CUBE || image.height != 6 * image.width)
    throw Error("found an environment of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                " pixels with the layout " + std::to_string(int(Imf::envmap(header))) +
                " (envmap), expected latitude-longitude (0), or a cube (1) of six square faces below one another");
  picture.image = latitudeLongitudeOfCube(image);
  picture.notes.emplace_back("a cube was converted to a latitude-longitude map");
}

ImageFile decode(std::span<const std::byte> bytes) {
  checkExrHeader(bytes);
  MemoryInput stream(bytes);
  Imf::InputFile file(stream);
  const Imf::Header& header = file.header();
  ImageFile picture;
  picture.image = isLuminanceChroma(header.channels()) ? decodeLuminanceChroma(bytes, header) : decodeChannels(file);
  if (isLuminanceChroma(header.channels())) picture.notes.emplace_back("luminance and chroma were converted to RGB");
  if (const auto* layout = header.findTypedAttribute<Imf::StringAttribute>(layoutAttribute))
    picture.layout = layout->value();
  convertPrimaries(header, picture);
  placeInDisplayWindow(header, bytes.size(), picture);
  convertLayout(header, picture);
  return picture;
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

ImageFile decodeExr(std::span<const std::byte> bytes) {
  return translatingErrors([&] { return decode(bytes); });
}

std::vector<std::byte> encodeExr(const Image& image, const std::map<std::string, std::string>& attributes) {
  return translatingErrors([&] { return encode(image, attributes); });
}

}  // namespace gonio::io
