// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/neural.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "core/materials/bundled_library.h"
#include "tests/core/io/test_files.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace neural_file_test {
using namespace gonio;
using namespace gonio::formats;
using namespace gonio::materials;

std::array<float, NeuralBrdf::weightCount> someWeights() {
  std::array<float, NeuralBrdf::weightCount> weights;
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = std::sin(float(i)) / 3;
  return weights;
}

/// The network written out in double, from its published description alone: x -> relu(x W1 + b1) -> relu(. W2 + b2) ->
/// exp(. W3 + b3) - 1.
Rgb byTheFormula(std::span<const float> w, const DirectionPair& pair) {
  const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
  const double phi = at.phiD < 0 ? at.phiD + pi : at.phiD;
  std::vector<double> x{std::sin(at.thetaH),
                        0,
                        std::cos(at.thetaH),
                        std::sin(at.thetaD) * std::cos(phi),
                        std::sin(at.thetaD) * std::sin(phi),
                        std::cos(at.thetaD)};
  std::size_t begin = 0;
  for (const std::size_t size : {21, 21, 3}) {
    std::vector<double> y(size);
    for (std::size_t o = 0; o < size; ++o) {
      y[o] = w[begin + x.size() * size + o];
      for (std::size_t i = 0; i < x.size(); ++i) y[o] += x[i] * w[begin + i * size + o];
      if (size > 3) y[o] = std::max(0.0, y[o]);
    }
    begin += (x.size() + 1) * size;
    x = y;
  }
  return {std::max(0.0, std::exp(x[0]) - 1), std::max(0.0, std::exp(x[1]) - 1), std::max(0.0, std::exp(x[2]) - 1)};
}

class NeuralFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void roundTrip() {
    const auto weights = someWeights();
    const auto path = test::outputPath("neural/round_trip.nbrdf");
    writeNeural(weights, path);
    QCOMPARE(std::filesystem::file_size(path), neuralFileBytes);
    QCOMPARE(neuralFileBytes, std::size_t(2712));
    QVERIFY(std::ranges::equal(readNeural(path).weights(), weights));
    const Material material = readMaterial(path);
    QVERIFY(!material.table && material.brdf->isReciprocal());
    QCOMPARE(material.source.format, std::string("neural BRDF"));
  }

  /// The networks of Sztrajman et al. that the library contains.
  void publishedNetworks() {
    std::mt19937_64 random(7);
    for (std::size_t i = 0; i < nearMeasuredMaterials().size(); i += 9) {
      const NearMeasuredMaterial& copy = nearMeasuredMaterials()[i];
      const NeuralBrdf brdf(copy.weights);
      for (int n = 0; n < 200; ++n) {
        const DirectionPair pair{test::randomUpper(random), test::randomUpper(random)};
        const Rgb found = brdf.evaluate(pair.wi, pair.wo), expected = byTheFormula(copy.weights, pair);
        for (int c = 0; c < 3; ++c)
          QVERIFY2(std::abs(found[c] - expected[c]) < 1e-4 * (1 + expected[c]), copy.name.c_str());
      }
    }
  }

  void damagedFilesAreRefused() {
    const auto path = test::outputPath("neural/damaged.nbrdf");
    writeNeural(someWeights(), path);
    test::Bytes bytes = test::readFile(path);
    const auto error = [&](const test::Bytes& changed) {
      return test::errorOf([&] { readNeural(test::writeFile("neural/changed.nbrdf", changed)); });
    };
    test::Bytes changed(bytes.begin(), bytes.end() - 1);
    QVERIFY(test::contains(error(changed), "changed.nbrdf"));
    changed = bytes;
    changed.push_back(std::byte(0));
    QVERIFY(!error(changed).empty());
    changed = bytes;
    changed[0] = std::byte('X');
    QVERIFY(test::contains(error(changed), "signature missing"));
    changed = bytes;
    changed[8] = std::byte(2);
    QVERIFY(test::contains(error(changed), "version"));
    changed = bytes;
    const float infinity = std::numeric_limits<float>::infinity();
    std::memcpy(changed.data() + 12 + 4 * 5, &infinity, 4);
    QVERIFY(test::contains(error(changed), "weight"));
  }
};

GONIO_TEST(NeuralFileTest)
}  // namespace neural_file_test

#include "neural_file_test.moc"
