// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/formats.h"

#include <QTest>
#include <cmath>
#include <set>

#include "core/formats/code.h"
#include "core/io/sha256.h"
#include "core/io/text_lines.h"
#include "core/materials/encode.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/fuzz/reader_seeds.h"
#include "tests/support/test_program.h"

namespace material_formats_test {
using namespace gonio;
using namespace gonio::test;
using materials::MaterialFormat;

Bytes codeFile() {
  dictionary::SparseCode code{.grid = {}, .transform = DataTransform::logPlus, .channels = {}};
  for (dictionary::ChannelCode& channel : code.channels) channel.coefficients = {{0, 30.0f}};
  return formats::encodeCode(code, materials::bundledEnsemble()->id);
}

/// A file that can be read: of codes one over the bundled dictionary.
Bytes fileOf(const MaterialFormat& format) {
  return &format == &formats::codeFormat ? codeFile() : fuzz::formatSeed(format);
}

std::shared_ptr<const TabulatedBrdf> greyTable(const HalfDifferenceGrid& grid) {
  return std::make_shared<const TabulatedBrdf>(grid, std::vector<glm::vec3>(grid.size(), glm::vec3(0.2f)),
                                               std::vector<std::uint8_t>(grid.size(), 1));
}

class MaterialFormatsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyRowIsCompleteAndOnce() {
    std::set<std::string_view> names, suffixes;
    for (const MaterialFormat* format : materials::materialFormats()) {
      QVERIFY(!format->label.empty() && format->sniff && format->read && !format->suffixes.empty());
      QVERIFY(!format->encode == !format->isOwnForm);
      QVERIFY(names.insert(format->name).second);
      for (const std::string_view suffix : format->suffixes)
        // Both grids of MERL files share one, RGL and the two formats of optical design programs another, and two kinds
        // of goniophotometers a third.
        QVERIFY(suffix.starts_with('.') &&
                (suffixes.insert(suffix).second || suffix == ".bsdf" || suffix == ".binary" || suffix == ".txt"));
    }
  }

  /// Each format's file is sniffed as its own alone, whatever it is called, and holds no more than the table says.
  void contentFindsTheFormat() {
    for (const MaterialFormat* format : materials::materialFormats()) {
      const Bytes bytes = fileOf(*format);
      int takers = 0;
      for (const MaterialFormat* other : materials::materialFormats())
        takers += errorOf([&] { other->sniff(io::MemorySource(bytes)); }).empty();
      QCOMPARE(takers, 1);
      QVERIFY(&materials::sniffFormat(io::MemorySource(bytes)) == format);
      const auto path = writeFile("materials/other.name", bytes);
      QVERIFY(materials::isMaterialFile(path) && !materials::formatBySuffix(path));
      QVERIFY(materials::formatOfFile(path) == format);
      const materials::Material material = materials::readMaterial(path);
      QCOMPARE(material.source.format, std::string(format->name));
      QVERIFY(format->holds.anisotropic || material.brdf->isIsotropic());
      QVERIFY(format->holds.nonReciprocal || material.brdf->isReciprocal());
      // Nothing differs from itself.
      QVERIFY(std::isinf(metrics::brdfSignalToNoiseRatio(*material.brdf, *material.brdf)));
      for (const double error : metrics::brdfErrors(*material.brdf, *material.brdf)) QCOMPARE(error, 0.0);
    }
  }

  /// In every format that is text.
  void aByteOrderMarkIsSkipped() {
    int texts = 0;
    for (const MaterialFormat* format : materials::materialFormats()) {
      const Bytes bytes = fileOf(*format);
      if (!errorOf([&] { io::textHead(io::MemorySource(bytes), "text"); }).empty()) continue;
      ++texts;
      Bytes marked = bytesOf("\xef\xbb\xbf");
      marked.insert(marked.end(), bytes.begin(), bytes.end());
      QVERIFY(&materials::sniffFormat(io::MemorySource(marked)) == format);
      const auto read = [](const Bytes& content) {
        return materials::readMaterial(writeFile("materials/marked.name", content)).brdf;
      };
      const DirectionPair pair{fromSpherical(0.3, 0), fromSpherical(0.5, 2)};
      QVERIFY(read(marked)->evaluate(pair.wi, pair.wo) == read(bytes)->evaluate(pair.wi, pair.wo));
    }
    QVERIFY(texts >= 5);
  }

  void suffixesFindTheFormatInEitherCase() {
    QVERIFY(materials::formatBySuffix("/a.b/x.BINARY") == &formats::merlFormat);
    QVERIFY(materials::hasSuffixOf(formats::codeFormat, "x.code") &&
            !materials::hasSuffixOf(formats::pdvFormat, "x.code"));
    for (const char* none : {"x", "x.binary.txt", ".binary", "", "x.gonio", "x.bin", "x.exr"})
      QVERIFY(!materials::formatBySuffix(none));
    QVERIFY(materials::isMaterialFile("/nowhere/x.pdv") && !materials::isMaterialFile("/nowhere/x.png"));
    // A common suffix needs the content, a broken file of an own suffix stays one.
    const auto bin = writeFile("materials/words.bin", bytesOf("words"));
    QVERIFY(!materials::isMaterialFile(bin) && !materials::formatOfFile(bin));
    const auto broken = writeFile("materials/words.pdv", bytesOf("words"));
    QVERIFY(materials::formatOfFile(broken) == &formats::pdvFormat);
  }

