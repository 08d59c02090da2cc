// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/dictionary_file.h"

#include <QTest>

#include "core/dictionary/decode.h"
#include "core/dictionary/encode.h"
#include "core/formats/code.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/core/io/test_files.h"
#include "tests/support/code_files.h"
#include "tests/support/test_program.h"

namespace dictionary_file_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;
using gonio::test::errorOf;
using gonio::test::outputPath;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool sameValues(const TabulatedBrdf& a, const TabulatedBrdf& b) {
  return std::equal(a.values().begin(), a.values().end(), b.values().begin(), b.values().end());
}

/// Of the file with the bytes at `at` replaced.
template <typename Read, typename Number>
std::string errorWith(const std::filesystem::path& file, std::size_t at, Number number, const Read& read) {
  gonio::test::Bytes bytes = gonio::test::readFile(file);
  std::memcpy(bytes.data() + at, &number, sizeof number);
  const auto changed = gonio::test::writeFile("dictionary/changed", bytes);
  return errorOf([&] { read(changed); });
}

class DictionaryFileTest : public QObject {
  Q_OBJECT
 private:
  static std::filesystem::path writtenEnsemble() {
    Ensemble ensemble = randomEnsemble(3);
    ensemble.learnedFrom = {"chrome", "a \"name\" of its own"};
    const auto path = outputPath("dictionary/three.dictionary");
    materials::writeDictionary(ensemble, path);
    return path;
  }

 private Q_SLOTS:
  /// Single precision in the file, orthonormal again when it is read.
  void dictionaryRoundTrip() {
    const auto path = writtenEnsemble();
    const auto named = materials::readDictionary(path);
    const Ensemble expected = randomEnsemble(3);
    QVERIFY(named->ensemble.grid == expected.grid);
    QCOMPARE(named->ensemble.learnedFrom[1], std::string("a \"name\" of its own"));
    QCOMPARE(named->ensemble.dictionaries.size(), std::size_t(3));
    QVERIFY(orthonormalityError(named->ensemble) < 1e-12);
    for (std::size_t d = 0; d < 3; ++d) {
      QCOMPARE(named->ensemble.dictionaries[d].sparsity, expected.dictionaries[d].sparsity);
      for (std::size_t mode = 0; mode < 3; ++mode)
        QVERIFY(
            (named->ensemble.dictionaries[d].modes[mode] - expected.dictionaries[d].modes[mode]).cwiseAbs().maxCoeff() <
            1e-6);
    }
    QVERIFY(named->id != 0);
    QCOMPARE(materials::readDictionary(path)->id, named->id);
    const std::size_t numbers = 3 * (16 * 16 + 12 * 12 + 12 * 12) * sizeof(float);
    QVERIFY(std::filesystem::file_size(path) < numbers + 300 && std::filesystem::file_size(path) > numbers);
  }

  void brokenDictionariesAreToldWithWhatWasFound() {
    const auto path = writtenEnsemble();
    const auto read = [](const std::filesystem::path& file) { materials::readDictionary(file); };
    QVERIFY(contains(errorWith(path, 0, 'X', read), "not a dictionary file (signature missing)"));
    QVERIFY(contains(errorWith(path, 0, 'X', read), "changed"));
    QVERIFY(contains(errorWith(path, 8, 9u, read), "the version is 9, expected 1"));
    QVERIFY(contains(errorWith(path, 12, 0xffffffffu, read), "the description has 4294967295 bytes"));
    QVERIFY(contains(errorWith(path, 16, '?', read), "not JSON"));
    const std::size_t size = std::filesystem::file_size(path);
    QVERIFY(contains(errorWith(path, size - 4, 0.5f, read), "not orthonormal"));
    QVERIFY(contains(errorWith(path, size - 4, std::numeric_limits<float>::quiet_NaN(), read), "not finite"));
    gonio::test::Bytes bytes = gonio::test::readFile(path);
    const std::string expected = " bytes, expected " + std::to_string(size);
    bytes.push_back({});
    QVERIFY(contains(errorOf([&] { read(gonio::test::writeFile("dictionary/longer", bytes)); }),
                     "the size of the file is " + std::to_string(size + 1) + expected));
    bytes.resize(bytes.size() - 2);
    QVERIFY(contains(errorOf([&] { read(gonio::test::writeFile("dictionary/shorter", bytes)); }),
                     "the size of the file is " + std::to_string(size - 1) + expected));
  }

