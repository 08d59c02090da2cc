// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/image_io.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

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

  void hardCase13HdrHeadersAreRefusedBeforeAllocation() {
    const Bytes whole = flatHdr(2, 2, std::vector<std::array<unsigned char, 4>>(4, {1, 2, 3, 128}));
    QVERIFY(errorOf([&] { io::readImage(whole); }).empty());
    for (std::size_t size = 0; size < whole.size(); ++size)
      QVERIFY2(!errorOf([&] { io::readImage(std::span(whole).first(size)); }).empty(), std::to_string(size).c_str());
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{
             {0, 1}, {-4, 4}, {30000, 30000}, {2147483647, 2147483647}, {100000, 1}, {2000, 2000}})
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
};

GONIO_TEST(ImageIoTest)
}  // namespace image_io_test

#include "image_io_test.moc"
