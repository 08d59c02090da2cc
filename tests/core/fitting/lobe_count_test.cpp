// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/fitting/fit.h"
#include "core/fitting/fit_parameters.h"
#include "core/models/registry.h"
#include "tests/support/test_program.h"

namespace lobe_count_test {
using namespace gonio;
using models::ParameterValues;

const models::Model& model() { return models::layered(); }
std::size_t index(const char* id) { return *model().spec().find(id); }

ParameterValues with(const std::vector<std::pair<const char*, Rgb>>& set) {
  ParameterValues values = models::defaultParameters(model().spec());
  for (const char* id : {"base", "base-edge", "flakes", "flakes-edge", "coat", "coat-edge"})
    values.values[index(id)] = Rgb(0);
  for (const auto& [id, value] : set) values.values[index(id)] = value;
  return values;
}

fitting::FitResult fitOf(const ParameterValues& truth, const ParameterValues& choices = {}) {
  const auto table = bakeTable(*model().instantiate(truth), {.thetaHCount = 45, .thetaDCount = 30, .phiDCount = 60});
  return fitting::fit(*table, model(), {}, {}, choices);
}
bool isOn(const fitting::FitResult& fit, const char* id) { return fit.parameters.values[index(id)] == Rgb(1); }

class LobeCountTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void lobesThatCanBeSwitchedOff() {
    const std::vector<std::size_t> expected{index("flakes-lobe"), index("coat-lobe")};
    QVERIFY(fitting::optionalLobes(model().spec()) == expected);
    QVERIFY(fitting::optionalLobes(models::ggx().spec()).empty());
    QVERIFY(fitting::optionalLobes(models::findModel("neumann-distance").spec()).empty());
  }

  /// A fit finds how many lobes there are, and what they are.
  void asManyLobesAsThereAre() {
    const ParameterValues one =
        with({{"base", {0.3, 0.2, 0.1}}, {"base-edge", Rgb(0.4)}, {"base-roughness", Rgb(0.3)}});
    const fitting::FitResult single = fitOf(one);
    QVERIFY(!isOn(single, "flakes-lobe") && !isOn(single, "coat-lobe"));
    QVERIFY(std::abs(single.parameters.values[index("base-roughness")].x - 0.3) < 0.003);

    ParameterValues two = one;
    two.values[index("base-roughness")] = Rgb(0.5);
    two.values[index("coat")] = two.values[index("coat-edge")] = Rgb(0.1);
    two.values[index("coat-roughness")] = Rgb(0.08);
    const fitting::FitResult pair = fitOf(two);
    QVERIFY(!isOn(pair, "flakes-lobe") && isOn(pair, "coat-lobe"));
    QVERIFY(std::abs(pair.parameters.values[index("coat-roughness")].x - 0.08) < 0.002);
    QVERIFY(std::abs(pair.parameters.values[index("base-roughness")].x - 0.5) < 0.01);
  }

  /// What the user chooses stays, sheen included.
  void choicesAreKept() {
    const ParameterValues truth = with({{"sheen", {0.2, 0.3, 0.4}},
                                        {"sheen-roughness", Rgb(0.4)},
                                        {"sheen-lobe", Rgb(1)},
                                        {"base", Rgb(0.1)},
                                        {"base-edge", Rgb(0.2)},
                                        {"base-roughness", Rgb(0.3)}});
    ParameterValues choices = models::defaultParameters(model().spec());
    choices.values[index("flakes-lobe")] = choices.values[index("coat-lobe")] = Rgb(0);
    choices.values[index("sheen-lobe")] = Rgb(1);
    const fitting::FitResult fit = fitOf(truth, choices);
    QVERIFY(!isOn(fit, "flakes-lobe") && !isOn(fit, "coat-lobe") && isOn(fit, "sheen-lobe"));
    QVERIFY(glm::length(fit.parameters.values[index("sheen")] - Rgb(0.2, 0.3, 0.4)) < 0.01);
    QVERIFY(std::abs(fit.parameters.values[index("sheen-roughness")].x - 0.4) < 0.01);
  }
};

GONIO_TEST(LobeCountTest)
}  // namespace lobe_count_test

#include "lobe_count_test.moc"