  /// Lists for people: each suffix once, in the order of the table.
  void suffixesAreListed() {
    const auto listed = [](const auto& suffixesOf, const char* conjunction) {
      QStringList suffixes;
      for (const MaterialFormat* format : materials::materialFormats())
        for (const std::string_view suffix : suffixesOf(*format))
          suffixes << QString::fromUtf8(suffix.data(), qsizetype(suffix.size()));
      suffixes.removeDuplicates();
      const QString last = suffixes.takeLast();
      return (suffixes.join(", ") + " " + conjunction + " " + last).toStdString();
    };
    const auto all = [](const MaterialFormat& format) { return format.suffixes; };
    const auto written = [](const MaterialFormat& format) { return format.suffixes.first(format.encode ? 1 : 0); };
    const auto measured = [](const MaterialFormat& format) {
      return format.suffixes.first(format.isMeasurement ? format.suffixes.size() : 0);
    };
    QCOMPARE(materials::suffixText(materials::isAnyFormat, "or"), listed(all, "or"));
    QVERIFY(listed(all, "or").starts_with(".binary, .bsdf, .bin, .exr, .astm, .txt, .alta, .dat, .pdv, .code"));
    QCOMPARE(materials::suffixText(materials::isMeasurement, "and"), listed(measured, "and"));
    QCOMPARE(materials::writableSuffixText(), listed(written, "or"));
    QVERIFY(materials::writableSuffixText(".gonio").starts_with(".binary, .bsdf, .bin") &&
            materials::writableSuffixText(".gonio").ends_with(" or .gonio"));
  }

  void writtenByTheSuffix() {
    for (const HalfDifferenceGrid& grid : {HalfDifferenceGrid{2, 3, 4, true}, HalfDifferenceGrid{2, 3, 12, false}}) {
      const auto path = outputPath("materials/written.Binary");
      materials::writeMaterial(materials::unedited("grey", greyTable(grid)), path);
      QVERIFY(materials::readMaterial(path).table->grid() == grid);
    }
    for (const char* name : {"x.exr", "x.pdv", "x.png", "x"}) {
      const std::string error = errorOf([&] {
        materials::writeMaterial(materials::unedited("grey", greyTable({2, 3, 4, true})), name);
      });
      QVERIFY2(error.starts_with(std::string(name) + ": found the suffix '") &&
                   error.ends_with("', expected " + materials::writableSuffixText()),
               error.c_str());
    }
  }

  /// A table with one valid cell is warned about where it is opened.
  void oneValidCellIsWarnedAbout() {
    Bytes bytes;
    for (const std::int32_t count : {4, 4, 4}) append(bytes, count);
    for (int i = 0; i < 3 * 64; ++i) append(bytes, i % 64 == 5 ? 1.0 : -1.0);
    const materials::Material material = materials::readMaterial(writeFile("materials/one_cell.binary", bytes));
    QCOMPARE(material.table->validCount(), std::size_t(1));
    const auto& notes = material.source.notes;
    QVERIFY(std::ranges::find(notes, "warning: only 1 of 64 cells is valid") != notes.end());
  }

  void fileThatWasOnlyReadIsCopiedByteForByte() {
    Bytes bytes;
    for (const std::int32_t count : {2, 3, 4}) append(bytes, count);
    // Reading changes the negative ones, copying must not.
    for (int i = 0; i < 72; ++i) append(bytes, i == 1 ? -0.3 : i == 2 ? -7.5 : double(i + 1) / 3);
    const auto path = writeFile("materials/source.binary", bytes), copy = outputPath("materials/copy.binary");
    const materials::Material material = materials::readMaterial(path);
    QCOMPARE(material.name, std::string("source"));
    QCOMPARE(material.source.format, std::string("MERL"));
    QCOMPARE(material.source.sha256, io::sha256Hex(bytes));
    QCOMPARE(material.source.grid, (std::vector<int>{2, 3, 4}));
    // The negative values, and the few valid cells.
    QVERIFY(material.source.notes.size() == 1 || contains(material.source.notes[1], "cells are valid"));
    QVERIFY(material.tabulated() == material.table);
    materials::writeMaterial(materials::unedited(material), copy);
    QCOMPARE(readFile(copy), bytes);

    Bytes changed = bytes;
    changed.back() ^= std::byte(1);
    writeFile("materials/source.binary", changed);
    QVERIFY(contains(errorOf([&] { materials::writeMaterial(materials::unedited(material), copy); }), "source.binary"));
    QCOMPARE(readFile(copy), bytes);
  }

