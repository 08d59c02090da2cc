// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/range_coder.h"

#include <QTest>
#include <array>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace range_coder_test {
using namespace gonio;
using namespace gonio::dictionary;

struct Bit {
  int context;  ///< -1: even
  bool value;
};

std::vector<Bit> randomBits(std::size_t count, std::span<const double> probabilities, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Bit> bits;
  for (std::size_t i = 0; i < count; ++i) {
    const int context = int(random() % (probabilities.size() + 1)) - 1;
    bits.push_back({context, unit(random) < (context < 0 ? 0.5 : probabilities[std::size_t(context)])});
  }
  return bits;
}

template <typename Coder>
bool code(Coder& coder, std::vector<AdaptiveBit>& contexts, const Bit& bit) {
  return bit.context < 0 ? coder.directBit(bit.value) : coder.bit(contexts[std::size_t(bit.context)], bit.value);
}

std::vector<std::byte> encoded(const std::vector<Bit>& bits, std::size_t contextCount) {
  RangeEncoder encoder;
  std::vector<AdaptiveBit> contexts(contextCount);
  for (const Bit& bit : bits) code(encoder, contexts, bit);
  return encoder.finish();
}

void readNumbers(std::span<const std::byte> bytes) {
  RangeDecoder decoder(bytes);
  for (int i = 0; i < 10; ++i) decoder.number(0, 32);
}

class RangeCoderTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Also where one value is nearly certain, which gives long runs of carries, and with no bits at all.
  void readsWhatWasWritten() {
    const std::array<double, 5> probabilities{0.5, 0.02, 0.9, 0.001, 0.9999};
    for (const std::size_t count : {0, 1, 2, 7, 100, 200000}) {
      const std::vector<Bit> bits = randomBits(count, probabilities, count + 1);
      const std::vector<std::byte> bytes = encoded(bits, probabilities.size());
      RangeDecoder decoder(bytes);
      std::vector<AdaptiveBit> contexts(probabilities.size());
      for (const Bit& bit : bits) QCOMPARE(code(decoder, contexts, {bit.context, false}), bit.value);
      QCOMPARE(decoder.left(), std::size_t(0));
    }
  }

  /// The bytes are those of the entropy, but for 2 % that learning and the memory of the estimates cost.
  void sizeIsTheEntropy() {
    const std::array<double, 3> probabilities{0.5, 0.1, 0.97};
    const std::vector<Bit> bits = randomBits(200000, probabilities, 3);
    double entropy = 0;
    for (const Bit& bit : bits) {
      const double one = bit.context < 0 ? 0.5 : probabilities[std::size_t(bit.context)];
      entropy -= std::log2(bit.value ? one : 1 - one);
    }
    const double size = 8.0 * double(encoded(bits, probabilities.size()).size());
    QVERIFY2(size > 0.99 * entropy && size < 1.02 * entropy, qPrintable(QString("%1").arg(size / entropy)));
  }

  void numbersOfAllWidths() {
    RangeEncoder encoder;
    for (int bits = 0; bits <= 32; ++bits) encoder.number(std::uint32_t((std::uint64_t(1) << bits) * 2 / 3), bits);
    const std::vector<std::byte> bytes = encoder.finish();
    RangeDecoder decoder(bytes);
    for (int bits = 0; bits <= 32; ++bits)
      QCOMPARE(decoder.number(0, bits), std::uint32_t((std::uint64_t(1) << bits) * 2 / 3));
  }

  void endsTooEarlyIsAnError() {
    RangeEncoder encoder;
    for (int i = 0; i < 10; ++i) encoder.number(0x12345678, 32);
    const std::vector<std::byte> bytes = encoder.finish();
    for (std::size_t size = 0; size < bytes.size(); ++size)
      QVERIFY_EXCEPTION_THROWN(readNumbers({bytes.data(), size}), Error);
    readNumbers(bytes);
  }
};

GONIO_TEST(RangeCoderTest)
}  // namespace range_coder_test

#include "range_coder_test.moc"
