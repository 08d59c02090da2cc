// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/highlight_drag.h"

#include <QTest>
#include <QUndoStack>
#include <cmath>
#include <memory>

#include "app/gonio/document/edit_steps.h"
#include "core/models/registry.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/support/test_program.h"
#include "widgets/preview/preview_widget.h"

namespace highlight_drag_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

class HighlightDragTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    preview_ = std::make_unique<widgets::PreviewWidget>();
    preview_->resize(400, 400);
    document_ = std::make_unique<Document>();
    new HighlightDrag(*preview_, *document_);
    document_->setMaterial(greyMaterial());
  }
  void cleanup() {
    preview_.reset();
    document_.reset();
  }

  /// Sideways the width, upwards the strength, each twice as large after the stated distance; one undo step.
  void widensSidewaysAndStrengthensUpwards() {
    adoptDefaultFit(*document_, models::findModel("ggx"));
    const int steps = document_->history().count();
    press();
    moveTo({20, 3});
    moveTo({way(1), 2});  // a hand trembles
    QCOMPARE(value(editing::ArtistControl::roughness), 2.0);
    QCOMPARE(value(editing::ArtistControl::specularStrength), 1.0);
    moveTo({-way(2), -way(1)});
    QCOMPARE(value(editing::ArtistControl::roughness), 0.25);
    QCOMPARE(value(editing::ArtistControl::specularStrength), 2.0);
    release();
    QCOMPARE(document_->history().count(), steps + 1);
    document_->history().undo();
    QCOMPARE(value(editing::ArtistControl::roughness), 1.0);
    QCOMPARE(value(editing::ArtistControl::specularStrength), 1.0);
  }

  /// The next drag goes on from the values of the last, up to the ends of the sliders.
  void goesOnWithinTheRangeOfTheSliders() {
    adoptDefaultFit(*document_, models::findModel("ggx"));
    for (int drag = 0; drag < 2; ++drag) {
      press();
      moveTo({way(1), 0});
      release();
    }
    QCOMPARE(value(editing::ArtistControl::roughness), 4.0);
    press();
    moveTo({way(20), -way(20)});
    release();
    const auto& controls = editing::artistControls().parameters;
    QCOMPARE(value(editing::ArtistControl::roughness),
             controls[std::size_t(editing::ArtistControl::roughness)].softMax);
    QCOMPARE(value(editing::ArtistControl::specularStrength),
             controls[std::size_t(editing::ArtistControl::specularStrength)].softMax);
  }

  /// A value beyond the slider, typed by the user, stays when the other one is dragged, and can be dragged back.
  void valuesBeyondTheSliderStay() {
    adoptDefaultFit(*document_, models::findModel("ggx"));
    setControl(*document_, editing::ArtistControl::specularStrength, Rgb(20));
    press();
    moveTo({way(1), 0});
    QCOMPARE(value(editing::ArtistControl::specularStrength), 20.0);
    moveTo({0, -way(1)});
    QCOMPARE(value(editing::ArtistControl::specularStrength), 20.0);
    moveTo({0, way(1)});
    QCOMPARE(value(editing::ArtistControl::specularStrength), 10.0);
    release();
  }

  void aModelWithoutAHighlightStays() {
    adoptDefaultFit(*document_, models::findModel("lambert"));
    press();
    moveTo({way(1), -way(1)});
    release();
    QVERIFY(modelEdit(*document_)->isIdentity());
    QCOMPARE(value(editing::ArtistControl::roughness), 1.0);
  }

  void escapeGoesBack() {
    adoptDefaultFit(*document_, models::findModel("ggx"));
    press();
    moveTo({way(1), way(1)});
    QTest::keyClick(preview_.get(), Qt::Key_Escape);
    QCOMPARE(value(editing::ArtistControl::roughness), 1.0);
    QCOMPARE(value(editing::ArtistControl::specularStrength), 1.0);
    moveTo({way(2), 0});
    QCOMPARE(value(editing::ArtistControl::roughness), 1.0);
    release();
  }

  /// The camera stays; without Alt it turns, and the material stays.
  void theCameraStays() {
    adoptDefaultFit(*document_, models::findModel("ggx"));
    const double yaw = preview_->content().scene().camera.yaw;
    press();
    moveTo({way(1), 0});
    release();
    QCOMPARE(preview_->content().scene().camera.yaw, yaw);
    QTest::mousePress(preview_.get(), Qt::LeftButton, {}, middle);
    moveTo({way(1), 0}, {});
    QTest::mouseRelease(preview_.get(), Qt::LeftButton, {}, middle);
    QVERIFY(preview_->content().scene().camera.yaw != yaw);
    QCOMPARE(value(editing::ArtistControl::roughness), 2.0);
  }

  void withoutAModelNothingChanges() {
    press();
    moveTo({way(1), 0});
    release();
    QVERIFY(document_->edits().empty());
    QCOMPARE(document_->history().count(), 0);
  }

  /// Left of the middle of a highlight the way out is to the left, whatever shines elsewhere.
  void outwardsIsAwayFromTheHighlight() {
    QImage picture(320, 200, QImage::Format_RGBA8888);
    const auto fill = [&](const QRect& rectangle, int grey) {
      for (int y = rectangle.top(); y <= rectangle.bottom(); ++y)
        for (int x = rectangle.left(); x <= rectangle.right(); ++x)
          picture.setPixelColor(x, y, QColor(grey, grey, grey));
    };
    picture.fill(Qt::black);
    QCOMPARE(HighlightDrag::outwards(picture, {0.1, 0.5}), 1);
    QCOMPARE(HighlightDrag::outwards({}, {0.1, 0.5}), 1);
    fill(QRect(0, 0, 320, 200), 60);
    fill(QRect(40, 60, 80, 60), 200);    // middle at 0.25
    fill(QRect(280, 20, 20, 160), 255);  // a rim at 0.91
    QCOMPARE(HighlightDrag::outwards(picture, {0.2, 0.45}), -1);
    QCOMPARE(HighlightDrag::outwards(picture, {0.3, 0.45}), 1);
    QCOMPARE(HighlightDrag::outwards(picture, {0.88, 0.45}), -1);
    QCOMPARE(HighlightDrag::outwards(picture, {0.94, 0.45}), 1);
  }

 private:
  static constexpr QPoint middle{200, 200};
  static int way(double doublings) {
    return int(HighlightDrag::deadPixels + doublings * HighlightDrag::pixelsPerDoubling);
  }

  double value(editing::ArtistControl control) const {
    return modelEdit(*document_)->controls.values[std::size_t(control)].x;
  }
  void press() { QTest::mousePress(preview_.get(), Qt::LeftButton, Qt::AltModifier, middle); }
  void moveTo(const QPoint& away, Qt::KeyboardModifiers modifiers = Qt::AltModifier) {
    const QPointF at = QPointF(middle + away);
    QMouseEvent event(QEvent::MouseMove, at, preview_->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(preview_.get(), &event);
  }
  void release() { QTest::mouseRelease(preview_.get(), Qt::LeftButton, Qt::AltModifier, middle); }

  std::unique_ptr<widgets::PreviewWidget> preview_;
  std::unique_ptr<Document> document_;
};

GONIO_TEST(HighlightDragTest)
}  // namespace highlight_drag_test

#include "highlight_drag_test.moc"
