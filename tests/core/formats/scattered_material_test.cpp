// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/scattered_samples.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/brdf/data_transform.h"
#include "core/materials/basis_file.h"
#include "core/math/parallel.h"
#include "core/models/registry.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/test_program.h"

namespace scattered_material_test {
using namespace gonio;
using namespace gonio::test;
using formats::ScatteredSamples;

/// A glossy material that is none of the bundled ones: diffuse colour and a Blinn-Phong lobe.
Rgb glossy(const Direction& wi, const Direction& wo) {
  const double cosH = std::max(0.0, glm::normalize(wi + wo).z);
  return Rgb(0.3, 0.1, 0.05) / pi + Rgb(0.8 * std::pow(cosH, 60));
}

/// Every second pair near the mirror direction.
std::vector<DirectionPair> pairsAboutTheHighlight(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-0.15, 0.15);
  std::vector<DirectionPair> pairs;
  while (pairs.size() < count) {
    DirectionPair pair{randomUpper(random), randomUpper(random)};
    if (pairs.size() % 2 == 0)
      pair.wo = glm::normalize(Direction(-pair.wi.x + uniform(random), -pair.wi.y + uniform(random), pair.wi.z));
    if (pair.wi.z > 0.2 && pair.wo.z > 0.2) pairs.push_back(pair);
  }
  return pairs;
}

ScatteredSamples measured(const std::vector<DirectionPair>& pairs) {
  ScatteredSamples samples;
  for (const DirectionPair& pair : pairs) samples.add(pair, glossy(pair.wi, pair.wo));
  return samples;
}

materials::Material materialOf(const ScatteredSamples& samples) {
  materials::Material material;
  formats::setScattered(samples, {}, material);
  return material;
}

/// Root mean square of the logarithm of what the cosines leave of the values, as the reconstruction counts errors.
double logError(const Brdf& brdf, const std::vector<DirectionPair>& pairs) {
  double squares = 0;
  for (const DirectionPair& pair : pairs)
    for (int channel = 0; channel < 3; ++channel) {
      const double weight = cosineWeight(pair.wi.z, pair.wo.z);
      const double ratio = (brdf.evaluate(pair.wi, pair.wo)[channel] * weight + 1e-3) /
                           (glossy(pair.wi, pair.wo)[channel] * weight + 1e-3);
      squares += std::log(ratio) * std::log(ratio);
    }
  return std::sqrt(squares / double(3 * pairs.size()));
}

std::string noteWith(const materials::Material& material, const std::string& part) {
  for (const std::string& note : material.source.notes)
    if (contains(note, part)) return note;
  return {};
}

/// F of "to a factor of F (root mean square)".
double statedFactor(const materials::Material& material) {
  const std::string note = noteWith(material, "leave-one-out error"), before = "a factor of ";
  return std::stod(note.substr(note.find(before) + before.size()));
}

class ScatteredMaterialTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// At directions that were not measured, and in the mean not worse than the notes state.
  void pointsBecomeTheMaterial() {
    const std::vector<DirectionPair> others = pairsAboutTheHighlight(2000, 2);
    double last = 1;
    for (const std::size_t count : {30, 300}) {
      const materials::Material material = materialOf(measured(pairsAboutTheHighlight(count, 1)));
      QVERIFY(material.brdf == material.table && material.table->grid() == HalfDifferenceGrid{});
      QVERIFY(material.brdf->isIsotropic() && material.brdf->isReciprocal());
      QCOMPARE(material.source.grid, std::vector<int>{int(count)});
      const double error = logError(*material.brdf, others);
      QVERIFY2(error < (count == 30 ? 0.5 : 0.2), std::to_string(error).c_str());
      QVERIFY(error < last);
      QVERIFY2(std::exp(error) < 1.3 * statedFactor(material), std::to_string(statedFactor(material)).c_str());
      last = error;
    }
  }

  /// Points at one node are averaged, those that no bundled material has values for are left out, and all are counted.
  void notesCountThePoints() {
    ScatteredSamples samples;
    const DirectionPair pair{fromSpherical(0.5, 0), fromSpherical(0.5, 2)};
    for (const double value : {0.1, 0.3}) samples.add(pair, Rgb(value));
    samples.add({fromSpherical(0.2, 0), fromSpherical(0.9, 1)}, Rgb(0.2, -1, 0.2));
    samples.add({fromSpherical(1.6, 0), fromSpherical(0.5, 2)}, Rgb(1));
    const materials::Material material = materialOf(samples);
    QVERIFY(contains(noteWith(material, "nodes"), "3 samples at 2 grid nodes are used"));
    QVERIFY(contains(noteWith(material, "at or below the horizon"), "1 samples"));
    QVERIFY(contains(noteWith(material, "negative"), "1 negative values were set to 0"));
    ScatteredSamples mean;
    mean.add(pair, Rgb(0.2));
    mean.add(samples.directions[2], samples.values[2]);
    QVERIFY(std::ranges::equal(materialOf(mean).table->values(), material.table->values()));
  }

  void deviationsCount() {
    ScatteredSamples samples = measured(pairsAboutTheHighlight(40, 3));
    const materials::Material without = materialOf(samples);
    samples.standardDeviations.assign(samples.values.size(), Rgb(1e6));
    const materials::Material drowned = materialOf(samples);
    const DirectionPair pair = samples.directions[1];
    const double truth = glossy(pair.wi, pair.wo).x;
    QVERIFY(std::abs(without.brdf->evaluate(pair.wi, pair.wo).x - truth) <
            std::abs(drowned.brdf->evaluate(pair.wi, pair.wo).x - truth));
  }

  void manyPointsAreThinnedEvenly() {
    ScatteredSamples samples = measured(pairsAboutTheHighlight(20000, 4));
    const materials::Material material = materialOf(samples);
    QVERIFY(contains(noteWith(material, "nodes are used"), "at 8192 grid nodes"));
    QVERIFY(contains(noteWith(material, "left out"), "the others to limit the number of nodes"));
    QVERIFY(logError(*material.brdf, pairsAboutTheHighlight(500, 5)) < 0.2);
  }

  /// Black and very bright points side by side, of which the components alone would make values of millions.
  void valuesStayWithinThoseOfMaterials() {
    const auto basis = materials::bundledBasis();
    float largest = 0;
    for (const float value : basis->largest) largest = std::max(largest, value);
    ScatteredSamples samples;
    for (const DirectionPair& pair : scatteredPairs(205)) samples.add(pair, {0.2, pair.wi.z, pair.wi.x * pair.wo.x});
    const materials::Material material = materialOf(samples);
    for (const glm::vec3& value : material.table->values())
      for (int channel = 0; channel < 3; ++channel) QVERIFY(value[channel] <= largest);
    QVERIFY(contains(noteWith(material, "limited"), "to the maximum of the bundled materials"));
  }

  void nothingToLearnFromIsRefused() {
    QVERIFY(contains(errorOf([] { materialOf({}); }), "found 0 samples, expected at least one"));
    // Light and viewer all but opposite: no half vector that a table holds.
    ScatteredSamples grazing;
    grazing.add({glm::normalize(Direction(1, 0, 1e-9)), glm::normalize(Direction(-1, 0, 1e-9))}, Rgb(1));
    const std::string error = errorOf([&] { materialOf(grazing); });
    QVERIFY2(error.empty() || contains(error, "away from the horizon"), error.c_str());
    std::stop_source stop;
    stop.request_stop();
    materials::Material material;
    QVERIFY_EXCEPTION_THROWN(formats::setScattered(measured(scatteredPairs(10)), {stop.get_token(), {}}, material),
                             Cancelled);
  }

  void sameBitsForAnyNumberOfThreads() {
    const ScatteredSamples samples = measured(pairsAboutTheHighlight(100, 6));
    const materials::Material many = materialOf(samples);
    const ThreadLimit one(1);
    QVERIFY(std::ranges::equal(materialOf(samples).table->values(), many.table->values()));
  }
};

GONIO_TEST(ScatteredMaterialTest)
}  // namespace scattered_material_test

#include "scattered_material_test.moc"
