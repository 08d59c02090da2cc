// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <QTest>
#include <array>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>
#include <random>

#include "core/support/text.h"
#include "tests/fuzz/reader_seeds.h"
#include "tests/fuzz/reader_targets.h"
#include "tests/support/test_program.h"

namespace {
/// The largest request for memory since it was last set to 0.
std::atomic<std::size_t> largestRequest = 0;
}  // namespace

// The thread sanitizer brings operators of its own. Where GCC 14 inlines one of a pair, it warns that the other does
// not match.
#ifndef GONIO_THREAD_SANITIZER
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  std::size_t known = largestRequest;
  while (bytes > known && !largestRequest.compare_exchange_weak(known, bytes)) continue;
  return std::malloc(bytes ? bytes : 1);
}
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  if (void* memory = operator new(bytes, std::nothrow)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

Q_DECLARE_METATYPE(const gonio::materials::MaterialFormat*)

namespace reader_mutation_test {
using namespace gonio;
using namespace gonio::fuzz;

using Random = std::mt19937_64;
using Target = std::function<void(std::span<const std::byte>)>;

constexpr int mutationsOfASeed = 2000;
/// No seed is longer than some kilobytes; an OpenEXR file may promise 16384 pixels a byte.
constexpr std::size_t maxRequest = std::size_t(1) << 29;

std::size_t below(Random& random, std::size_t count) { return count == 0 ? 0 : std::size_t(random() % count); }

/// Numbers at which sizes, counts and offsets go wrong.
constexpr std::uint64_t nastyNumbers[] = {0,
                                          1,
                                          2,
                                          0x7f,
                                          0x80,
                                          0xff,
                                          0xffff,
                                          0x7fffffff,
                                          1u << 31,
                                          0xffffffff,
                                          1u << 16,
                                          std::uint64_t(1) << 62,
                                          std::uint64_t(1) << 63,
                                          ~std::uint64_t(0)};

void mutate(Bytes& bytes, Random& random) {
  const std::size_t at = below(random, bytes.size());
  switch (below(random, 6)) {
    case 0:
      if (!bytes.empty()) bytes[at] ^= std::byte(1u << below(random, 8));
      break;
    case 1: {
      const std::uint64_t number = nastyNumbers[below(random, std::size(nastyNumbers))];
      const std::size_t width = std::min<std::size_t>(std::size_t(1) << below(random, 4), bytes.size() - at);
      std::memcpy(bytes.data() + at, &number, width);
      break;
    }
    case 2:
      bytes.resize(at);
      break;
    case 3:
      bytes.insert(bytes.begin() + std::ptrdiff_t(at), below(random, 40), std::byte(random()));
      break;
    case 4: {
      const std::size_t count = std::min(below(random, 40), bytes.size() - at);
      bytes.erase(bytes.begin() + std::ptrdiff_t(at), bytes.begin() + std::ptrdiff_t(at + count));
      break;
    }
    default:
      if (!bytes.empty()) bytes[at] = std::byte(random());
  }
}

Bytes exrSeed() {
  Image image(16, 12);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = glm::vec3(float(i), float(i % 7), 0.5f);
    image.alpha.push_back(float(i % 2));
  }
  const auto path = test::outputPath("fuzz/seed.exr");
  io::writeExr(image, path, {{"scene", "seed"}});
  return test::readFile(path);
}

/// Luminance and chroma of other primaries, in a part of the display window; or a cube.
Bytes unusualExrSeed(bool isCube) {
  Imf::Header header(isCube ? 4 : 16, isCube ? 24 : 12);
  Imf::addChromaticities(header, Imf::Chromaticities({0.7f, 0.3f}, {0.2f, 0.7f}, {0.15f, 0.05f}, {0.32f, 0.33f}));
  if (isCube) Imf::addEnvmap(header, Imf::ENVMAP_CUBE);
  if (!isCube) header.dataWindow() = Imath::Box2i({2, 4}, {17, 9});
  const Imath::Box2i window = header.dataWindow();
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  std::vector<Imf::Rgba> pixels(std::size_t(width * height));
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = {float(i % 5), float(i % 7), 0.5f, 1};
  const auto path = test::outputPath("fuzz/unusual.exr");
  {
    Imf::RgbaOutputFile file(path.c_str(), header, isCube ? Imf::WRITE_RGB : Imf::WRITE_YC);
    file.setFrameBuffer(pixels.data() - window.min.x - window.min.y * width, 1, std::size_t(width));
    file.writePixels(height);
  }
  return test::readFile(path);
}

Bytes encodedSeed(bool isJpeg) {
  std::vector<unsigned char> values(16 * 12 * (isJpeg ? 3 : 4));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<unsigned char>(i * 7);
  return isJpeg ? test::jpegFile(values, 16, 12) : io::encodePng(values, 16, 12);
}

/// "" when all mutations of the seed were read or refused as they should.
std::string firstFailure(const std::string& name, const Bytes& seed, const Target& target) {
  test::writeFile("fuzz/seeds/" + name, seed);  // libFuzzer starts from these
  Random random(20260101);
  for (int i = 0; i < mutationsOfASeed; ++i) {
    Bytes bytes = seed;
    for (std::size_t count = 1 + below(random, 4); count > 0; --count) mutate(bytes, random);
    largestRequest = 0;
    std::string failure;
    try {
      target(bytes);
    } catch (const Error&) {
    } catch (const std::exception& exception) {
      failure = exception.what();
    }
    if (largestRequest > maxRequest) failure = "requested " + std::to_string(largestRequest) + " bytes";
    if (failure.empty()) continue;
    return name + ", mutation " + std::to_string(i) + " (" + test::writeFile("fuzz/failed_" + name, bytes).string() +
           "): " + failure;
  }
  return {};
}

void check(const std::string& name, const Bytes& seed, const Target& target) {
  const std::string failure = firstFailure(name, seed, target);
  QVERIFY2(failure.empty(), failure.c_str());
}

/// The formats whose files are read as materials here; the others have a target of their own.
std::vector<const materials::MaterialFormat*> readAsMaterials() {
  std::vector<const materials::MaterialFormat*> result;
  for (const materials::MaterialFormat* format : materials::materialFormats())
    if (!std::ranges::count(
            std::array{&formats::astmFormat, &formats::goniophotometerFormat, &formats::curetFormat,
                       &formats::csvFormat, &formats::refletFormat, &formats::altaFormat, &formats::openMaterialFormat,
                       &formats::speosFormat, &formats::pdvFormat, &formats::codeFormat, &formats::neuralFormat},
            format))
      result.push_back(format);
  return result;
}

class ReaderMutationTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void seedsAreValid() {
    for (const materials::MaterialFormat* format : readAsMaterials()) readMaterialBytes(formatSeed(*format));
    readScatteredBytes<formats::readAstm>(astmSeed());
    readScatteredBytes<formats::readGoniophotometer>(goniophotometerSeed());
    readScatteredBytes<formats::readCuret>(curetSeed());
    readScatteredBytes<formats::readCsvPoints>(csvSeed());
    readScatteredBytes<formats::readCsvPoints>(csvGridSeed());
    readScatteredBytes<formats::readReflet>(refletSeed());
    readScatteredBytes<formats::readAlta>(altaSeed());
    readScatteredBytes<formats::readOpenMaterial>(openMaterialSeed());
    readScatteredBytes<formats::readSpeos>(speosSeed());
    readScatteredBytes<formats::readSpeos>(spectralSpeosSeed());
    for (const int rank : {3, 4}) readMaterialBytes(tensorTreeSeed(rank));
    readMaterialBytes(rotatedZemaxSeed());
    readPdvBytes(pdvSeed());
    readNeuralBytes(neuralSeed());
    readNpfBytes(npfSeed());
    readObjBytes(objSeed());
    readPlyBytes(plySeed());
    readGlbBytes(glbSeed());
    readCodeBytes(codeSeed());
    readDictionaryBytes(dictionarySeed());
    readImageBytes(hdrSeed());
    readImageBytes(oldHdrSeed());
    readImageBytes(exrSeed());
    for (const bool isCube : {false, true}) readImageBytes(unusualExrSeed(isCube));
    for (const bool isJpeg : {false, true}) readEncodedImageBytes(encodedSeed(isJpeg));
    readGlbBytes(skinSeed());
    readPlyBytes(stripsSeed());
    readStlBytes(stlSeed());
    readScatteredBytes<formats::readAstm>(localeAstmSeed());
    readScatteredBytes<formats::readGoniophotometer>(localeGoniophotometerSeed());
    readDocumentBytes(documentSeed());
    readSceneBytes(sceneSeed());
    readFigureBytes(figureSeed());
    readPlanBytes(planSeed());
    readValuesBytes(valuesSeed());
    readValuesBytes(spectraSeed());
    readFactorReadingsBytes(factorReadingsSeed());
    readBasisBytes(basisSeed());
  }

  void material_data() {
    QTest::addColumn<const materials::MaterialFormat*>("format");
    for (const materials::MaterialFormat* format : readAsMaterials()) QTest::newRow(format->label.data()) << format;
  }
  void material() {
    QFETCH(const materials::MaterialFormat*, format);
    check(lowerCase(std::string(format->name).append(format->suffix())), formatSeed(*format), readMaterialBytes);
  }
  void astm() { check("points.astm", astmSeed(), readScatteredBytes<formats::readAstm>); }
  void goniophotometer() {
    check("points.txt", goniophotometerSeed(), readScatteredBytes<formats::readGoniophotometer>);
  }
  void curet() { check("points.dat", curetSeed(), readScatteredBytes<formats::readCuret>); }
  void csv() { check("points.csv", csvSeed(), readScatteredBytes<formats::readCsvPoints>); }
  void csvGrid() { check("grid.csv", csvGridSeed(), readScatteredBytes<formats::readCsvPoints>); }
  void reflet() { check("reflet.txt", refletSeed(), readScatteredBytes<formats::readReflet>); }
  void alta() { check("points.alta", altaSeed(), readScatteredBytes<formats::readAlta>); }
  void openMaterial() { check("table.xompt", openMaterialSeed(), readScatteredBytes<formats::readOpenMaterial>); }
  void speos() { check("speos.anisotropicbsdf", speosSeed(), readScatteredBytes<formats::readSpeos>); }
  void spectralSpeos() { check("speos.brdf", spectralSpeosSeed(), readScatteredBytes<formats::readSpeos>); }
  void tensorTree3() { check("tree3.xml", tensorTreeSeed(3), readMaterialBytes); }
  void tensorTree4() { check("tree4.xml", tensorTreeSeed(4), readMaterialBytes); }
  void rotatedZemax() { check("rotated.bsdf", rotatedZemaxSeed(), readMaterialBytes); }
  void pdv() { check("factors.pdv", pdvSeed(), readPdvBytes); }
  void neural() { check("network.nbrdf", neuralSeed(), readNeuralBytes); }
  void npf() { check("npf.bin", npfSeed(), readNpfBytes); }
  void obj() { check("mesh.obj", objSeed(), readObjBytes); }
  void ply() { check("mesh.ply", plySeed(), readPlyBytes); }
  void glb() { check("mesh.glb", glbSeed(), readGlbBytes); }
  void code() { check("sparse.code", codeSeed(), readCodeBytes); }
  void dictionary() { check("ensemble.dictionary", dictionarySeed(), readDictionaryBytes); }
  void hdr() { check("picture.hdr", hdrSeed(), readImageBytes); }
  void exr() { check("picture.exr", exrSeed(), readImageBytes); }
  void oldHdr() { check("old.hdr", oldHdrSeed(), readImageBytes); }
  void luminanceChroma() { check("chroma.exr", unusualExrSeed(false), readImageBytes); }
  void cube() { check("cube.exr", unusualExrSeed(true), readImageBytes); }
  void png() { check("picture.png", encodedSeed(false), readEncodedImageBytes); }
  void jpeg() { check("picture.jpg", encodedSeed(true), readEncodedImageBytes); }
  void skin() { check("skin.gltf", skinSeed(), readGlbBytes); }
  void strips() { check("strips.ply", stripsSeed(), readPlyBytes); }
  void stl() { check("mesh.stl", stlSeed(), readStlBytes); }
  void localeAstm() { check("locale.astm", localeAstmSeed(), readScatteredBytes<formats::readAstm>); }
  void localeGoniophotometer() {
    check("locale.txt", localeGoniophotometerSeed(), readScatteredBytes<formats::readGoniophotometer>);
  }
  void document() { check("edit.gonio", documentSeed(), readDocumentBytes); }
  void plan() { check("plan.csv", planSeed(), readPlanBytes); }
  void values() { check("values.csv", valuesSeed(), readValuesBytes); }
  void spectra() { check("spectra.csv", spectraSeed(), readValuesBytes); }
  void factorReadings() { check("readings.csv", factorReadingsSeed(), readFactorReadingsBytes); }
  void basis() { check("pca.basis", basisSeed(), readBasisBytes); }
  void scene() { check("scene.json", sceneSeed(), readSceneBytes); }
  void figure() { check("figure.json", figureSeed(), readFigureBytes); }
};

GONIO_TEST(ReaderMutationTest)
}  // namespace reader_mutation_test

#include "reader_mutation_test.moc"
