// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/preview_display.h"

#include <QTest>
#include <cmath>

#include "core/models/model.h"
#include "core/rendering/error_maps.h"
#include "offscreen_context.h"
#include "tests/support/test_program.h"
#include "widgets/preview/gl/preview_renderer.h"

namespace preview_display_test {
using namespace gonio;
using namespace gonio::rendering;
using widgets::CompareMode;
using widgets::DifferenceKind;

constexpr int side = 48;

std::shared_ptr<const TabulatedBrdf> lambert(double albedo) {
  return bakeTable(*models::findModel("lambert").instantiate({{Rgb(albedo)}}));
}

/// The greatest difference of the channels of two colours, of 255.
int distance(const QColor& a, const QColor& b) {
  return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}

class PreviewDisplayTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    context_ = std::make_unique<test::OffscreenContext>();
    if (!context_->isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    resources_ = std::make_shared<widgets::PreviewResources>();
    display_ = std::make_unique<widgets::PreviewDisplay>(resources_);
    for (auto* picture : {&bright_, &dark_}) {
      *picture = std::make_unique<widgets::PreviewRenderer>(resources_);
      (*picture)->initialize();
      (*picture)->setSubject(widgets::measuredSubject(lambert(picture == &bright_ ? 0.8 : 0.2)));
      (*picture)->setSize({side, side});
      (*picture)->accumulate(16);
    }
    display_->initialize();
  }
  void cleanupTestCase() {
    if (!context_->isValid()) return;
    bright_->release();
    dark_->release();
    resources_->release();
  }

  void splitShowsTheFirstLeftAndTheSecondRight() {
    const QImage bright = show({}), dark = alone(*dark_);
    const QImage split = show({.mode = CompareMode::split, .split = 0.25});
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        QVERIFY(distance(split.pixelColor(x, y), (x < side / 4 ? bright : dark).pixelColor(x, y)) <= 1);
    QVERIFY(distance(bright.pixelColor(side / 2, side / 2), dark.pixelColor(side / 2, side / 2)) > 20);
  }

  /// Squares of 16 pixels where nothing is, and the picture as before where it covers them.
  void theCheckerLiesBehindThePicture() {
    const QImage plain = alone(*bright_), checker = alone(*bright_, {.checker = true});
    QVERIFY(checker.pixelColor(1, 1) != checker.pixelColor(17, 1));
    QCOMPARE(checker.pixelColor(1, 1), checker.pixelColor(14, 1));
    QCOMPARE(checker.pixelColor(side / 2, side / 2), plain.pixelColor(side / 2, side / 2));
  }

  void twoUpShowsBothWhole() {
    const QImage both = show({.mode = CompareMode::twoUp});
    const QImage bright = show({}), dark = alone(*dark_);
    // Half as wide: the middle of either half is the middle of the picture.
    QVERIFY(distance(both.pixelColor(side / 4, side / 2), bright.pixelColor(side / 2, side / 2)) <= 3);
    QVERIFY(distance(both.pixelColor(3 * side / 4, side / 2), dark.pixelColor(side / 2, side / 2)) <= 3);
  }

  /// Every covered pixel has the colour of the difference that the CPU computes from the same pictures.
  void differenceIsThatOfTheCpu_data() {
    QTest::addColumn<DifferenceKind>("kind");
    QTest::newRow("absolute") << DifferenceKind::absolute;
    QTest::newRow("signed") << DifferenceKind::signedValue;
    QTest::newRow("relative") << DifferenceKind::relative;
  }
  void differenceIsThatOfTheCpu() {
    QFETCH(DifferenceKind, kind);
    const Image first = dark_->readPicture(), second = bright_->readPicture();
    const double range = 1;
    const QImage shown = show({.mode = CompareMode::difference, .difference = kind}, range, *dark_, *bright_);
    int compared = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const std::size_t i = first.index(x, y);
        if (first.alpha[i] < 1 || second.alpha[i] < 1) continue;
        Image a(1, 1), b(1, 1);
        a.pixels = {first.pixels[i]}, b.pixels = {second.pixels[i]};
        a.alpha = b.alpha = {1.f};
        const double value = widgets::pictureDifferences(a, b, kind).front();
        const DisplayColour colour =
            kind == DifferenceKind::signedValue ? signedColour(value / range) : viridis(value / range);
        QVERIFY(distance(shown.pixelColor(x, y), QColor(colour[0], colour[1], colour[2])) <= 3);
        ++compared;
      }
    QVERIFY(compared > side * side / 3);
  }

  /// Equal pictures differ by nothing: the first colour everywhere.
  void equalPicturesHaveNoDifference() {
    const QImage shown = show({.mode = CompareMode::difference}, 1e-3, *dark_, *dark_);
    const DisplayColour zero = viridis(0);
    QVERIFY(distance(shown.pixelColor(side / 2, side / 2), QColor(zero[0], zero[1], zero[2])) <= 1);
  }

  void automaticRangeIsRoundAndHoldsNearlyAll() {
    std::vector<double> values;
    for (int i = 0; i < 1000; ++i) values.push_back(0.003 * i / 1000.0);
    QCOMPARE(widgets::automaticRange(values), 0.005);
    values.assign(1000, 0.2);
    values.front() = -1e9;  // one bad pixel does not count
    QVERIFY(std::abs(widgets::automaticRange(values) - 0.2) < 1e-12);
    QCOMPARE(widgets::automaticRange({0, 0, 0}), 1e-3);
    QCOMPARE(widgets::automaticRange({}), 1e-3);
    QVERIFY(std::abs(widgets::automaticRange({-7.0}) - 10) < 1e-12);
  }

  /// Black has no relative difference: it is judged against a small luminance and stays finite.
  void relativeDifferenceOfBlackIsFinite() {
    Image a(1, 1), b(1, 1);
    a.alpha = b.alpha = {1.f};
    QCOMPARE(widgets::pictureDifferences(a, b, DifferenceKind::relative).front(), 0.0);
    a.pixels = {glm::vec3(1)};
    QVERIFY(std::isfinite(widgets::pictureDifferences(a, b, DifferenceKind::relative).front()));
  }

 private:
  QImage show(const widgets::PreviewComparison& comparison) { return show(comparison, 1, *bright_, *dark_); }
  QImage show(const widgets::PreviewComparison& comparison, double range, const widgets::PreviewRenderer& first,
              const widgets::PreviewRenderer& second) {
    QOpenGLFramebufferObject target(side, side);
    target.bind();
    display_->present({side, side}, {}, comparison, range, first.shown(), second.shown());
    return target.toImage();
  }
  QImage alone(const widgets::PreviewRenderer& picture, const widgets::DisplaySettings& settings = {}) {
    QOpenGLFramebufferObject target(side, side);
    target.bind();
    display_->present({side, side}, settings, picture.shown());
    return target.toImage();
  }

  std::unique_ptr<test::OffscreenContext> context_;
  std::shared_ptr<widgets::PreviewResources> resources_;
  std::unique_ptr<widgets::PreviewDisplay> display_;
  std::unique_ptr<widgets::PreviewRenderer> bright_, dark_;
};

GONIO_TEST(PreviewDisplayTest)
}  // namespace preview_display_test

#include "preview_display_test.moc"
