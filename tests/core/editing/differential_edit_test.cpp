// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit.h"

#include <QTest>
#include <cfloat>
#include <cstring>
#include <random>

#include "core/math/parallel.h"
#include "core/models/registry.h"
#include "core/models/shader_arguments.h"
#include "tests/support/test_program.h"

namespace differential_edit_test {
using namespace gonio;
using namespace gonio::editing;

constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 20, .thetaDCount = 18, .phiDCount = 36};

models::ParameterValues ggxParameters(double diffuse, double specular, double roughness, double f0) {
  models::ParameterValues p = models::defaultParameters(models::findModel("ggx").spec());
  p.values[0] = Rgb(diffuse);
  p.values[1] = Rgb(specular);
  p.values[2] = Rgb(roughness);
  p.values[3] = Rgb(f0);
  return p;
}

/// A table with what a model cannot explain: noise, zeros, tiny and huge values, invalid cells above the horizon and
/// valid ones below it (MERL files have both).
std::shared_ptr<const TabulatedBrdf> roughTable(const HalfDifferenceGrid& grid = smallGrid) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> exponent(-30, 20);
  std::vector<TabulatedBrdf::Value> values(grid.size());
  std::vector<std::uint8_t> valid(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    for (int c = 0; c < 3; ++c) values[i][c] = random() % 8 == 0 ? 0.f : std::exp2(exponent(random));
    valid[i] = grid.nodeAboveHorizon(i) ? random() % 16 != 0 : random() % 16 == 0;
  }
  return std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::move(valid));
}

bool sameBits(const TabulatedBrdf& a, const TabulatedBrdf& b) {
  return a.grid() == b.grid() && std::memcmp(a.values().data(), b.values().data(), a.values().size_bytes()) == 0 &&
         std::memcmp(a.valid().data(), b.valid().data(), a.valid().size_bytes()) == 0;
}

constexpr models::ParameterSpec levelParameters[] = {{.id = "level",
                                                      .label = "",
                                                      .symbol = "",
                                                      .unit = "",
                                                      .softMin = 0,
                                                      .softMax = 1,
                                                      .hardMin = 0,
                                                      .hardMax = 1e300,
                                                      .defaultValue = 0,
                                                      .description = "",
                                                      .formula = "",
                                                      .reference = ""}};
constexpr models::ModelSpec levelSpec = {
    .id = "level", .name = "", .description = "", .formula = "", .reference = "", .parameters = levelParameters};

/// f = level, up to values that no float holds.
std::unique_ptr<const Brdf> createLevel(const models::ParameterValues& p) {
  class Level final : public Brdf {
   public:
    explicit Level(const Rgb& level) : level_(level) {}
    void evaluate(std::span<const DirectionPair>, std::span<Rgb> values) const override {
      std::fill(values.begin(), values.end(), level_);
    }

   private:
    Rgb level_;
  };
  return std::make_unique<const Level>(p.values[0]);
}

auto levelArguments(const models::ParameterValues& p) { return std::tuple(p.values[0]); }

Edit ggxEdit(const models::ParameterValues& fitted, const models::ParameterValues& edited) {
  return {DifferentialEdit{.model = &models::findModel("ggx"), .fitted = fitted, .edited = edited}};
}

Edit levelEdit(double fitted, double edited) {
  static const models::Model model(levelSpec,
                                   {.create = createLevel, .arguments = models::shaderArguments<levelArguments>});
  return {DifferentialEdit{.model = &model, .fitted = {{Rgb(fitted)}}, .edited = {{Rgb(edited)}}}};
}

class DifferentialEditTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void nothingChangedReturnsTheBase() {
    const auto base = roughTable();
    const auto p = ggxParameters(0.2, 1, 0.1, 0.05), q = ggxParameters(0.2, 1, 0.3, 0.05);
    Edit disabled = ggxEdit(p, q), weightless = ggxEdit(p, q);
    disabled.enabled = false;
    weightless.strength = 0;
    const Edit edits[] = {ggxEdit(p, p), disabled, weightless};
    QCOMPARE(bakeEdits(base, edits).get(), base.get());
    QCOMPARE(applyEdits(base, edits).get(), static_cast<const Brdf*>(base.get()));
    QCOMPARE(bakeEdits(base, {}).get(), base.get());
  }

  /// Edits that compute and change nothing: values beyond the hard range are clamped to the fitted ones.
  void equalModelsKeepEveryBit() {
    const auto base = roughTable();
    const Edit edits[] = {ggxEdit(ggxParameters(0.2, 1, 1, 0.05), ggxParameters(0.2, 1, 2, 0.05)),
                          ggxEdit(ggxParameters(0.2, 1, 0.01, 1), ggxParameters(0.2, 1, 0.01, 7))};
    QVERIFY(!edits[0].isIdentity());
    const auto baked = bakeEdits(base, edits);
    QVERIFY(baked != base);
    QVERIFY(sameBits(*baked, *base));
  }

  /// Tint and saturation need no model: they change every value, before and after a change of the model alike.
  void coloursOfTheValuesChange() {
    const auto base = roughTable();
    const Rgb tint(1, 0.5, 0.25);
    const auto coloured = [&](double saturation, double strength) {
      Edit edit = ggxEdit(ggxParameters(0.2, 1, 0.1, 0.05), ggxParameters(0.2, 1, 0.1, 0.05));
      auto& controls = std::get<DifferentialEdit>(edit.content).controls;
      controls.values[std::size_t(ArtistControl::tint)] = tint;
      controls.values[std::size_t(ArtistControl::saturation)] = Rgb(saturation);
      edit.strength = strength;
      return bakeEdits(base, std::span(&edit, 1));
    };
    const auto tinted = coloured(1, 1), half = coloured(1, 0.5), grey = coloured(0, 1), strong = coloured(10, 1);
    for (std::size_t i = 0; i < smallGrid.size(); ++i) {
      if (!base->valid()[i]) continue;
      const Rgb before(base->values()[i]);
      const auto agrees = [&](const TabulatedBrdf& table, const Rgb& expected) {
        return glm::length(Rgb(table.values()[i]) - expected) <= 1e-6 * glm::length(before);
      };
      QVERIFY(agrees(*tinted, tint * before));
      QVERIFY(agrees(*half, 0.5 * (before + tint * before)));
      QVERIFY(agrees(*grey, Rgb(luminance(tint * before))));
      for (int c = 0; c < 3; ++c) QVERIFY(strong->values()[i][c] >= 0);
    }
  }

  /// Of a base that the model explains completely nothing remains but the edited model.
  void explainedBaseBecomesTheEditedModel() {
    const models::Model& ggx = models::findModel("ggx");
    const auto fitted = ggxParameters(0.2, 0.8, 0.25, 0.05), edited = ggxParameters(0.3, 0.5, 0.4, 0.3);
    const auto base = bakeTable(*ggx.instantiate(fitted), smallGrid);
    const auto expected = bakeTable(*ggx.instantiate(edited), smallGrid);
    const Edit edit = ggxEdit(fitted, edited);
    const auto baked = bakeEdits(base, std::span(&edit, 1));
    for (std::size_t i = 0; i < smallGrid.size(); ++i) {
      QCOMPARE(baked->valid()[i], expected->valid()[i]);
      for (int c = 0; c < 3; ++c)
        QVERIFY(std::abs(baked->values()[i][c] - expected->values()[i][c]) <=
                1e-6f * std::max(1.f, base->values()[i][c]));
    }
  }

  /// The residual keeps its sign: an edit darkens as well as it brightens, cell by cell the change of the model.
  void residualSurvives() {
    const models::Model& ggx = models::findModel("ggx");
    const auto base = roughTable();
    const auto fitted = ggxParameters(0.2, 0.8, 0.25, 0.05), edited = ggxParameters(0.2, 0.8, 0.4, 0.05);
    Edit edit = ggxEdit(fitted, edited);
    edit.strength = 0.75;
    const auto baked = bakeEdits(base, std::span(&edit, 1));
    const auto from = ggx.instantiate(fitted), to = ggx.instantiate(edited);
    int darker = 0, brighter = 0;
    for (std::size_t i = 0; i < smallGrid.size(); ++i) {
      QCOMPARE(baked->valid()[i], base->valid()[i]);
      if (!base->valid()[i] || !smallGrid.nodeAboveHorizon(i)) {
        QVERIFY(baked->values()[i] == base->values()[i]);
        continue;
      }
      auto [wi, wo] = smallGrid.directions(i);
      wi.z = std::max(0.0, wi.z);
      wo.z = std::max(0.0, wo.z);
      const Rgb delta = 0.75 * (to->evaluate(wi, wo) - from->evaluate(wi, wo));
      const Rgb expected = glm::max(Rgb(0), Rgb(base->values()[i]) + delta);
      QVERIFY(baked->values()[i] == TabulatedBrdf::Value(expected));
      darker += delta.x < 0;
      brighter += delta.x > 0;
    }
    QVERIFY(darker > 100 && brighter > 100);
  }

  void wrapperAgreesWithTheBakedTable() {
    const auto base = roughTable();
    const Edit edits[] = {ggxEdit(ggxParameters(0.2, 1, 0.1, 0.05), ggxParameters(0, 2, 0.3, 0.5)),
                          levelEdit(0.5, 0.25)};
    const auto wrapper = applyEdits(base, edits);
    const auto baked = bakeEdits(base, edits);
    std::vector<DirectionPair> pairs;
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < smallGrid.size(); ++i) {
      DirectionPair pair = smallGrid.directions(i);
      // The look-up of a node on the horizon leans on its neighbours, as that of a node at the seam of phi_d does.
      if (!base->valid()[i] || pair.wi.z < 1e-6 || pair.wo.z < 1e-6 || i % 36 == 0) continue;
      if (smallGrid.node(i).thetaH == 0 || smallGrid.node(i).thetaD == 0) continue;
      pairs.push_back(pair);
      cells.push_back(i);
    }
    std::vector<Rgb> values(pairs.size());
    wrapper->evaluate(pairs, values);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const double expected = baked->values()[cells[i]][c];
        QVERIFY(std::abs(values[i][c] - expected) <= 1e-5 * std::max(1.0, expected));
        QCOMPARE(wrapper->evaluate(pairs[i].wi, pairs[i].wo)[c], values[i][c]);
      }
  }

  /// A table holds the mean over the azimuths: against 4096 of them round the whole circle.
  void anisotropicEditIsAveragedOverTheAzimuths() {
    const models::Model& model = models::findModel("ward-anisotropic");
    DifferentialEdit change{.model = &model, .fitted = models::defaultParameters(model.spec())};
    change.edited = change.fitted;
    change.edited.values[model.spec().find("diffuse").value()] = Rgb(0.1);
    QVERIFY(!isAnisotropic({change}));  // both axes equal
    change.edited.values[model.spec().find("roughness-x").value()] = Rgb(0.06);
    change.edited.values[model.spec().find("roughness-y").value()] = Rgb(0.6);
    const Edit edit{change};
    QVERIFY(isAnisotropic(edit));
    const std::vector<TabulatedBrdf::Value> flat(smallGrid.size(), TabulatedBrdf::Value(0.05f));
    const auto base = std::make_shared<const TabulatedBrdf>(smallGrid, flat, std::vector<std::uint8_t>(flat.size(), 1));
    const auto edited = applyEdits(base, std::span(&edit, 1));
    QVERIFY(!edited->isIsotropic());
    const auto baked = bakeEdits(base, std::span(&edit, 1));
    double largest = 0, worst = 0;
    for (std::size_t cell = 0; cell < smallGrid.size(); cell += 41) {
      const DirectionPair pair = smallGrid.directions(cell);
      if (pair.wi.z < 0.02 || pair.wo.z < 0.02) continue;
      double mean = 0;
      constexpr int turns = 4096;
      for (int n = 0; n < turns; ++n) {
        const double c = std::cos(2 * pi * n / turns), s = std::sin(2 * pi * n / turns);
        const auto turned = [&](const Direction& w) { return Direction(c * w.x - s * w.y, s * w.x + c * w.y, w.z); };
        mean += edited->evaluate(turned(pair.wi), turned(pair.wo)).x / turns;
      }
      largest = std::max(largest, mean);
      worst = std::max(worst, std::abs(mean - double(baked->values()[cell].x)));
    }
    QVERIFY(largest > 0.1);
    QVERIFY2(worst < 2e-3 * largest, qPrintable(QString("%1 of %2").arg(worst).arg(largest)));
  }

  void nothingGrowsWhereTheBaseHasNoData() {
    std::vector<std::uint8_t> valid(smallGrid.size(), 0);
    for (std::size_t i = smallGrid.size() / 2; i < smallGrid.size(); ++i) valid[i] = smallGrid.nodeAboveHorizon(i);
    const auto base = std::make_shared<const TabulatedBrdf>(
        smallGrid, std::vector<TabulatedBrdf::Value>(smallGrid.size(), TabulatedBrdf::Value(1)), std::move(valid));
    const Edit edit = levelEdit(0, 3);
    const auto edited = applyEdits(base, std::span(&edit, 1));
    QCOMPARE(edited->evaluate({0, 0, 1}, {0, 0, 1}).x, 0.0);
    QCOMPARE(edited->evaluate(fromSpherical(2, 0), {0, 0, 1}).x, 0.0);
    QCOMPARE(edited->evaluate(fromSpherical(1.4, 0), fromSpherical(1.4, 0.2)).x, 4.0);
    QVERIFY(!edited->hasData({{0, 0, 1}, {0, 0, 1}}));
    // An edit of the edited BRDF knows it as well.
    const auto editedTwice = applyEdits(edited, std::span(&edit, 1));
    QCOMPARE(editedTwice->evaluate({0, 0, 1}, {0, 0, 1}).x, 0.0);
    QCOMPARE(editedTwice->evaluate(fromSpherical(1.4, 0), fromSpherical(1.4, 0.2)).x, 7.0);
  }

  void hardCase39OverflowIsCappedAndCounted() {
    const auto base = roughTable();
    const Edit edit = levelEdit(0, 1e39);
    std::size_t capped = 0;
    const auto baked = bakeEdits(base, std::span(&edit, 1), {}, &capped);
    QCOMPARE(capped, 3 * base->validCount());
    for (std::size_t i = 0; i < smallGrid.size(); ++i)
      if (base->valid()[i]) QCOMPARE(baked->values()[i].y, FLT_MAX);
    const Edit largest = levelEdit(0, 1e30);
    bakeEdits(base, std::span(&largest, 1), {}, &capped);
    QCOMPARE(capped, std::size_t(0));
  }

  void hardCase50SameBitsForAnyThreadCount() {
    const auto base = roughTable({.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 60});
    const Edit edit = ggxEdit(ggxParameters(0.2, 1, 0.1, 0.05), ggxParameters(0.2, 2, 0.02, 0.5));
    const auto parallel = bakeEdits(base, std::span(&edit, 1));
    const ThreadLimit limit(1);
    QVERIFY(sameBits(*parallel, *bakeEdits(base, std::span(&edit, 1))));
  }

  void stopsWhenAsked() {
    std::stop_source source;
    source.request_stop();
    const Edit edit = levelEdit(0, 1);
    QVERIFY_EXCEPTION_THROWN(bakeEdits(roughTable(), std::span(&edit, 1), {source.get_token(), {}}), Cancelled);
  }
};

GONIO_TEST(DifferentialEditTest)
}  // namespace differential_edit_test

#include "differential_edit_test.moc"
