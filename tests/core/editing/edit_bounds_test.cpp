// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <random>

#include "core/brdf/tabulated_brdf.h"
#include "core/editing/edit.h"
#include "core/fitting/fit.h"
#include "core/materials/bundled_library.h"
#include "core/math/parallel.h"
#include "core/models/registry.h"
#include "core/sampling/directional_albedo.h"
#include "tests/support/test_program.h"

namespace edit_bounds_test {
using namespace gonio;
using namespace gonio::editing;
using models::ParameterSpec;
using models::ParameterValues;

class Randomness {
 public:
  explicit Randomness(std::uint64_t seed) : engine_(seed) {}
  double number() { return std::uniform_real_distribution<double>(0, 1)(engine_); }
  std::size_t below(std::size_t count) { return std::min(std::size_t(number() * double(count)), count - 1); }

  double value(const ParameterSpec& spec) {
    if (!spec.choices.empty()) return double(below(spec.choices.size()));
    const double low = number() < 0.1 ? spec.hardMin : spec.softMin,
                 high = number() < 0.1 ? spec.hardMax : spec.softMax;
    return spec.scale == models::ParameterScale::logarithmic && low > 0 ? low * std::pow(high / low, number())
                                                                        : low + (high - low) * number();
  }
  ParameterValues parameters(const models::ModelSpec& spec) {
    ParameterValues values;
    for (const ParameterSpec& one : spec.parameters) {
      const double x = value(one);
      values.values.push_back(one.perChannel ? Rgb(x, value(one), value(one)) : Rgb(x));
    }
    return values;
  }
  const models::Model& model() { return *models::allModels()[below(models::allModels().size())]; }

  /// Often near the horizon, at the pole, or mirrored.
  DirectionPair directions() {
    const auto direction = [&] {
      const double u = number(), height = number() < 0.2 ? 1e-9 * u : number() < 0.05 ? 1 : u;
      return fromSpherical(std::acos(height), 2 * pi * number());
    };
    const Direction wi = direction(), wo = direction();
    return number() < 0.2 ? DirectionPair{wi, {-wi.x, -wi.y, wi.z}} : DirectionPair{wi, wo};
  }

 private:
  std::mt19937_64 engine_;
};

Edit randomEdit(Randomness& random) {
  DifferentialEdit edit;
  edit.model = &random.model();
  edit.fitted = random.parameters(edit.model->spec());
  edit.edited = random.number() < 0.3 ? edit.fitted : random.parameters(edit.model->spec());
  if (random.number() < 0.5) edit.controls = random.parameters(artistControls());
  edit.composition = Composition(random.below(edit.model->hasLobes() ? 3 : 2));
  return {edit, "", random.number()};
}

class EditBoundsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// 1,000 materials with edits, each at 1,000 pairs of directions: any model edits any other, to any values.
  void editedValuesAreFiniteAndNotNegative() {
    constexpr std::size_t cases = 1000, directions = 1000;
    std::vector<std::string> faults(cases);
    parallelForBlocks(cases, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Randomness random(i);
        const models::Model& model = random.model();
        const std::shared_ptr<const Brdf> base = model.instantiate(random.parameters(model.spec()));
        const Edit edit = randomEdit(random);
        const auto edited = applyEdits(base, std::span(&edit, 1));
        std::vector<DirectionPair> pairs(directions);
        for (DirectionPair& pair : pairs) pair = random.directions();
        std::vector<Rgb> before(directions), after(directions);
        base->evaluate(pairs, before);
        edited->evaluate(pairs, after);
        for (std::size_t k = 0; k < directions; ++k)
          for (int c = 0; c < 3; ++c)
            if (std::isfinite(before[k][c]) && !(std::isfinite(after[k][c]) && after[k][c] >= 0))
              faults[i] = std::string(model.spec().id) + " edited by " +
                          std::string(std::get<DifferentialEdit>(edit.content).model->spec().id) + ", case " +
                          std::to_string(i);
      }
    });
    for (const std::string& fault : faults) QVERIFY2(fault.empty(), fault.c_str());
  }

  /// The roughness of published materials from a quarter to four times the fit, in the default composition.
  void roughnessAddsNoEnergy() {
    int judged = 0;
    for (const models::Model* model : {&models::ggx(), &models::layered()})
      for (const char* name :
           {"alum-bronze", "red-metallic-paint", "gold-paint", "blue-acrylic", "red-fabric", "nickel"}) {
        const auto found = std::ranges::find(materials::sgdFits(), name, &materials::SgdFit::name);
        QVERIFY(found != materials::sgdFits().end());
        const auto base = bakeTable(*models::findModel("sgd").instantiate(found->parameters),
                                    {.thetaHCount = 45, .thetaDCount = 30, .phiDCount = 60});
        DifferentialEdit change;
        change.model = model;
        change.fitted = change.edited = fitting::fit(*base, *model).parameters;
        change.composition = defaultComposition(*model);
        for (const double theta : {0.0, 0.5, 1.0, 1.3}) {
          if (maxChannel(directionalAlbedo(*base, theta)) > 1) continue;
          for (const double factor : {0.25, 0.5, 2.0, 4.0}) {
            change.controls.values[std::size_t(ArtistControl::roughness)] = Rgb(factor);
            const Edit edit{change};
            const double albedo = maxChannel(directionalAlbedo(*applyEdits(base, std::span(&edit, 1)), theta));
            QVERIFY2(albedo <= 1.05, qPrintable(QStringLiteral("%1 by %2, %3 times at %4 rad: %5")
                                                    .arg(name, model == &models::ggx() ? "ggx" : "layered")
                                                    .arg(factor)
                                                    .arg(theta)
                                                    .arg(albedo)));
            ++judged;
          }
        }
      }
    QVERIFY(judged > 120);
  }
};

GONIO_TEST(EditBoundsTest)
}  // namespace edit_bounds_test

#include "edit_bounds_test.moc"
