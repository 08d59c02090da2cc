// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit.h"

#include <QTest>
#include <cmath>

#include "core/coordinates/projected_deviation.h"
#include "core/documents/edit_document.h"
#include "core/models/model.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace factor_edit_test {
using namespace gonio;
using namespace gonio::documents;
using namespace gonio::editing;
using namespace gonio::test;
using factorization::PdvFactors;
using factorization::PdvForm;

/// Curves with closed forms at every node and between: constant F1 and F3, F2 falling along a line to 0 at |Dp| = 1.
PdvFactors straight(double strength, PdvForm form = PdvForm::twoFactors) {
  PdvFactors f{.form = form, .transform = DataTransform::none};
  f.thetaNodes = {0, 0.5, 1.5};
  f.deviationNodes = {0, 0.5, 1, 2};
  f.phiNodes = form == PdvForm::twoFactors ? std::vector{0.0} : std::vector{0.0, 3.0};
  f.highest = 100;
  for (std::size_t c = 0; c < 3; ++c)
    f.channels[c] = {{std::vector(3, strength * double(c + 1)), {1, 0.5, 0, 0}, std::vector(f.phiNodes.size(), 1.0)}};
  return f;
}

FactorEdit edit(double from, double to, PdvForm form = PdvForm::twoFactors) {
  FactorEdit result;
  result.original = std::make_shared<const PdvFactors>(straight(from, form));
  result.edited = std::make_shared<const PdvFactors>(straight(to, form));
  return result;
}

std::shared_ptr<const TabulatedBrdf> constantTable(float value) {
  const HalfDifferenceGrid grid{8, 8, 8};
  std::vector<std::uint8_t> valid(grid.size(), 1);
  valid[3] = 0;
  std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(value));
  values[3] = TabulatedBrdf::Value(0);
  return std::make_shared<const TabulatedBrdf>(grid, values, valid);
}

/// The light at |Dp| = 0.25 on the side of the viewer, who stands at 30 degrees.
const DirectionPair quarter = fromProjectedDeviation({radians(30), 0.25, 0.3}).pair;

std::string errorWith(const std::string& pointer, const nlohmann::json& value) {
  EditDocument document{.sourcePath = "library:sgd/chrome", .sourceSha256 = std::string(64, 'a')};
  document.edits = {{edit(1, 2)}};
  nlohmann::json json = toJson(document);
  json["edits"][0][nlohmann::json::json_pointer(pointer)] = value;
  return errorOf([&] { documentFromJson(json); });
}

class FactorEditTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// F2(0.25) = 0.75 + (the monotone cubic's bend, 0 on a line through three nodes but at the last): exact here.
  void theChangeOfTheFactorsIsAddedToTheMeasurement() {
    const Edit one{edit(1, 3)};
    const auto edited = applyEdits(constantTable(0.5f), std::span(&one, 1));
    const Rgb value = edited->evaluate(quarter.wi, quarter.wo);
    const auto f2 = factorization::makePdvBrdf(straight(1))->evaluate(quarter.wi, quarter.wo);
    QVERIFY(std::abs(f2.x - 0.75) < 0.05);
    for (int c = 0; c < 3; ++c) QVERIFY(std::abs(value[c] - (0.5 + 2 * f2.x * (c + 1))) < 1e-6);
  }

  void theStrengthScalesTheChange() {
    Edit one{edit(1, 3)};
    one.strength = 0.5;
    const Edit whole{edit(1, 2)};
    const auto base = constantTable(0.5f);
    const Rgb a = applyEdits(base, std::span(&one, 1))->evaluate(quarter.wi, quarter.wo);
    const Rgb b = applyEdits(base, std::span(&whole, 1))->evaluate(quarter.wi, quarter.wo);
    QVERIFY(glm::length(a - b) < 1e-6);
  }

  void withoutTheDetailTheModelStandsAlone() {
    FactorEdit alone = edit(1, 3);
    alone.preserveDetail = false;
    Edit one{alone};
    const Rgb expected = factorization::makePdvBrdf(*alone.edited)->evaluate(quarter.wi, quarter.wo);
    const Rgb value = applyEdits(constantTable(0.5f), std::span(&one, 1))->evaluate(quarter.wi, quarter.wo);
    QVERIFY(glm::length(value - expected) < 1e-12);
    one.strength = 0.25;
    const Rgb mixed = applyEdits(constantTable(0.5f), std::span(&one, 1))->evaluate(quarter.wi, quarter.wo);
    QVERIFY(glm::length(mixed - (0.75 * 0.5 + 0.25 * expected)) < 1e-6);
  }

  void whatWouldFallBelowZeroIsZero() {
    const Edit one{edit(3, 1)};
    const auto base = constantTable(0.5f);
    QCOMPARE(applyEdits(base, std::span(&one, 1))->evaluate(quarter.wi, quarter.wo), Rgb(0));
    QVERIFY(applyEditsUnclamped(base, std::span(&one, 1))->evaluate(quarter.wi, quarter.wo).x < -0.5);
  }

  void untouchedCurvesLeaveEveryBit() {
    const auto base = constantTable(0.5f);
    Edit disabled{edit(1, 3)}, weightless{edit(1, 3)}, same{edit(2, 2)};
    disabled.enabled = false;
    weightless.strength = 0;
    const Edit edits[] = {disabled, weightless, same};
    QCOMPARE(bakeEdits(base, edits).get(), base.get());
    std::get<FactorEdit>(same.content).preserveDetail = false;
    QVERIFY(!same.isIdentity());
  }

  void bakedCellsAreTheEditedReflectance() {
    const Edit edits[] = {
        {edit(1, 3)},
        {DifferentialEdit{.model = &models::findModel("lambert"), .fitted = {{Rgb(0.1)}}, .edited = {{Rgb(0.4)}}}}};
    const auto base = constantTable(0.5f);
    const auto baked = bakeEdits(base, edits);
    const auto wrapper = applyEdits(base, edits);
    QVERIFY(!baked->valid()[3]);
    for (std::size_t cell = 0; cell < base->grid().size(); ++cell) {
      DirectionPair pair = base->grid().directions(cell);
      if (!base->valid()[cell] || isBelowHorizon(pair.wi) || isBelowHorizon(pair.wo)) continue;
      for (Direction* w : {&pair.wi, &pair.wo}) w->z = std::max(0.0, w->z);
      const Rgb expected = wrapper->evaluate(pair.wi, pair.wo);
      QVERIFY(glm::length(Rgb(baked->values()[cell]) - expected) <= 1e-5 * (1 + glm::length(expected)));
    }
  }

  void everyBitComesBackFromADocument() {
    EditDocument document;
    document.sourcePath = "library:sgd/chrome";
    document.sourceSha256 = std::string(64, 'a');
    Edit odd{edit(1.0 / 3, 0.1 + 0.2, PdvForm::threeFactors), "caf\xC3\xA9"};
    auto& factors = std::get<FactorEdit>(odd.content);
    factors.preserveDetail = false;
    PdvFactors negative = *factors.edited;
    negative.lowest = -1.0 / 3;
    factors.edited = std::make_shared<const PdvFactors>(negative);
    odd.enabled = false;
    odd.strength = 1.0 / 7;
    document.edits = {{edit(1, 1e-17)}, odd};
    const auto path = outputPath("editing/factors.gonio");
    writeDocument(document, path);
    const EditDocument again = readDocument(path);
    QCOMPARE(again.edits.size(), std::size_t(2));
    QVERIFY(again.edits == document.edits);
    QCOMPARE(toJson(document)["version"].get<int>(), EditDocument::currentVersion);
  }

  void errorsNameKeyFoundAndExpected() {
    const auto names = [](const std::string& error, const std::string& key) {
      const bool all = contains(error, "edits[0]." + key) && contains(error, "found") && contains(error, "expected");
      if (!all) qWarning("%s", error.c_str());
      return all;
    };
    QVERIFY(names(errorWith("/original", 1), "original"));
    QVERIFY(names(errorWith("/edited/form", "4d"), "edited.form"));
    QVERIFY(names(errorWith("/edited/transform", "sine"), "edited.transform"));
    QVERIFY(names(errorWith("/edited/highest", "x"), "edited.highest"));
    QVERIFY(names(errorWith("/edited/thetaNodes", {0, 2, 1}), "edited.thetaNodes"));
    QVERIFY(names(errorWith("/edited/thetaNodes", {0.1, 0.2, 0.3}), "edited.thetaNodes"));
    QVERIFY(names(errorWith("/edited/deviationNodes", {0}), "edited.deviationNodes"));
    QVERIFY(names(errorWith("/edited/phiNodes", {0, 1}), "edited.phiNodes"));
    QVERIFY(names(errorWith("/edited/channels", nlohmann::json::array()), "edited.channels"));
    QVERIFY(names(errorWith("/edited/channels/1", nlohmann::json::array()), "edited.channels"));
    QVERIFY(names(errorWith("/edited/channels/2/0/f1", {1, 2}), "edited.channels[2][0].f1"));
    QVERIFY(names(errorWith("/edited/channels/2/0/f2/0", "x"), "edited.channels[2][0].f2"));
    QVERIFY(names(errorWith("/keepDetail", 1), "keepDetail"));
    QVERIFY(names(errorWith("/strength", 2), "strength"));
    PdvFactors broken = straight(1);
    broken.channels[1][0].f2[1] = std::nan("");
    FactorEdit nan = edit(1, 2);
    nan.edited = std::make_shared<const PdvFactors>(broken);
    QVERIFY(!errorOf([&] { toJson(nan); }).empty());
    nan.edited = nullptr;
    QVERIFY(!errorOf([&] { toJson(nan); }).empty());
  }
};

GONIO_TEST(FactorEditTest)
}  // namespace factor_edit_test

#include "factor_edit_test.moc"
