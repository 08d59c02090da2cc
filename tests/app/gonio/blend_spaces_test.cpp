// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/interpolation/blend_spaces.h"

#include <QTest>
#include <cmath>

#include "tests/app/gonio/interpolation_panel_test_support.h"
#include "tests/support/test_program.h"
#include "widgets/interpolation/blend_position.h"

namespace blend_spaces_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;
using Space = interpolation::InterpolationSpace;

/// What stays of prepared spaces when the materials change.
class BlendSpacesTest : public QObject {
  Q_OBJECT
 private:
  static interpolation::InterpolationMaterial grey(const char* name, double albedo) {
    return {.table = greyMaterial(name, albedo)->table(), .code = anyCode()};
  }
  const std::vector<interpolation::InterpolationMaterial> m_materials{grey("a", 0.2), grey("b", 0.4), grey("c", 0.9)};

  std::vector<interpolation::InterpolationMaterial> materials(std::initializer_list<std::size_t> which) const {
    std::vector<interpolation::InterpolationMaterial> result;
    for (const std::size_t i : which) result.push_back(m_materials[i]);
    return result;
  }
  /// Prepares and draws all that is missing.
  void settle(BlendSpaces& spaces) const {
    spaces.want(Space::linear);
    QTRY_VERIFY_WITH_TIMEOUT(spaces.isSettled(), patienceMilliseconds);
    for (const Space space : spaces.spaces()) QVERIFY(spaces.state(space) == BlendSpaces::State::ready);
  }
  std::vector<widgets::PreparedBlendPtr> prepared(const BlendSpaces& spaces) const {
    std::vector<widgets::PreparedBlendPtr> all;
    for (const Space space : spaces.spaces()) all.push_back(spaces.prepared(space));
    return all;
  }
  static double valueAt(const BlendSpaces& spaces, Space space, const std::vector<double>& weights) {
    return normalValue(*spaces.prepared(space)->interpolation->brdf(spaces.ordered(weights)));
  }

 private Q_SLOTS:
  /// Another model: its two spaces are prepared anew, the others stay; what it makes names it.
  void anotherModel() {
    BackgroundTasks tasks;
    BlendSpaces spaces(tasks, nullptr, smallPictures);
    spaces.setMaterials(materials({0, 1}));
    // The spaces behind these two take longer and know no model.
    const auto prepareThree = [&] {
      spaces.want(Space::linear);
      QTRY_VERIFY_WITH_TIMEOUT(spaces.prepared(Space::differential), patienceMilliseconds);
      spaces.pause();
    };
    prepareThree();
    const auto linear = spaces.prepared(Space::linear), first = spaces.prepared(Space::parameters);
    QVERIFY(first->model == &models::ggx());
    const models::Model& lambert = models::findModel("lambert");
    spaces.setModel(lambert);
    QVERIFY(!spaces.prepared(Space::parameters) && !spaces.prepared(Space::differential));
    prepareThree();
    QVERIFY(spaces.prepared(Space::linear) == linear && spaces.prepared(Space::parameters) != first);
    for (const Space space : {Space::parameters, Space::differential})
      QVERIFY(spaces.prepared(space)->model == &lambert);
    QVERIFY(std::abs(valueAt(spaces, Space::parameters, {0.5, 0.5}) - 0.3) < 1e-3);
    const auto second = spaces.prepared(Space::parameters);
    spaces.setModel(lambert);
    QVERIFY(spaces.prepared(Space::parameters) == second);
  }

