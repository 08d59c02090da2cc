// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit_plausibility.h"

#include <QTest>
#include <cmath>

#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace edit_plausibility_test {
using namespace gonio;
using namespace gonio::editing;

using Checks = std::vector<metrics::PlausibilityCheck>;

const metrics::PlausibilityCheck& find(const Checks& checks, const std::string& name) {
  return *std::find_if(checks.begin(), checks.end(), [&](const auto& check) { return check.name == name; });
}

/// An edit of Lambert's albedo.
Edit lambertEdit(double fitted, double edited) {
  const models::Model& model = models::findModel("lambert");
  return {DifferentialEdit{.model = &model, .fitted = {{Rgb(fitted)}}, .edited = {{Rgb(edited)}}}};
}

std::shared_ptr<const TabulatedBrdf> constantTable(double albedo) { return bakeTable(test::lambert(Rgb(albedo))); }

class EditPlausibilityTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void order() {
    QStringList names;
    for (const auto& check : checkEditPlausibility(constantTable(0.5), {})) names << QString::fromStdString(check.name);
    QCOMPARE(names, (QStringList{"energy", "reciprocity", "negative", "non-finite", "extrapolated"}));
  }

  void aHarmlessEditPasses() {
    const Edit edit = lambertEdit(0.5, 0.6);
    for (const auto& check : checkEditPlausibility(constantTable(0.5), std::span(&edit, 1)))
      QVERIFY2(check.passed, check.name.c_str());
  }

  /// Albedo 0.9 + (1 - 0.5) = 1.4, at every angle alike.
  void energyOfTheEditedMaterial() {
    const Edit edit = lambertEdit(0.5, 1);
    const Checks checks = checkEditPlausibility(constantTable(0.9), std::span(&edit, 1));
    const auto& energy = find(checks, "energy");
    QVERIFY(!energy.passed && energy.at);
    QVERIFY2(std::abs(energy.worst - 1.4) < 0.01, qPrintable(QString::number(energy.worst)));
    QCOMPARE(energy.fraction, 1.0);
  }

  /// The clamp hides nothing: 0.2 - 0.5 albedo is -0.3 / pi per sr everywhere, though 0 is shown.
  void negativeValuesBeforeTheClamp() {
    const Edit edit = lambertEdit(0.5, 0);
    const auto base = constantTable(0.2);
    const Checks checks = checkEditPlausibility(base, std::span(&edit, 1));
    const auto& negative = find(checks, "negative");
    QVERIFY(!negative.passed && negative.at);
    QVERIFY(std::abs(negative.worst - 0.3 / pi) < 1e-6);
    QVERIFY(negative.fraction > 0.95);
    const Direction up{0, 0, 1};
    QCOMPARE(applyEdits(base, std::span(&edit, 1))->evaluate(up, up), Rgb(0));
    QVERIFY(applyEditsUnclamped(base, std::span(&edit, 1))->evaluate(up, up).x < -0.09);
  }

  /// An edit down to exactly the measured rest is no violation: rounding is not judged.
  void takingAwayAllThatIsThereIsNotNegative() {
    const Edit edit = lambertEdit(0.3, 0);
    QVERIFY(find(checkEditPlausibility(constantTable(0.3), std::span(&edit, 1)), "negative").passed);
  }

  /// A table without data for theta_d beyond 45 degrees: the fraction that is missing is reported, and where it begins.
  void holesAreTold() {
    const HalfDifferenceGrid grid;
    std::vector<TabulatedBrdf::Value> values(grid.size(), glm::vec3(0.2f));
    std::vector<std::uint8_t> valid(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const DirectionPair pair = grid.directions(i);
      valid[i] = glm::dot(pair.wi, pair.wo) > 0;  // 2 theta_d < 90 degrees
    }
    const auto table = std::make_shared<const TabulatedBrdf>(grid, values, valid);
    const Checks checks = checkEditPlausibility(table, {});
    const auto& coverage = find(checks, "extrapolated");
    QVERIFY(!coverage.passed && coverage.at);
    QVERIFY(coverage.worst > 0.05 && coverage.worst < 0.6);
    QVERIFY(glm::dot(coverage.at->wi, coverage.at->wo) < 0.05);
    QVERIFY(find(checkEditPlausibility(constantTable(0.2), {}), "extrapolated").passed);
  }

  void stopsWhenAsked() {
    std::stop_source stop;
    stop.request_stop();
    QVERIFY_THROWS_EXCEPTION(Cancelled, checkEditPlausibility(constantTable(0.5), {}, {stop.get_token(), {}}));
  }
};

GONIO_TEST(EditPlausibilityTest)
}  // namespace edit_plausibility_test

#include "edit_plausibility_test.moc"
