// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/image_io.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfEnvmap.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <spng.h>

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace image_io_test {
using namespace gonio;
using namespace gonio::test;

Image pattern(int width, int height, bool alpha) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float x = float(i);
    image.pixels[i] = {std::exp(std::sin(x) * 20), -x / 7, x * x};
    if (alpha) image.alpha.push_back(x / 100);
  }
  return image;
}

Bytes bytesOf(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// A Radiance picture of flat (not run-length coded) pixels: width below 8.
Bytes flatHdr(int width, int height, const std::vector<std::array<unsigned char, 4>>& pixels) {
  Bytes bytes = bytesOf("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                        std::to_string(width) + "\n");
  for (const auto& pixel : pixels) append(bytes, pixel);
  return bytes;
}

class ImageIoTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void exrKeepsEveryBit() {
    for (const bool alpha : {false, true}) {
      Image image = pattern(37, 19, alpha);
      image.pixels[0].x = 1e-40f;  // below half's and normal float's range
      image.pixels[1].y = std::numeric_limits<float>::max();
      const auto path = outputPath("io/image/pattern.exr");
      io::writeExr(image, path, {{"scene", "sphere"}, {"gonio plan", "direct light"}});
      const Image again = io::readImage(path);
      QCOMPARE(again.width, 37);
      QCOMPARE(again.height, 19);
      QVERIFY(again.pixels == image.pixels);
      QVERIFY(again.alpha == image.alpha);
      const Imf::InputFile file(path.c_str());
      QCOMPARE(file.header().typedAttribute<Imf::StringAttribute>("scene").value(), std::string("sphere"));
      QCOMPARE(file.header().channels().findChannel("R")->type, Imf::FLOAT);
    }
  }

  void exrErrorsNameTheFile() {
    const auto path = outputPath("io/image/reserved.exr");
    QVERIFY(contains(errorOf([&] { io::writeExr(pattern(2, 2, false), path, {{"channels", "x"}}); }), "reserved.exr"));
    QVERIFY(contains(errorOf([&] { io::writeExr(Image(), path); }), "reserved.exr"));
    const auto text = writeFile("io/image/text.exr", bytesOf("not a picture"));
    QVERIFY(contains(errorOf([&] { io::readImage(text); }), "text.exr"));
  }

  void truncatedExrIsRefused() {
    const auto path = outputPath("io/image/short.exr");
    io::writeExr(pattern(16, 64, false), path);
    const Bytes bytes = readFile(path);
    for (std::size_t size = 0; size < bytes.size(); size += 97)
      QVERIFY(!errorOf([&] { io::readImage(std::span(bytes).first(size)); }).empty());
  }

  void hardCase13HostileExrHeadersAreRefused() {
    const auto path = outputPath("io/image/hostile.exr");
    io::writeExr(pattern(16, 12, false), path, {{"scene", "sphere"}});
    const Bytes whole = readFile(path);
    /// The error after the bytes at `offset` past a text of the header are replaced.
    const auto errorAfter = [&](const std::string& text, std::size_t offset, std::uint32_t value) {
      const Bytes pattern = bytesOf(text);
      Bytes bytes = whole;
      const auto found = std::search(bytes.begin(), bytes.end(), pattern.begin(), pattern.end());
      std::memcpy(&*found + pattern.size() + offset, &value, sizeof value);
      return errorOf([&] { io::readImage(bytes); });
    };
    const std::string scene("scene\0string\0", 13), window("dataWindow\0box2i\0", 17), list("channels\0chlist\0", 16);
    QVERIFY(errorAfter(scene, 0, 6).empty());  // the true size
    QVERIFY(contains(errorAfter(scene, 0, 0x7fffffff), "2147483647 bytes"));
    QVERIFY(contains(errorAfter(window, 0, 17), "box2i in 17 bytes"));
    QVERIFY(contains(errorAfter(window, 4 + 8, 0x7fffffff), "x 12 pixels"));
    QVERIFY(!errorAfter(window, 4 + 12, 32767).empty());  // more lines than the file has
    QVERIFY(!errorAfter(list, 0, 54).empty());            // 3 channels of 18 bytes and the end are 55
    QVERIFY(errorAfter(list, 0, 55).empty());
  }

  /// Value = mantissa / 256 * 2^(exponent - 128): exact figures of the format (Ward 1991, Graphics Gems II.5).
  void hdrValues() {
    const Image image =
        io::readImage(flatHdr(2, 2, {{128, 64, 32, 129}, {255, 0, 1, 128}, {0, 0, 0, 0}, {1, 2, 4, 140}}));
    QCOMPARE(image.width, 2);
    QVERIFY(image.at(0, 0) == glm::vec3(1, 0.5f, 0.25f));
    QVERIFY(image.at(1, 0) == glm::vec3(255 / 256.f, 0, 1 / 256.f));
    QVERIFY(image.at(0, 1) == glm::vec3(0));
    QVERIFY(image.at(1, 1) == glm::vec3(16, 32, 64));
  }

  /// The eight orientations show one picture of three columns and two rows.
  void hdrOrientations() {
    // Red is 10 times the column, green 10 times the row.
    const auto pixel = [](int x, int y) {
      return std::array<unsigned char, 4>{(unsigned char)(10 * x), (unsigned char)(10 * y), 7, 136};
    };
    for (const bool isXFirst : {false, true})
      for (const bool isXReversed : {false, true})
        for (const bool isYReversed : {false, true}) {
          const std::string x = std::string(isXReversed ? "-X" : "+X") + " 3",
                            y = std::string(isYReversed ? "+Y" : "-Y") + " 2";
          Bytes bytes =
              bytesOf("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + (isXFirst ? x + " " + y : y + " " + x) + "\n");
          for (int line = 0; line < (isXFirst ? 3 : 2); ++line)
            for (int place = 0; place < (isXFirst ? 2 : 3); ++place) {
              const int column = isXFirst ? line : place, row = isXFirst ? place : line;
              append(bytes, pixel(isXReversed ? 2 - column : column, isYReversed ? 1 - row : row));
            }
          const Image image = io::readImage(bytes);
          QVERIFY(image.width == 3 && image.height == 2);
          for (int row = 0; row < 2; ++row)
            for (int column = 0; column < 3; ++column)
              QCOMPARE(image.at(column, row), glm::vec3(10.f * float(column), 10.f * float(row), 7));
        }
  }

  /// Ward 1991: (1, 1, 1, n) repeats the pixel before; one right after another counts 256 times.
  void hdrOldRuns() {
    Bytes bytes = bytesOf("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 300\n");
    for (const int value : {128, 64, 32, 129, 1, 1, 1, 40, 1, 1, 1, 1, 0, 0, 0, 0, 128, 0, 0, 129, 1, 1, 1, 1})
      bytes.push_back(std::byte(value));
    const Image image = io::readImage(bytes);
    for (int x = 0; x < 300; ++x)
      QCOMPARE(image.at(x, 0), x < 297 ? glm::vec3(1, 0.5f, 0.25f) : x == 297 ? glm::vec3(0) : glm::vec3(1, 0, 0));
    bytes.back() = std::byte(2);
    QVERIFY(contains(errorOf([&] { io::readImage(bytes); }), "found a run of the wrong length"));
    bytes.resize(bytes.size() - 4);
    QVERIFY(contains(errorOf([&] { io::readImage(bytes); }), "ends at byte"));
  }

  void hdrHeadersThatChangeValues() {
    const auto read = [](const std::string& header, const std::string& format = "32-bit_rle_rgbe") {
      Bytes bytes = bytesOf("#?RADIANCE\n" + header + "FORMAT=" + format + "\n\n-Y 1 +X 1\n");
      append(bytes, std::array<unsigned char, 4>{128, 64, 32, 129});
      return io::readImageFile(bytes);
    };
    QCOMPARE(read("EXPOSURE=2\nEXPOSURE=2\n").image.at(0, 0), glm::vec3(0.25f, 0.125f, 0.0625f));
    QCOMPARE(read("COLORCORR= 1 0.5 2\n").image.at(0, 0), glm::vec3(1, 1, 0.125f));
    QVERIFY(contains(read("EXPOSURE=2\n").notes.at(0), "divided by EXPOSURE and COLORCORR: 2, 2, 2"));
    // sRGB, and what Photoshop writes.
    for (const char* primaries : {"0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329", "0 0 0 0 0 0 0 0"}) {
      const io::ImageFile file = read("GAMMA=1\nPRIMARIES=" + std::string(primaries) + "\n");
      QVERIFY(file.image.at(0, 0) == glm::vec3(1, 0.5f, 0.25f) && file.notes.empty());
    }
    const io::ImageFile other = read("PRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.3333 0.3333\n");
    QVERIFY(contains(other.notes.at(0), "converted to sRGB from the primaries red (0.64, 0.33)"));
    QVERIFY(glm::length(other.image.at(0, 0) - glm::vec3(1, 0.5f, 0.25f)) > 0.01f);
    // X, Y, Z = 1, 0.5, 0.25 (IEC 61966-2-1).
    const glm::vec3 xyz = read("", "32-bit_rle_xyze").image.at(0, 0);
    QVERIFY(glm::length(xyz - glm::vec3(3.2406 - 0.5 * 1.5372 - 0.25 * 0.4986, -0.9689 + 0.5 * 1.8758 + 0.25 * 0.0415,
                                        0.0557 - 0.5 * 0.2040 + 0.25 * 1.0570)) < 2e-3f);
    for (const char* header : {"EXPOSURE=0\n", "EXPOSURE=x\n", "COLORCORR=1 2\n", "PRIMARIES=1 2 3\n",
                               "PRIMARIES=.3 .3 .3 .3 .3 .3 .3 .3\n", "FORMAT=ascii\n"})
      QVERIFY2(contains(errorOf([&] { read(header); }), "expected"), header);
  }

  /// A file by OpenEXR's own interface; the pixels fill its data window.
  static io::ImageFile readExr(const Imf::Header& header, const std::vector<Imf::Rgba>& pixels,
                               Imf::RgbaChannels channels = Imf::WRITE_RGB) {
    const auto path = outputPath("io/image/headers.exr");
    const Imath::Box2i window = header.dataWindow();
    const int width = window.max.x - window.min.x + 1;
    {
      Imf::RgbaOutputFile file(path.c_str(), header, channels);
      file.setFrameBuffer(pixels.data() - window.min.x - window.min.y * width, 1, std::size_t(width));
      file.writePixels(window.max.y - window.min.y + 1);
    }
    return io::readImageFile(path);
  }
  static bool isClose(const glm::vec3& a, const glm::vec3& b, float tolerance) {
    return glm::length(a - b) < tolerance;
  }

  /// Of ACES AP1 the published matrix with Bradford's adaptation (ACEScg to linear sRGB), of X, Y, Z that of IEC
  /// 61966-2-1.
  void exrChromaticities() {
    Imf::Header header(3, 1);
    const std::vector<Imf::Rgba> pixels{{1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
    Imf::addChromaticities(
        header, Imf::Chromaticities({0.713f, 0.293f}, {0.165f, 0.83f}, {0.128f, 0.044f}, {0.32168f, 0.33767f}));
    const io::ImageFile aces = readExr(header, pixels);
    QVERIFY(isClose(aces.image.at(0, 0), {1.70505f, -0.13026f, -0.02400f}, 1e-3f));
    QVERIFY(isClose(aces.image.at(1, 0), {-0.62179f, 1.14080f, -0.12897f}, 1e-3f));
    QVERIFY(isClose(aces.image.at(2, 0), {1, 1, 1}, 1e-4f));
    QVERIFY(contains(aces.notes.at(0), "from the primaries red (0.713, 0.293)"));
    for (const Imath::V2f& white : {Imath::V2f(1 / 3.f, 1 / 3.f), Imath::V2f(0.3127f, 0.329f)}) {
      Imf::addChromaticities(header, Imf::Chromaticities({1, 0}, {0, 1}, {0, 0}, white));
      const io::ImageFile xyz = readExr(header, {{0.9505f, 1, 1.089f}, {1, 0, 0}, {0, 0, 0}});
      QVERIFY(isClose(xyz.image.at(0, 0), {1, 1, 1}, 2e-3f));
      QVERIFY(isClose(xyz.image.at(1, 0), {3.2406f, -0.9689f, 0.0557f}, 1e-3f));
    }
    Imf::addChromaticities(header, Imf::Chromaticities());
    const io::ImageFile srgb = readExr(header, pixels);
    QVERIFY(srgb.image.at(0, 0) == glm::vec3(1, 0, 0) && srgb.notes.empty());
    Imf::addChromaticities(header, Imf::Chromaticities({0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}));
    QVERIFY(contains(errorOf([&] { readExr(header, pixels); }), "expected three colours and a white"));
  }

  void exrLuminanceAndChroma() {
    const std::vector<Imf::Rgba> red(16 * 8, Imf::Rgba(2, 0, 0, 0.5f));
    const io::ImageFile file = readExr(Imf::Header(16, 8), red, Imf::WRITE_YCA);
    for (const glm::vec3& pixel : file.image.pixels) QVERIFY(isClose(pixel, {2, 0, 0}, 0.01f));
    QCOMPARE(file.image.alpha, std::vector<float>(16 * 8, 0.5f));
    const io::ImageFile grey =
        readExr(Imf::Header(16, 8), std::vector<Imf::Rgba>(16 * 8, Imf::Rgba(2, 2, 2)), Imf::WRITE_Y);
    QVERIFY(isClose(grey.image.at(3, 3), {2, 2, 2}, 1e-3f) && grey.notes.empty());
    // Primaries in one point have no matrix. OpenEXR writes no such file.
    const Imf::Chromaticities primaries({0.713f, 0.293f}, {0.165f, 0.83f}, {0.128f, 0.044f}, {0.32168f, 0.33767f});
    Imf::Header header(16, 8);
    Imf::addChromaticities(header, primaries);
    readExr(header, red, Imf::WRITE_YC);
    Bytes bytes = readFile(outputPath("io/image/headers.exr"));
    const auto begin = std::ranges::search(bytes, std::as_bytes(std::span(&primaries.red.x, 1))).begin();
    const std::vector<float> point(8, 0.3f);
    QVERIFY(bytes.end() - begin > std::ptrdiff_t(point.size() * sizeof(float)));
    std::ranges::copy(std::as_bytes(std::span(point)), begin);
    const std::string error = errorOf([&] { io::readImage(bytes); });
    QVERIFY2(contains(error, "chromaticities"), error.c_str());
  }

  /// Black outside the data window, cropped to the display window.
  void exrWindows() {
    Imf::Header header(8, 4);
    header.displayWindow() = Imath::Box2i({10, 20}, {17, 23});
    header.dataWindow() = Imath::Box2i({12, 18}, {19, 21});
    std::vector<Imf::Rgba> pixels;
    for (int y = 18; y <= 21; ++y)
      for (int x = 12; x <= 19; ++x) pixels.push_back({float(x), float(y), 1, 1});
    const io::ImageFile file = readExr(header, pixels, Imf::WRITE_RGBA);
    QVERIFY(file.image.width == 8 && file.image.height == 4);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 8; ++x) {
        const bool isInside = x >= 2 && y <= 1;
        QCOMPARE(file.image.at(x, y), isInside ? glm::vec3(10 + x, 20 + y, 1) : glm::vec3(0));
        QCOMPARE(file.image.alpha[file.image.index(x, y)], isInside ? 1.f : 0.f);
      }
    QVERIFY(contains(file.notes.at(0), "(12, 18) to (19, 21) was placed in the display window (10, 20) to (17, 23)"));
    header.displayWindow() = Imath::Box2i({30, 20}, {37, 23});
    QVERIFY(contains(errorOf([&] { readExr(header, pixels); }), "outside the display window"));
  }

  /// The faces of a cube as OpenEXR places them: it looks along +z with +x on the left, Gonio along -z with +x on the
  /// right.
  void exrCubes() {
    constexpr int side = 8;
    Imf::Header header(side, 6 * side);
    Imf::addEnvmap(header, Imf::ENVMAP_CUBE);
    std::vector<Imf::Rgba> pixels(6 * side * side);
    for (int face = 0; face < 6; ++face) {
      const Imath::Box2i window = Imf::CubeMap::dataWindowForFace(Imf::CubeMapFace(face), header.dataWindow());
      for (int y = window.min.y; y <= window.max.y; ++y)
        for (int x = window.min.x; x <= window.max.x; ++x) pixels[std::size_t(y * side + x)] = {float(face + 1), 0, 0};
    }
    const io::ImageFile file = readExr(header, pixels);
    QVERIFY(file.image.width == 4 * side && file.image.height == 2 * side);
    const auto faceAt = [&](double u, double v) {
      return Imf::CubeMapFace(std::lround(file.image.at(int(u * 4 * side), int(v * 2 * side)).x) - 1);
    };
    QCOMPARE(faceAt(0.5, 0.5), Imf::CUBEFACE_POS_Z);
    QCOMPARE(faceAt(0.75, 0.5), Imf::CUBEFACE_NEG_X);
    QCOMPARE(faceAt(0.25, 0.5), Imf::CUBEFACE_POS_X);
    QCOMPARE(faceAt(0, 0.5), Imf::CUBEFACE_NEG_Z);
    QCOMPARE(faceAt(0.3, 0), Imf::CUBEFACE_POS_Y);
    QCOMPARE(faceAt(0.3, 0.99), Imf::CUBEFACE_NEG_Y);
    Imf::Header wrong(16, 8);
    Imf::addEnvmap(wrong, Imf::ENVMAP_CUBE);
    QVERIFY(
        contains(errorOf([&] { readExr(wrong, std::vector<Imf::Rgba>(16 * 8)); }), "a cube (1) of six square faces"));
    Imf::addEnvmap(wrong, Imf::ENVMAP_LATLONG);
    QVERIFY(readExr(wrong, std::vector<Imf::Rgba>(16 * 8)).notes.empty());
  }

  void hardCase13HdrHeadersAreRefusedBeforeAllocation() {
    const Bytes whole = flatHdr(2, 2, std::vector<std::array<unsigned char, 4>>(4, {1, 2, 3, 128}));
    QVERIFY(errorOf([&] { io::readImage(whole); }).empty());
    for (std::size_t size = 0; size < whole.size(); ++size)
      QVERIFY2(!errorOf([&] { io::readImage(std::span(whole).first(size)); }).empty(), std::to_string(size).c_str());
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{
             {0, 1}, {-4, 4}, {11000, 11000}, {2147483647, 2147483647}, {100000, 1}, {2000, 2000}})
      QVERIFY(contains(errorOf([&, width = width, height = height] {
                         io::readImage(flatHdr(width, height, {{1, 2, 3, 4}}));
                       }),
                       "expected"));
  }

  void radianceMapOfTheDevelopmentData() {
    const std::filesystem::path path = std::filesystem::path(GONIO_SHARED_DIR) / "data/environments/studio.hdr";
    if (!std::filesystem::exists(path)) QSKIP("the development data is absent");
    const Image image = io::readImage(path);
    QCOMPARE(image.width, 1024);
    QCOMPARE(image.height, 512);
    double sum = 0;
    for (const glm::vec3& pixel : image.pixels) {
      QVERIFY(pixel.x >= 0 && std::isfinite(pixel.x));
      sum += luminance(Rgb(pixel));
    }
    QVERIFY(sum > 0);
  }

  /// The chunks of a PNG file, and its size and colour type (RFC 2083, 4.1.1).
  void pngHasTheRightHeader() {
    const auto path = outputPath("io/image/three.png");
    io::writePng(std::vector<unsigned char>(3 * 2 * 4, 200), 3, 2, path);
    const Bytes bytes = readFile(path);
    const unsigned char expected[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13, 'I',
                                      'H',  'D', 'R', 0,   0,    0,    3,    0,    0, 0, 2, 8,  6};
    QVERIFY(bytes.size() > sizeof expected && std::memcmp(bytes.data(), expected, sizeof expected) == 0);
    QVERIFY(contains(errorOf([&] { io::writePng({1, 2, 3}, 3, 2, path); }), "three.png"));
  }

  /// What PNG and JPEG files store, between 0 and 1. JPEG is lossy; of one colour it is nearly exact.
  void storedValuesOfEncodedImages() {
    const auto path = outputPath("io/image/stored.png");
    std::vector<unsigned char> rgba;
    for (int i = 0; i < 6; ++i)
      for (const int value : {i, 40 * i, 255 - i, 255}) rgba.push_back(static_cast<unsigned char>(value));
    io::writePng(rgba, 3, 2, path);
    const Image image = io::readEncodedImage(path);
    QCOMPARE(image.width, 3);
    QCOMPARE(image.height, 2);
    for (int i = 0; i < 6; ++i) {
      const glm::vec3 expected = glm::vec3(float(i), float(40 * i), float(255 - i)) / 255.0f;
      QVERIFY(glm::length(image.pixels[std::size_t(i)] - expected) < 1e-6f);
    }
    // 16 bit, in the byte order of this machine when they are given to the encoder.
    const std::vector<std::uint16_t> grey16 = {0, 1, 257, 65535};
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> encoder(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
    spng_ihdr header{.width = 4, .height = 1, .bit_depth = 16, .color_type = SPNG_COLOR_TYPE_GRAYSCALE};
    QCOMPARE(spng_set_ihdr(encoder.get(), &header), 0);
    QCOMPARE(spng_set_option(encoder.get(), SPNG_ENCODE_TO_BUFFER, 1), 0);
    QCOMPARE(spng_encode_image(encoder.get(), grey16.data(), 8, SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE), 0);
    std::size_t bytes = 0;
    int failure = 0;
    const std::unique_ptr<void, void (*)(void*)> png(spng_get_png_buffer(encoder.get(), &bytes, &failure), std::free);
    const Image deep = io::readEncodedImage(std::span(static_cast<const std::byte*>(png.get()), bytes));
    for (std::size_t i = 0; i < grey16.size(); ++i)
      QVERIFY(glm::length(deep.pixels[i] - glm::vec3(float(grey16[i]) / 65535.0f)) < 1e-7f);
    Bytes jpeg = jpegFile(std::vector<unsigned char>(16 * 16 * 3, 100), 16, 16);
    writeFile("io/image/grey.jpg", jpeg);
    for (const glm::vec3& pixel : io::readEncodedImage(outputPath("io/image/grey.jpg")).pixels)
      QVERIFY(glm::length(pixel - glm::vec3(100 / 255.0f)) < 0.02f);
    writeFile("io/image/stored.png", bytesOf("text"));
    QVERIFY(contains(errorOf([&] { io::readEncodedImage(path); }), "stored.png"));
    // A frame of 11000 x 11000 pixels in some hundred bytes.
    Bytes huge = jpeg;
    const Bytes marker = {std::byte(0xff), std::byte(0xc0)};
    const auto frame = std::ranges::search(huge, marker).begin();
    for (int i = 5; i < 9; i += 2) {
      frame[i] = std::byte(11000 >> 8);
      frame[i + 1] = std::byte(11000 & 255);
    }
    QVERIFY(contains(errorOf([&] { io::readEncodedImage(huge); }), "11000 x 11000 pixels in"));
    // Also where the decoder would fill up the picture.
    for (jpeg.pop_back(); jpeg.size() > 2; jpeg.pop_back()) {
      writeFile("io/image/stored.png", jpeg);
      const std::string error = errorOf([&] { io::readEncodedImage(path); });
      QVERIFY2(contains(error, "a JPEG image that cannot be read"),
               (std::to_string(jpeg.size()) + ": " + error).c_str());
    }
  }
};

GONIO_TEST(ImageIoTest)
}  // namespace image_io_test

#include "image_io_test.moc"