  /// What a checkpoint gives back goes on with the same bits.
  void checkpointRoundTrip() {
    const TrainingMaterials materials = ggxMaterials(5);
    const TrainingOptions options{.dictionaries = 2, .sparsities = {4, 8}, .signals = {}, .iterations = 3};
    const auto path = outputPath("dictionary/training.checkpoint");
    int rounds = 0;
    const TrainingResult whole = train(materials, options, {}, nullptr, [&](const TrainingState& state) {
      if (++rounds == 2) materials::writeCheckpoint(state, "five materials", path);
    });
    const TrainingState state = materials::readCheckpoint("five materials", path);
    const TrainingResult resumed = train(materials, options, {}, &state);
    QCOMPARE(resumed.state.errors, whole.state.errors);
    for (std::size_t d = 0; d < 4; ++d)
      for (std::size_t mode = 0; mode < 3; ++mode)
        QVERIFY(resumed.ensemble.dictionaries[d].modes[mode] == whole.ensemble.dictionaries[d].modes[mode]);
    QVERIFY(contains(errorOf([&] { materials::readCheckpoint("six materials", path); }), "found five materials"));
    gonio::test::Bytes bytes = gonio::test::readFile(path);
    bytes.resize(bytes.size() / 2);
    const auto cut = gonio::test::writeFile("dictionary/cut.checkpoint", bytes);
    QVERIFY(contains(errorOf([&] { materials::readCheckpoint("five materials", cut); }), "cut.checkpoint"));
  }

  /// Half the bytes; orthonormal again, near the ensemble that was written.
  void halfPrecision() {
    const auto single = materials::readDictionary(writtenEnsemble());
    const auto path = outputPath("dictionary/half.dictionary");
    materials::writeDictionary(single->ensemble, path, true);
    const auto half = materials::readDictionary(path);
    QVERIFY(half->id != single->id);
    QCOMPARE(half->ensemble.learnedFrom, single->ensemble.learnedFrom);
    QVERIFY(orthonormalityError(half->ensemble) < 1e-10);
    std::size_t numbers = 0;
    for (std::size_t d = 0; d < half->ensemble.dictionaries.size(); ++d)
      for (std::size_t mode = 0; mode < 3; ++mode) {
        const Eigen::MatrixXd &a = single->ensemble.dictionaries[d].modes[mode],
                              &b = half->ensemble.dictionaries[d].modes[mode];
        numbers += std::size_t(a.size());
        QVERIFY((a - b).cwiseAbs().maxCoeff() < 1e-3);
      }
    const auto size = std::filesystem::file_size(writtenEnsemble()) - std::filesystem::file_size(path);
    QVERIFY(size > 2 * numbers - 40 && size <= 2 * numbers);
    QVERIFY(contains(errorWith(path, std::uint32_t(std::filesystem::file_size(path) - 2), std::uint16_t(0x7e00),
                               [](const std::filesystem::path& changed) { materials::readDictionary(changed); }),
                     "not finite"));
  }

