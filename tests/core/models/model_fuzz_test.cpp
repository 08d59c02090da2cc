// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <atomic>
#include <cmath>

#include "core/math/parallel.h"
#include "tests/core/models/model_test_support.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace model_fuzz_test {
using namespace gonio;
using namespace gonio::models;
using namespace gonio::models::test_support;

constexpr std::size_t pairsAMaterial = 50;

double drawNumber(const ParameterSpec& p, std::mt19937_64& random) {
  const double u = std::uniform_real_distribution<double>(0, 1)(random);
  if (!p.choices.empty()) return std::round(p.hardMax * u);
  switch (random() % 8) {
    case 0:
      return p.hardMin;
    case 1:
      return p.hardMax;
    case 2:
    case 3:
      return p.softMin + u * (p.softMax - p.softMin);
    default:
      return p.hardMin > 0 ? p.hardMin * std::pow(p.hardMax / p.hardMin, u) : p.hardMin + u * (p.hardMax - p.hardMin);
  }
}

/// Anywhere within the hard ranges, their ends included; on a logarithmic scale where the range is positive.
ParameterValues drawParameters(const ModelSpec& spec, std::mt19937_64& random) {
  ParameterValues values;
  for (const ParameterSpec& p : spec.parameters) {
    Rgb value(drawNumber(p, random));
    if (p.perChannel) value.y = drawNumber(p, random), value.z = drawNumber(p, random);
    values.values.push_back(value);
  }
  return values;
}

/// A million random sets of parameters and directions (long tests: a million for each model): values, densities and
/// draws are finite, and none is negative.
class ModelFuzzTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void finiteAndNotNegative() {
    const auto models = allModels();
    const std::size_t materials = (gonio::test::longTests() ? models.size() : 1) * 1'000'000 / pairsAMaterial;
    std::atomic<std::size_t> bad = 0;
    std::atomic<const Model*> culprit = nullptr;
    parallelForBlocks(materials, 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t material = begin; material < end; ++material) {
        std::mt19937_64 random(material);
        const Model& model = *models[material % models.size()];
        const auto brdf = model.instantiate(drawParameters(model.spec(), random));
        for (std::size_t n = 0; n < pairsAMaterial; ++n) {
          const DirectionPair pair = gonio::test::hardPair(random);
          const Rgb value = brdf->evaluate(pair.wi, pair.wo);
          bool good = true;
          for (int c = 0; c < 3; ++c) good = good && std::isfinite(value[c]) && value[c] >= 0;
          const double density = brdf->pdf(pair.wi, pair.wo);
          good = good && std::isfinite(density) && density >= 0;
          if (pair.wo.z > 0) {
            std::uniform_real_distribution<double> uniform(0, 1);
            const DirectionSample drawn = brdf->sample(pair.wo, {uniform(random), uniform(random), uniform(random)});
            good = good && std::isfinite(drawn.pdf) && drawn.pdf > 0 && drawn.wi.z > 0;
          }
          if (good) continue;
          ++bad;
          culprit = &model;
        }
      }
    });
    QVERIFY2(bad == 0, bad == 0 ? "" : culprit.load()->spec().id.data());
  }
};

GONIO_TEST(ModelFuzzTest)
}  // namespace model_fuzz_test

#include "model_fuzz_test.moc"
