// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/picture_exchange.h"

#include <QColor>
#include <QOpenGLFramebufferObject>
#include <QTest>

#include "offscreen_context.h"
#include "tests/support/test_program.h"

namespace picture_exchange_test {
using gonio::test::OffscreenContext;
using gonio::widgets::PictureExchange;

class PictureExchangeTest : public QObject, protected QOpenGLFunctions_4_1_Core {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    context_ = std::make_unique<OffscreenContext>();
    if (!context_->isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    initializeOpenGLFunctions();
  }
  void cleanup() {
    if (context_->isValid()) exchange_.release(*this);
  }

  void nothingIsShownBeforeTheFirstPictureIsDone() {
    QVERIFY(!shown().isValid());
    draw(Qt::red);
    QVERIFY(!shown().isValid());
    exchange_.publish(*this);
    QCOMPARE(shown(), QColor(Qt::red));
    exchange_.release(*this);
    QVERIFY(!shown().isValid());
  }

  /// The newest finished picture is shown, as often as it is asked for; those in between are left out.
  void theNewestIsShown() {
    for (const QColor colour : {Qt::red, Qt::green, Qt::blue}) {
      draw(colour);
      exchange_.publish(*this);
    }
    QCOMPARE(shown(), QColor(Qt::blue));
    draw(Qt::white);
    QCOMPARE(shown(), QColor(Qt::blue));
    exchange_.publish(*this);
    QCOMPARE(shown(), QColor(Qt::white));
    QCOMPARE(shown(), QColor(Qt::white));
  }

  /// Whatever the two sides do in turn, what is shown was finished and is of one piece.
  void aPictureOfAnotherSizeIsStretched() {
    draw(Qt::green, {5, 3});
    exchange_.publish(*this);
    QCOMPARE(shown(), QColor(Qt::green));
    draw(Qt::red, {64, 64});
    QCOMPARE(shown(), QColor(Qt::green));
    exchange_.publish(*this);
    QCOMPARE(shown(), QColor(Qt::red));
  }

 private:
  void draw(const QColor& colour, const QSize& size = {16, 16}) {
    exchange_.begin(*this, size);
    glClearColor(colour.redF(), colour.greenF(), colour.blueF(), 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }

  /// The one colour of what show() draws; invalid where it draws nothing, or several.
  QColor shown() {
    QOpenGLFramebufferObject target(16, 16);
    if (!exchange_.show(*this, target.handle(), target.size())) return {};
    const QImage picture = target.toImage();
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x)
        if (picture.pixel(x, y) != picture.pixel(0, 0)) return {};
    return picture.pixelColor(0, 0).toRgb();
  }

  std::unique_ptr<OffscreenContext> context_;
  PictureExchange exchange_;
};

GONIO_TEST(PictureExchangeTest)
}  // namespace picture_exchange_test

#include "picture_exchange_test.moc"