  void refusedFileStatesWhatEachFormatFound() {
    const auto path = writeFile("materials/notes.txt", bytesOf("these are only words.\n"));
    const std::string error = errorOf([&] { materials::readMaterial(path); });
    QVERIFY2(
        contains(error, "notes.txt: this file could not be read:") && contains(error, "\n  MERL: found axis counts") &&
            contains(error, "\n  RGL: found") && contains(error, "expected the signature 'tensor_file'") &&
            contains(error, "\n  PDV factors: not a PDV file (signature missing)") &&
            contains(error, "\n  UTIA: found 22 bytes; expected 1990656 bytes") &&
            contains(error, "\n  Zemax: found a text file of another format; expected the keys AngleOfIncidence") &&
            contains(error, "\n  LightTools: found") && contains(error, "\n  ASTM: found") &&
            contains(error, "\n  pgII: found a first line that does not begin with #") &&
            contains(error, "\n  CUReT: found line 1"),
        error.c_str());
  }

  /// Formats that Gonio knows and does not read are named, by suffix or content.
  void unreadFormatsAreNamed() {
    const auto named = [](const char* file, const Bytes& bytes, const std::string& name) {
      const auto path = writeFile(std::string("materials/") + file, bytes);
      const std::string error = errorOf([&] { materials::readMaterial(path); });
      return error == path.string() + ": found " + name + ", which Gonio does not read";
    };
    for (const char* suffix : {"pbsdf", "jdv", "rtd"})
      QVERIFY(named(("x." + std::string(suffix)).c_str(), bytesOf("words"),
                    suffix == std::string("pbsdf") ? "a polarimetric BSDF (.pbsdf)"
                    : suffix == std::string("jdv") ? "a JDV file (.jdv)"
                                                   : "an RTD file (.rtd)"));
    // It has the container of RGL files.
    Bytes tensors = fuzz::rglSeed();
    tensors.resize(tensors.size() / 2);
    QVERIFY(named("y.PBSDF", tensors, "a polarimetric BSDF (.pbsdf)"));
    QVERIFY(named("fred.txt", bytesOf("type bsdf_data\nformat angles=deg bsdf=value scale=1\n0 0\n"), "a FRED BSDF"));
    QVERIFY(named("speos.bsdf180", bytesOf(std::string_view("OPTIS - BSDF180 file v1\n\0\1", 26)),
                  "an Ansys Speos .bsdf180 file, whose binary layout is not published"));
    QVERIFY(named("speos.coated", bytesOf("OPTIS - Coated surface file v2\n"),
                  "an Ansys Speos file other than .anisotropicbsdf and .brdf"));
  }

  /// Where it is known what is wrong, the message is one line, without what other formats expect.
  void oneLineSaysWhatIsWrong() {
    const auto messageOf = [&](const std::filesystem::path& path) {
      return errorOf([&] { materials::readMaterial(path); });
    };
    const auto empty = writeFile("materials/empty.binary", {});
    QCOMPARE(messageOf(empty), empty.string() + ": the file is empty, expected a material");
    Bytes table = fileOf(formats::merlFormat);
    const std::size_t whole = table.size();
    table.resize(whole - 100);
    const auto shortened = writeFile("materials/short.binary", table);
    QCOMPARE(messageOf(shortened), shortened.string() + ": the file is truncated: " + std::to_string(whole - 100) +
                                       " bytes of " + std::to_string(whole) + " (MERL)");
    table.resize(whole + 100);
    const auto longer = writeFile("materials/long.binary", table);
    QVERIFY(contains(messageOf(longer), "it matches no format that Gonio supports\n  MERL: "));
  }

  /// Three formats share the suffix .bsdf; training sets take measured files by what they are.
  void sharedSuffixIsDecidedByTheContent() {
    for (const MaterialFormat* format : {&formats::rglFormat, &formats::zemaxFormat, &formats::lightToolsFormat}) {
      const auto path = writeFile("materials/shared.bsdf", fileOf(*format));
      QVERIFY(materials::formatOfFile(path) == format);
      QCOMPARE(materials::readMaterial(path).source.format, std::string(format->name));
    }
    QVERIFY(materials::formatBySuffix("x.bsdf") == &formats::rglFormat);
  }

  /// A file that begins like one of a format is reported as a broken file of that format alone.
  void brokenFileIsReportedByItsFormat() {
    Bytes bytes = fuzz::rglSeed();
    bytes.resize(bytes.size() / 2);
    const auto path = writeFile("materials/half.bsdf", bytes);
    const std::string error = errorOf([&] { materials::readMaterial(path); });
    QVERIFY2(contains(error, "half.bsdf: RGL: found") && !contains(error, "MERL"), error.c_str());
  }
};

GONIO_TEST(MaterialFormatsTest)
}  // namespace material_formats_test

#include "material_formats_test.moc"