  /// The switch of the detail: spaces that lose detail are prepared anew, the others stay.
  void detailIsASwitch() {
    BackgroundTasks tasks;
    BlendSpaces spaces(tasks, nullptr, smallPictures);
    QVERIFY(spaces.preservesDetail());
    spaces.setMaterials(materials({0, 1}));
    settle(spaces);
    const auto before = prepared(spaces);
    spaces.setPreservesDetail(false);
    settle(spaces);
    const auto after = prepared(spaces);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const bool loses = interpolation::losesDetail(spaces.spaces()[i]);
      QCOMPARE(before[i] != after[i], loses);
      QCOMPARE(before[i]->interpolation->preservesDetail(), loses);
      QVERIFY(!after[i]->interpolation->preservesDetail());
    }
    spaces.setPreservesDetail(false);
    QVERIFY(prepared(spaces) == after && spaces.isSettled());
  }

  /// Exchanged materials are blended by what is there; the strip runs the other way.
  void aSwapKeepsEverything() {
    BackgroundTasks tasks;
    BlendSpaces spaces(tasks, nullptr, smallPictures);
    spaces.setMaterials(materials({0, 1}));
    settle(spaces);
    const auto before = prepared(spaces);
    const std::vector<QImage> pictures = spaces.pictures(Space::linear);
    spaces.setMaterials(materials({1, 0}));
    QVERIFY(prepared(spaces) == before && tasks.isIdle());
    QVERIFY(std::equal(pictures.rbegin(), pictures.rend(), spaces.pictures(Space::linear).begin()));
    QVERIFY(std::abs(valueAt(spaces, Space::linear, {0.25, 0.75}) - (0.25 * 0.4 + 0.75 * 0.2)) < 1e-6);
    QVERIFY(std::abs(valueAt(spaces, Space::factors, {1, 0}) - 0.4) < 1e-6);
    spaces.setMaterials(materials({0, 1}));
    QVERIFY(spaces.pictures(Space::linear) == pictures);
    QVERIFY(std::abs(valueAt(spaces, Space::linear, {0.25, 0.75}) - (0.25 * 0.2 + 0.75 * 0.4)) < 1e-6);
  }

  /// Of three the strip's way is another one: drawn anew, from what was prepared, in the order of the places.
  void threeTurnedAround() {
    BackgroundTasks tasks;
    BlendSpaces spaces(tasks, nullptr, smallPictures);
    spaces.setMaterials(materials({0, 1, 2}));
    settle(spaces);
    const auto before = prepared(spaces);
    const QImage first = spaces.pictures(Space::linear).front();
    spaces.setMaterials(materials({2, 0, 1}));
    QVERIFY(prepared(spaces) == before);
    QVERIFY(spaces.pictures(Space::linear).empty());
    QVERIFY(std::abs(valueAt(spaces, Space::linear, {0.5, 0.3, 0.2}) - (0.5 * 0.9 + 0.3 * 0.2 + 0.2 * 0.4)) < 1e-6);
    settle(spaces);
    QVERIFY(prepared(spaces) == before);
    QVERIFY(spaces.pictures(Space::linear).front() != first);
    spaces.setMaterials(materials({0, 1, 2}));
    settle(spaces);
    QVERIFY(spaces.pictures(Space::linear).front() == first);
  }

  /// A place that is added and taken away again costs nothing; while it is empty nothing is offered.
  void noneInBetween() {
    BackgroundTasks tasks;
    BlendSpaces spaces(tasks, nullptr, smallPictures);
    spaces.setMaterials(materials({0, 1}));
    settle(spaces);
    const auto before = prepared(spaces);
    spaces.setMaterials({});
    QVERIFY(!spaces.hasMaterials() && spaces.isSettled());
    for (const Space space : spaces.spaces()) QVERIFY(!spaces.prepared(space) && spaces.pictures(space).empty());
    spaces.want(Space::linear);
    QVERIFY(tasks.isIdle());
    spaces.setMaterials(materials({0, 1}));
    QVERIFY(prepared(spaces) == before && tasks.isIdle());
    QCOMPARE(int(spaces.pictures(Space::dictionary).size()), BlendSpaces::pictureCount);
  }

  /// Another material, or the same one twice, is another blend.
  void othersAreForgotten() {
    BackgroundTasks tasks;
    BlendSpaces spaces(tasks, nullptr, smallPictures);
    spaces.setMaterials(materials({0, 1}));
    settle(spaces);
    for (const auto& others : {materials({0, 2}), materials({0, 0}), materials({0, 1, 2})}) {
      spaces.setMaterials(others);
      for (const Space space : spaces.spaces()) QVERIFY(!spaces.prepared(space));
    }
  }
};

GONIO_TEST(BlendSpacesTest)
}  // namespace blend_spaces_test

#include "blend_spaces_test.moc"