  void codeRoundTrip() {
    const auto dictionary = materials::readDictionary(writtenEnsemble());
    const SparseCode code = Encoder(dictionary->ensemble).encode(*ggxMaterials(1).load(0), {.coefficients = 60}).code;
    const auto path = outputPath("dictionary/material.code");
    formats::writeCode(code, dictionary->id, path, CodePrecision::single);
    const formats::CodeFile file = formats::readCode(path);
    formats::checkDictionary(file, *dictionary);
    QVERIFY(file.code.transform == code.transform && file.code.grid == code.grid);
    QVERIFY(sameValues(*decode(dictionary->ensemble, file.code), *decode(dictionary->ensemble, code)));
    for (std::size_t c = 0; c < 3; ++c) QCOMPARE(file.code.channels[c].highest, code.channels[c].highest);
    const auto read = [](const std::filesystem::path& changed) { formats::readCode(changed); };
    QVERIFY(contains(errorWith(path, 8, std::uint16_t(7), read), "the version is 7, expected 1"));
    QVERIFY(contains(errorWith(path, 10, std::uint8_t(9), read), "the transform is 9"));
    QVERIFY(contains(errorWith(path, 12, std::uint16_t(0), read), "a count of nodes is 0"));
    // Another dictionary, as its id shows.
    formats::CodeFile other = file;
    ++other.dictionaryId;
    QVERIFY(contains(errorOf([&] { formats::checkDictionary(other, *dictionary); }), "another dictionary"));
  }

  /// Files of version 1: what is read is written with the same bytes.
  void codeFilesKeepTheirBytes() {
    for (const auto& path : gonio::test::codeFiles()) {
      const formats::CodeFile file = formats::readCode(path);
      QVERIFY(std::ranges::equal(formats::encodeCode(file.code, file.dictionaryId, file.precision),
                                 gonio::test::readFile(path)));
    }
  }

  /// The bundled one is over the grid of MERL tables, and codes over it are materials.
  void codesOverTheBundledDictionaryOpen() {
    const auto dictionary = materials::bundledEnsemble();
    QVERIFY(dictionary->ensemble.grid == HalfDifferenceGrid());
    QVERIFY(orthonormalityError(dictionary->ensemble) < 1e-10);
    QVERIFY(!dictionary->ensemble.learnedFrom.empty());
    SparseCode code{.grid = {}, .transform = DataTransform::logPlus, .channels = {}};
    for (ChannelCode& channel : code.channels) channel.coefficients = {{0, 30.0f}, {200, -2.0f}};
    const auto path = outputPath("dictionary/bundled.code");
    formats::writeCode(code, dictionary->id, path);
    const materials::Material material = materials::readMaterial(path);
    QCOMPARE(material.source.format, std::string("sparse code"));
    QCOMPARE(material.source.description, std::string("2 coefficients per channel, transform log-plus"));
    QCOMPARE(material.name, std::string("bundled"));
    QVERIFY(material.code && material.code->channels[2].coefficients.size() == 2);
    QVERIFY(sameValues(*material.table, *decode(dictionary->ensemble, formats::readCode(path).code)));
    formats::writeCode(code, dictionary->id + 1, path);
    QVERIFY(contains(errorOf([&] { materials::readMaterial(path); }),
                     "bundled.code: the code was encoded with another dictionary"));
  }

  /// Every bundled one is found by its id, the hash of its file, and decodes the codes that have this id.
  void bundledDictionariesAreFoundByTheirIds() {
    SparseCode code{.grid = {}, .transform = DataTransform::logPlus, .channels = {}};
    for (ChannelCode& channel : code.channels) channel.coefficients = {{0, 30.0f}, {200, -2.0f}};
    const auto path = outputPath("dictionary/of_id.code");
    for (const std::uint64_t id : materials::bundledIds()) {
      const auto dictionary = materials::bundledEnsemble(id);
      QVERIFY(dictionary);
      QCOMPARE(dictionary->id, id);
      QVERIFY(materials::bundledEnsemble(id) == dictionary);
      formats::writeCode(code, id, path);
      const materials::Material material = materials::readMaterial(path);
      QVERIFY(material.dictionary == dictionary);
      QVERIFY(sameValues(*material.table, *decode(dictionary->ensemble, formats::readCode(path).code)));
    }
    QCOMPARE(materials::bundledEnsemble()->id, materials::bundledIds().front());
    QVERIFY(!materials::bundledEnsemble(materials::bundledIds().front() + 1));
  }
};

GONIO_TEST(DictionaryFileTest)
}  // namespace dictionary_file_test

#include "dictionary_file_test.moc"
