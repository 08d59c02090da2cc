// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/photograph_plan.h"

#include <Eigen/LU>
#include <QTest>
#include <set>

#include "core/io/json_text.h"
#include "core/photograph/photograph_candidates.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace photograph_plan_test {
using namespace gonio;
using namespace gonio::photograph;
using Eigen::Index, Eigen::MatrixXd, Eigen::MatrixX3d, Eigen::VectorXd;

constexpr HalfDifferenceGrid grid{30, 10, 12, true};

/// The components of GGX materials of several widths and colours.
const PhotographPrior& prior() {
  static const PhotographPrior result = [] {
    std::vector<std::shared_ptr<const TabulatedBrdf>> tables;
    for (const double roughness : {0.15, 0.3, 0.6})
      for (const double f0 : {0.03, 0.2})
        for (const Rgb diffuse : {Rgb(0.05, 0.1, 0.3), Rgb(0.5, 0.3, 0.1)})
          tables.push_back(bakeTable(*test::ggx(diffuse, Rgb(1), roughness, f0), grid));
    return photographPrior(
        dictionary::learnPrincipalComponents(tables.size(), [&](std::size_t m) { return tables[m]; }), 8);
  }();
  return result;
}

Photograph underDistantLight(const Direction& toLight) {
  Photograph photograph{.name = "light", .image = {}, .disc = {}, .camera = {}, .light = {}};
  photograph.light.directional.push_back({glm::normalize(toLight), Rgb(1, 2, 3)});
  photograph.disc = discOf(photograph.camera, 48, 48);
  return photograph;
}

PhotographSet setOf(const std::vector<Photograph>& photographs, bool exposureKnown = true) {
  return {.photographs = photographs, .exposureKnown = exposureKnown, .warnings = {}};
}

const std::vector<std::size_t> oneClass(12, 0);
constexpr PlanOptions few{.materials = 3, .regionsPerImage = 20};

/// The mean posterior variance of the mapped values, by the covariance of all unknowns and of all pixels, with
/// derivatives by finite differences.
double bruteForce(const PhotographSet& set, const std::vector<std::size_t>& materials, bool exposureKnown) {
  const PhotographPrior& p = prior();
  const Index components = p.d.cols(), unknowns = 3 * components + (exposureKnown ? 0 : 1);
  // Covariance over the training materials in all orders of their channels.
  const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const Index count = p.v.rows() / 3;
  MatrixXd samples(6 * count, 3 * components);
  for (Index m = 0; m < count; ++m)
    for (int order = 0; order < 6; ++order)
      for (int c = 0; c < 3; ++c)
        samples.row(6 * m + order).segment(c * components, components) = p.v.row(3 * m + orders[order][c]);
  const MatrixXd centred = samples.rowwise() - samples.colwise().mean();
  MatrixXd covariance = MatrixXd::Zero(unknowns, unknowns);
  covariance.topLeftCorner(3 * components, 3 * components) = centred.transpose() * centred / double(samples.rows());
  if (!exposureKnown) covariance(unknowns - 1, unknowns - 1) = 9;
  const auto regions = plannedRegions(set, few.regionsPerImage * set.photographs.size());
  const PixelRows rows = assembleRows(p.mapping, set, regions);
  double sum = 0;
  for (const std::size_t m : materials) {
    VectorXd x = VectorXd::Zero(unknowns);
    for (int c = 0; c < 3; ++c) x.segment(c * components, components) = p.v.row(3 * Index(m) + c).transpose();
    const auto pixels = [&](const VectorXd& at) {
      const auto values = rows.values(cellValues(p, Eigen::Map<const MatrixX3d>(at.data(), components, 3)));
      VectorXd all(Index(3 * values.size()));
      for (std::size_t row = 0; row < values.size(); ++row)
        for (int c = 0; c < 3; ++c)
          all[Index(3 * row) + c] = values[row][c] * (exposureKnown ? 1 : std::exp(at[unknowns - 1]));
      return all;
    };
    const VectorXd centre = pixels(x);
    MatrixXd jacobian(centre.size(), unknowns);
    for (Index k = 0; k < unknowns; ++k) {
      const double step = k < 3 * components ? 2e-3 : 1e-4;
      VectorXd up = x, down = x;
      up[k] += step;
      down[k] -= step;
      jacobian.col(k) = (pixels(up) - pixels(down)) / (2 * step);
    }
    VectorXd noise(centre.size());
    for (std::size_t i = 0; i < set.photographs.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        double mean = 0, inImage = 0;
        for (std::size_t row = 0; row < regions.size(); ++row)
          if (regions[row].photograph == i) {
            mean += centre[Index(3 * row) + c];
            ++inImage;
          }
        mean /= inImage;
        for (std::size_t row = 0; row < regions.size(); ++row)
          if (regions[row].photograph == i)
            noise[Index(3 * row) + c] =
                std::pow(few.modelNoise * (centre[Index(3 * row) + c] + 0.05 * mean), 2) * std::max(1.0, inImage / 25);
      }
    const MatrixXd crossed = covariance * jacobian.transpose();
    MatrixXd ofPixels = jacobian * crossed;
    ofPixels.diagonal() += noise;
    const MatrixXd posterior = covariance - crossed * ofPixels.inverse() * crossed.transpose();
    for (int c = 0; c < 3; ++c) {
      const MatrixXd d = p.d.cast<double>();
      sum += (d * posterior.block(c * components, c * components, components, components)).cwiseProduct(d).sum() /
             double(3 * d.rows() * Index(materials.size()));
    }
  }
  return sum;
}

class PhotographPlanTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void expectedDeviationsByBruteForce_data() {
    QTest::addColumn<bool>("exposureKnown");
    QTest::newRow("known exposure") << true;
    QTest::newRow("unknown exposure") << false;
  }
  void expectedDeviationsByBruteForce() {
    QFETCH(bool, exposureKnown);
    const Photograph first = underDistantLight({0.2, 0.3, 1}), second = underDistantLight({1, 0.2, 0.3});
    const auto plan = planPhotographs(prior(), setOf({first}, exposureKnown), {second}, oneClass, 1, few);
    QCOMPARE(plan.materials, (std::vector<std::size_t>{0, 4, 8}));
    const double one = std::sqrt(bruteForce(setOf({first}), plan.materials, exposureKnown));
    const double two = std::sqrt(bruteForce(setOf({first, second}), plan.materials, exposureKnown));
    QVERIFY2(std::abs(plan.taken[0].overall / one - 1) < 5e-3,
             QByteArray::number(plan.taken[0].overall) + " not " + QByteArray::number(one));
    QVERIFY2(std::abs(plan.after[0].overall / two - 1) < 5e-3,
             QByteArray::number(plan.after[0].overall) + " not " + QByteArray::number(two));
  }

  /// Each image reduces the uncertainty, and the one that is chosen first does so most.
  void decreasesGreedily() {
    std::vector<Photograph> candidates;
    for (const Direction toLight :
         {Direction(0, 0, 1), Direction(1, 0, 0.2), Direction(0, 1, 0.5), Direction(-1, 0, 0)})
      candidates.push_back(underDistantLight(toLight));
    PlanOptions options = few;
    options.images = 9;
    const auto plan = planPhotographs(prior(), setOf({}), candidates, oneClass, 1, options);
    QCOMPARE(plan.chosen.size(), candidates.size());
    QVERIFY(plan.taken.empty());
    double last = plan.before.overall;
    for (const ExpectedDeviation& of : plan.after) {
      QVERIFY(of.overall < last);
      last = of.overall;
    }
    for (const ExpectedDeviation& of : plan.candidates) QVERIFY(of.overall >= plan.after[0].overall);
    QCOMPARE(plan.candidates[plan.chosen[0]].overall, plan.after[0].overall);
    QCOMPARE(std::set<std::size_t>(plan.chosen.begin(), plan.chosen.end()).size(), candidates.size());
  }

  /// An image that was taken already says less than one from another side.
  void prefersUnseenImages() {
    const Photograph front = underDistantLight({0.1, 0.1, 1}), side = underDistantLight({1, 0.1, -0.2});
    const auto plan = planPhotographs(prior(), setOf({front}), {front, side}, oneClass, 1, few);
    QCOMPARE(plan.chosen, std::vector<std::size_t>{1});
    QVERIFY2(plan.candidates[0].overall > 1.02 * plan.candidates[1].overall,
             QByteArray::number(plan.candidates[0].overall) + " " + QByteArray::number(plan.candidates[1].overall));
  }

  /// The variance over all materials is the mean of those of the classes; a class without materials has none.
  void classesAddUp() {
    const std::vector<std::size_t> classOf{0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
    const auto plan = planPhotographs(prior(), setOf({}), {underDistantLight({0, 0, 1})}, classOf, 3, few);
    const auto& of = plan.after[0];
    QVERIFY(std::abs(of.overall * of.overall -
                     (of.classes[0] * of.classes[0] + 2 * of.classes[1] * of.classes[1]) / 3) < 1e-12);
    QVERIFY(std::isnan(of.classes[2]));
  }

  /// Turns of a flat sample are candidates, too. Turned away from the light, it shows nothing.
  void turnsAFlatSample() {
    std::vector<Photograph> turned;
    for (const Direction& normal : {Direction(0, 0, 1), Direction(-0.8, 0, 0.6), Direction(0.8, 0, 0.6)}) {
      turned.push_back(underDistantLight({1, 0, 0.2}));
      turned.back().surface = FlatSample{.normal = normal};
      turned.back().size = {48, 48};
    }
    const auto plan = planPhotographs(prior(), setOf({turned[0]}), turned, oneClass, 1, few);
    const double taken = plan.taken[0].overall;
    QVERIFY(taken < plan.before.overall);
    QVERIFY(std::abs(plan.candidates[1].overall - taken) < 1e-9);
    for (const std::size_t lit : {0, 2})
      QVERIFY2(plan.candidates[lit].overall < 0.995 * taken, QByteArray::number(plan.candidates[lit].overall / taken));
    QVERIFY(plan.chosen[0] != 1);
  }

  void needsCandidates() {
    QVERIFY_THROWS_EXCEPTION(Error, planPhotographs(prior(), setOf({}), {}, oneClass, 1));
    QVERIFY_THROWS_EXCEPTION(
        Error, planPhotographs(prior(), setOf({}), {underDistantLight({0, 0, 1})}, oneClass, 1, {.images = 0}));
  }

  /// Texts of descriptions with candidates are descriptions; chosen candidates become images.
  void candidatesOfADescription() {
    const std::string text =
        R"({"format": "gonio photographs", "version": 1, "images": [{"file": "a.exr", "camera": {"position": [0, 1, 4]},
            "lights": [{"environment": "studio", "rotation": 10}, {"position": [0, 0, 3], "intensity": [1, 1, 1]}]}]})";
    const std::string with = withCandidates(text, {.rotations = 4, .lights = 5, .cameras = 2});
    const auto found = parseDescription(with, {}, false);
    QCOMPARE(found.set.photographs.size(), std::size_t(1));
    QCOMPARE(found.candidates.size(), std::size_t(11));
    QCOMPARE(found.candidates[1].name, std::string("rotation-090.exr"));
    QCOMPARE(found.candidates[1].light.rotation, halfPi);
    for (std::size_t i = 4; i < 9; ++i) {
      const Direction light = found.candidates[i].light.points.at(0).position;
      QVERIFY(std::abs(glm::length(light) - 3) < 1e-9);
      QVERIFY(glm::dot(light / 3.0, glm::normalize(Direction(0, 1, 4))) > std::cos(radians(120.1)));
    }
    QVERIFY(std::abs(found.candidates[10].camera.yaw - pi) < 1e-9);
    const auto chosen = parseDescription(withChosenCandidates(with, std::vector<std::size_t>{10, 1}), {}, false);
    QCOMPARE(chosen.set.photographs.size(), std::size_t(3));
    QCOMPARE(chosen.set.photographs[2].name, std::string("rotation-090.exr"));
    QVERIFY(chosen.candidates.empty());
    // From behind, a flat sample is not seen.
    const std::string flat =
        R"({"format": "gonio photographs", "version": 1, "images": [{"file": "a.exr", "camera": {"position": [0, 1, 4]},
            "shape": {"flat": {"normal": [1, 0, 2], "radius": 1}}, "lights": [{"environment": "studio"}]}]})";
    const auto front = parseDescription(withCandidates(flat, {.cameras = 8}), {}, false);
    QCOMPARE(front.candidates.size(), std::size_t(4));
    for (const Photograph& of : front.candidates) QVERIFY(!isSphere(of.surface));
    const std::string lamp = R"({"images": [{"file": "a.exr", "camera": {"position": [0, 1, 4]}, "lights": []}]})";
    QVERIFY_THROWS_EXCEPTION(Error, withCandidates(lamp, {.rotations = 4}));
    QVERIFY_THROWS_EXCEPTION(Error, withCandidates("{}", {.lights = 1}));
  }
};

GONIO_TEST(PhotographPlanTest)

}  // namespace photograph_plan_test

#include "photograph_plan_test.moc"
