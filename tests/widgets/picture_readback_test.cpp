// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/picture_readback.h"

#include <QColor>
#include <QTest>

#include "offscreen_context.h"
#include "tests/support/test_program.h"

namespace picture_readback_test {
using gonio::test::OffscreenContext;
using gonio::widgets::PictureReadback;

class PictureReadbackTest : public QObject, protected QOpenGLFunctions_4_1_Core {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    context_ = std::make_unique<OffscreenContext>();
    if (!context_->isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    initializeOpenGLFunctions();
  }
  void cleanup() {
    if (context_->isValid()) readback_.release(*this);
  }

  /// Each corner has its own colour; odd widths, since rows could be padded.
  void whatIsDrawnIsRead() {
    for (const QSize size : {QSize(16, 16), QSize(7, 3), QSize(101, 64), QSize(101, 64), QSize(2, 2)}) {
      readback_.begin(*this, size);
      clear({0, 0}, size, Qt::red);
      clear({size.width() - 1, 0}, {1, 1}, Qt::green);
      clear({0, size.height() - 1}, {1, 1}, Qt::blue);
      const QImage picture = readback_.read(*this);
      QCOMPARE(picture.size(), size);
      const int right = size.width() - 1, bottom = size.height() - 1;
      QCOMPARE(picture.pixelColor(0, bottom), QColor(Qt::red));
      QCOMPARE(picture.pixelColor(right, 0), QColor(Qt::red));
      QCOMPARE(picture.pixelColor(right, bottom), QColor(Qt::green));
      QCOMPARE(picture.pixelColor(0, 0), QColor(Qt::blue));
    }
  }

  /// A picture that was read stays as it was while the next one is drawn, and after the context's objects are gone.
  void picturesAreTheirOwn() {
    readback_.begin(*this, {16, 16});
    clear({0, 0}, {16, 16}, Qt::red);
    const QImage before = readback_.read(*this);
    readback_.begin(*this, {16, 16});
    clear({0, 0}, {16, 16}, Qt::green);
    QCOMPARE(readback_.read(*this).pixelColor(8, 8), QColor(Qt::green));
    readback_.release(*this);
    QCOMPARE(before.pixelColor(8, 8), QColor(Qt::red));
    readback_.begin(*this, {16, 16});
    clear({0, 0}, {16, 16}, Qt::blue);
    QCOMPARE(readback_.read(*this).pixelColor(8, 8), QColor(Qt::blue));
  }

 private:
  /// Fills a rectangle; the origin is OpenGL's, below.
  void clear(const QPoint& at, const QSize& size, const QColor& colour) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(at.x(), at.y(), size.width(), size.height());
    glClearColor(colour.redF(), colour.greenF(), colour.blueF(), 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
  }

  std::unique_ptr<OffscreenContext> context_;
  PictureReadback readback_;
};

GONIO_TEST(PictureReadbackTest)
}  // namespace picture_readback_test

#include "picture_readback_test.moc"
