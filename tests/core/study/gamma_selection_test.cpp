// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/picture_search.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/rendering/render_picture.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace gamma_selection_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::fitting;
using namespace gonio::study;

constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 30, .thetaDCount = 20, .phiDCount = 24};
const RenderOptions thumbnail{.width = 24, .height = 24, .samples = 4, .density = {}};

/// What no Blinn lobe explains: the gammas differ in what they give up.
std::shared_ptr<const TabulatedBrdf> metal() {
  return bakeTable(*test::ggx(Rgb(0.05, 0.2, 0.3), Rgb(0.9, 0.5, 0.2), 0.15, 0.5), smallGrid);
}

class GammaSelectionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void takesTheGammaOfTheBestPicture() {
    const auto table = metal();
    const models::Model& model = models::findModel("blinn-phong");
    const std::vector<GammaTrial> trials = selectGamma({table, table}, model, {}, thumbnail);
    QCOMPARE(trials.size(), std::size_t(9));
    const RenderedComparison comparison(*table, thumbnail);
    std::set<double> gammas;
    for (const GammaTrial& trial : trials) {
      gammas.insert(trial.gamma);
      QVERIFY(trials.front().renderedSnr >= trial.renderedSnr);
      const FitResult alone = fit(*table, model, {.metric = metrics::BrdfMetric::gamma, .gamma = trial.gamma});
      QVERIFY(alone.parameters == trial.fit.parameters);
      QCOMPARE(trial.renderedSnr,
               comparison.signalToNoiseRatio(comparison.render(*model.instantiate(alone.parameters))));
    }
    QCOMPARE(gammas.size(), std::size_t(9));
    QCOMPARE(*gammas.begin(), 1.0);
    QCOMPARE(*gammas.rbegin(), 3.0);
    // The choice matters: the worst is worse.
    QVERIFY(std::ranges::any_of(trials, [&](const auto& t) { return t.renderedSnr < trials[0].renderedSnr - 0.1; }));
  }

  void blackReferenceTakesTheFirst() {
    const auto black = bakeTable(*test::ggx(Rgb(0), Rgb(0), 0.3, 0.04), smallGrid);
    const std::vector<GammaTrial> trials = selectGamma({black, black}, models::lambert(), {}, thumbnail);
    QCOMPARE(trials.size(), std::size_t(9));
    QCOMPARE(trials.front().gamma, 1.0);
    QVERIFY(std::isnan(trials.front().renderedSnr));
  }

  void cancelLeavesWhatIsDone() {
    const auto table = metal();
    for (const std::size_t wanted : {0, 2}) {
      std::stop_source source;
      if (wanted == 0) source.request_stop();
      std::size_t done = 0;
      const TaskControl control{source.get_token(), [&](double) {
                                  if (++done == wanted) source.request_stop();
                                }};
      QCOMPARE(selectGamma({table, table}, models::lambert(), {}, thumbnail, control).size(), wanted);
    }
  }
};

GONIO_TEST(GammaSelectionTest)
}  // namespace gamma_selection_test

#include "gamma_selection_test.moc"
