// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/code_packing.h"

#include <QTest>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "core/dictionary/mode_products.h"
#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace quantised_code_test {
using namespace gonio;
using namespace gonio::dictionary;

constexpr HalfDifferenceGrid grid{90, 90, 180, true};

/// Coefficients as materials have them: most at low indices, sizes over three decades, and the channels alike.
SparseCode typicalCode(std::size_t coefficients, std::array<int, 3> dictionaries, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::geometric_distribution<std::uint32_t> near0(0.25), near1(0.12), near2(0.12);
  std::normal_distribution<float> normal;
  SparseCode code{.grid = grid, .transform = DataTransform::logPlus, .channels = {}};
  std::set<std::uint32_t> indices;
  while (indices.size() < coefficients) {
    const std::uint32_t l0 = std::min(near0(random), 179U), l1 = std::min(near1(random), 89U),
                        l2 = std::min(near2(random), 89U);
    indices.insert(l0 + 180 * (l1 + 90 * l2));
  }
  for (std::size_t c = 0; c < 3; ++c) {
    ChannelCode& channel = code.channels[c];
    channel.dictionary = dictionaries[c];
    channel.highest = 1 + float(c);
  }
  for (const std::uint32_t index : indices) {
    const float value = std::pow(10.0f, 0.6f * normal(random)) * (normal(random) < 0 ? -1.0f : 1.0f);
    for (ChannelCode& channel : code.channels)
      channel.coefficients.push_back({index, value * (1 + 0.1f * normal(random))});
  }
  for (ChannelCode& channel : code.channels) std::ranges::sort(channel.coefficients, isLarger<float>);
  return code;
}

SparseCode expanded(const std::vector<std::byte>& bytes) {
  SparseCode code{.grid = grid, .transform = DataTransform::logPlus, .channels = {}};
  expandChannels(bytes, code);
  return code;
}

void compare(const SparseCode& a, const SparseCode& b) {
  for (std::size_t c = 0; c < 3; ++c) {
    const ChannelCode &first = a.channels[c], &second = b.channels[c];
    QCOMPARE(first.dictionary, second.dictionary);
    QCOMPARE(first.step, second.step);
    QCOMPARE(first.highest, second.highest);
    QCOMPARE(first.coefficients.size(), second.coefficients.size());
    for (std::size_t i = 0; i < first.coefficients.size(); ++i) {
      QCOMPARE(first.coefficients[i].index, second.coefficients[i].index);
      QCOMPARE(first.coefficients[i].value, second.coefficients[i].value);
    }
  }
}

SparseCode oneCoefficient(std::uint32_t index, float value) {
  SparseCode code{.grid = grid, .transform = DataTransform::logPlus, .channels = {}};
  for (ChannelCode& channel : code.channels)
    channel = {.dictionary = 255, .coefficients = {{index, value}}, .highest = 3};
  return code;
}

class QuantisedCodeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void readsWhatWasWritten() {
    for (const auto& dictionaries : {std::array{7, 7, 7}, std::array{1, 2, 2}, std::array{0, 1, 2}})
      for (const std::size_t count : {1, 2, 40, 700, 5000}) {
        const SparseCode code = quantised(typicalCode(count, dictionaries, count));
        const std::vector<std::byte> bytes = compressChannels(code);
        compare(expanded(bytes), code);
        QVERIFY(compressChannels(expanded(bytes)) == bytes);  // no loss from one file to the next
      }
  }

  /// No coefficient, the first and the last index, a whole row, and values of one size or one sign.
  void unusualCodes() {
    SparseCode empty{.grid = grid, .transform = DataTransform::logPlus, .channels = {}};
    compare(expanded(compressChannels(empty)), empty);
    for (const std::uint32_t index : {0U, std::uint32_t(grid.size() - 1)})
      for (const float value : {1e-30f, -1e30f}) {
        const SparseCode code = quantised(oneCoefficient(index, value));
        compare(expanded(compressChannels(code)), code);
      }
    SparseCode row = oneCoefficient(0, 1);
    for (ChannelCode& channel : row.channels)
      for (std::uint32_t l0 = 1; l0 < 180; ++l0) channel.coefficients.push_back({l0, 1});
    row = quantised(row);
    compare(expanded(compressChannels(row)), row);
    // A channel that has no coefficients between two others.
    SparseCode gap = typicalCode(50, {3, 3, 3});
    gap.channels[1].coefficients.clear();
    gap = quantised(gap);
    compare(expanded(compressChannels(gap)), gap);
  }

  void errorIsHalfAStep() {
    const SparseCode exact = typicalCode(500, {1, 1, 1}), code = quantised(exact);
    for (std::size_t c = 0; c < 3; ++c) {
      const ChannelCode &before = exact.channels[c], &after = code.channels[c];
      QCOMPARE(after.coefficients.size(), before.coefficients.size());
      QVERIFY(std::abs(after.step / std::abs(before.coefficients.back().value) - 1.4f) < 1e-5f);
      std::map<std::uint32_t, float> values;
      for (const auto& coefficient : before.coefficients) values[coefficient.index] = coefficient.value;
      for (const auto& [index, value] : after.coefficients) {
        QVERIFY(std::abs(value - values[index]) <= 0.5001f * after.step);
        const double level = double(value) / after.step;
        QVERIFY(std::abs(level - std::round(level)) < 1e-6 * std::abs(level));
      }
    }
    // Quantised codes stay as they are, also with fewer coefficients.
    compare(quantised(code), code);
    compare(expanded(compressChannels(code.truncated(100))), code.truncated(100));
    // A value that is tiny beside the others does not set the step.
    SparseCode wide = typicalCode(50, {1, 1, 1});
    for (ChannelCode& channel : wide.channels) channel.coefficients.push_back({5000, 1e-25f});
    for (const ChannelCode& channel : quantised(wide).channels) QCOMPARE(channel.coefficients.size(), std::size_t(50));
  }

  /// A third of the bytes of half precision for such codes; less where the channels have dictionaries of their own.
  void isSmall() {
    const SparseCode alike = typicalCode(700, {4, 4, 4}), apart = typicalCode(700, {4, 5, 6});
    const double half = double(packChannels(alike, CodePrecision::half).size());
    const double ofAlike = double(compressChannels(alike).size()), ofApart = double(compressChannels(apart).size());
    QVERIFY2(ofAlike < 0.4 * half, qPrintable(QString::number(ofAlike / half)));
    QVERIFY2(ofAlike < 0.8 * ofApart, qPrintable(QString::number(ofAlike / ofApart)));
  }

  void damagedBytesAreErrors() {
    const std::vector<std::byte> bytes = compressChannels(typicalCode(60, {2, 2, 2}));
    for (std::size_t size = 0; size < bytes.size(); ++size)
      QVERIFY_EXCEPTION_THROWN(expanded({bytes.begin(), bytes.begin() + std::ptrdiff_t(size)}), Error);
    std::vector<std::byte> longer = bytes;
    longer.push_back({});
    QVERIFY_EXCEPTION_THROWN(expanded(longer), Error);
    // Coefficients of step 0 would all be 0, and not be written again.
    std::vector<std::byte> withoutStep = bytes;
    std::fill_n(withoutStep.begin() + 1, sizeof(float), std::byte(0));
    QVERIFY_EXCEPTION_THROWN(expanded(withoutStep), Error);
    // Whatever is read from flipped bits is a code of the grid, or an error.
    std::mt19937_64 random(5);
    for (int i = 0; i < 500; ++i) {
      std::vector<std::byte> damaged = bytes;
      damaged[random() % damaged.size()] ^= std::byte(1 << random() % 8);
      try {
        for (const ChannelCode& channel : expanded(damaged).channels)
          for (const auto& coefficient : channel.coefficients)
            QVERIFY(coefficient.index < grid.size() && std::isfinite(coefficient.value));
      } catch (const Error&) {
      }
    }
  }

  /// As many coefficients as fit.
  void truncatedToAllBudgets() {
    const SparseCode code = typicalCode(900, {1, 1, 2});
    for (const std::size_t budget : {50, 300, 1000, 100000}) {
      const SparseCode fits = truncatedToBytes(code, budget);
      QVERIFY(compressChannels(fits).size() <= budget);
      if (fits.coefficients() < 900) QVERIFY(compressChannels(code.truncated(fits.coefficients() + 1)).size() > budget);
    }
    QCOMPARE(truncatedToBytes(code, 10).coefficients(), std::size_t(0));
  }
};

GONIO_TEST(QuantisedCodeTest)
}  // namespace quantised_code_test

#include "quantised_code_test.moc"
