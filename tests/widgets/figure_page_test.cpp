// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/figures/figure_page.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/widgets/pointer.h"

namespace figure_page_test {
using namespace gonio::widgets;

class FigurePageTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<FigurePage> m_page;

  QPoint at(std::size_t picture, double x, double y) const {
    const QRectF place = m_page->placeOf(picture);
    return QPointF(place.x() + x * place.width(), place.y() + y * place.height()).toPoint();
  }
  void drag(const QPoint& from, const QPoint& to) {
    QTest::mousePress(m_page.get(), Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, m_page->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(m_page.get(), &move);
    QTest::mouseRelease(m_page.get(), Qt::LeftButton, {}, to);
  }
  static bool isNear(const QRectF& a, const QRectF& b) {
    constexpr double pixel = 0.01;
    return std::abs(a.x() - b.x()) < pixel && std::abs(a.y() - b.y()) < pixel &&
           std::abs(a.width() - b.width()) < pixel;
  }

 private Q_SLOTS:
  void init() {
    m_page = std::make_unique<FigurePage>();
    m_page->resize(824, 500);
    QImage page(800, 400, QImage::Format_RGB32);
    page.fill(Qt::white);
    m_page->setPage(page, {QRectF(0, 0, 0.25, 0.5), QRectF(0.5, 0.25, 0.25, 0.5)});
    m_page->show();
  }

  void pageIsAsWideAsTheWidget() {
    QCOMPARE(m_page->pageWidth(), 800);
    QCOMPARE(m_page->heightForWidth(824), 424);
    QCOMPARE(m_page->placeOf(1), QRectF(412, 112, 200, 200));
    QSignalSpy resized(m_page.get(), &FigurePage::resized);
    m_page->resize(424, 500);
    QCOMPARE(resized.count(), 1);
    QCOMPARE(m_page->pageWidth(), 400);
  }

  /// The whole page is visible in the middle of the surrounding widget, whatever its shape.
  void aWholePage() {
    QWidget around;
    around.resize(824, 224);
    m_page->setParent(&around);
    m_page->resize(824, 224);
    QSignalSpy resized(m_page.get(), &FigurePage::resized);
    m_page->setWhole(true);
    QCOMPARE(resized.count(), 1);
    QCOMPARE(m_page->pageWidth(), 400);
    QCOMPARE(m_page->heightForWidth(824), 224);
    QCOMPARE(m_page->placeOf(0), QRectF(212, 12, 100, 100));
    around.resize(824, 600);
    QCOMPARE(m_page->heightForWidth(824), 424);
    m_page->setWhole(false);
    QCOMPARE(m_page->pageWidth(), 800);
    m_page->setParent(nullptr);
  }

  /// From any corner, in any picture; always a square inside the picture.
  void drawsASquare() {
    QSignalSpy drawn(m_page.get(), &FigurePage::squareDrawn);
    drag(at(1, 0.25, 0.5), at(1, 0.5, 0.6));
    QVERIFY(isNear(drawn.takeFirst()[0].toRectF(), {0.25, 0.5, 0.25, 0.25}));
    m_page->setSquare(std::nullopt);
    drag(at(0, 0.75, 0.75), at(0, 0.5, 0.25));
    QVERIFY(isNear(drawn.takeFirst()[0].toRectF(), {0.25, 0.25, 0.5, 0.5}));
    m_page->setSquare(std::nullopt);
    drag(at(0, 0.8, 0.1), at(0, 0.99, 0.99));
    const QRectF cut = drawn.takeFirst()[0].toRectF();
    QVERIFY(isNear(cut, {0.8, 0.1, 0.2, 0.2}) && cut.right() <= 1 && cut.bottom() <= 1);
  }

  /// A drag that begins in the square moves it, also in another picture than before; it stays inside.
  void movesTheSquare() {
    m_page->setSquare(QRectF(0.25, 0.25, 0.25, 0.25));
    QSignalSpy drawn(m_page.get(), &FigurePage::squareDrawn);
    drag(at(1, 0.3, 0.3), at(1, 0.5, 0.4));
    QVERIFY(isNear(drawn.takeFirst()[0].toRectF(), {0.45, 0.35, 0.25, 0.25}));
    drag(at(0, 0.5, 0.4), at(0, 0.99, 0.01));
    QCOMPARE(drawn.takeFirst()[0].toRectF().right(), 1.0);
  }

  /// Clicks, drags outside the pictures and a page that a message hides draw nothing; Escape takes a drag back.
  void whatIsNoDragIsNothing() {
    QSignalSpy drawn(m_page.get(), &FigurePage::squareDrawn);
    drag(at(0, 0.5, 0.5), at(0, 0.505, 0.5));
    drag(QPoint(300, 100), QPoint(350, 150));
    QTest::mousePress(m_page.get(), Qt::LeftButton, {}, at(0, 0.2, 0.2));
    QTest::keyClick(m_page.get(), Qt::Key_Escape);
    QTest::mouseRelease(m_page.get(), Qt::LeftButton, {}, at(0, 0.6, 0.6));
    m_page->setMessage("Add materials");
    drag(at(0, 0.2, 0.2), at(0, 0.6, 0.6));
    QCOMPARE(drawn.count(), 0);
  }

  /// What is drawn stands in all pictures while the pointer moves.
  void theDragIsShown() {
    const QImage before = m_page->grab().toImage();
    QTest::mousePress(m_page.get(), Qt::LeftButton, {}, at(0, 0.2, 0.2));
    const QPoint to = at(0, 0.6, 0.6);
    QMouseEvent move(QEvent::MouseMove, to, m_page->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(m_page.get(), &move);
    const QImage during = m_page->grab().toImage();
    for (const std::size_t picture : {0, 1}) {
      // A white line between black ones, on all four sides; nothing else.
      const QRect square(at(picture, 0.2, 0.2), at(picture, 0.6, 0.6));
      const QPoint middle = square.center();
      for (const auto& [side, across] : {std::pair(QPoint(square.left(), middle.y()), QPoint(1, 0)),
                                         {QPoint(square.right(), middle.y()), QPoint(1, 0)},
                                         {QPoint(middle.x(), square.top()), QPoint(0, 1)},
                                         {QPoint(middle.x(), square.bottom()), QPoint(0, 1)}}) {
        QCOMPARE(during.pixelColor(side), QColor(Qt::white));
        for (const QPoint& beside : {side - across, side + across})
          QCOMPARE(during.pixelColor(beside), QColor(Qt::black));
        for (const QPoint& beyond : {side - 3 * across, side + 3 * across})
          QCOMPARE(during.pixelColor(beyond), QColor(Qt::white));
      }
    }
    QTest::mouseRelease(m_page.get(), Qt::LeftButton, {}, to);
    QVERIFY(m_page->grab().toImage() == before);
  }

  void theCursorShowsWhatADragDoes() {
    m_page->setSquare(QRectF(0.25, 0.25, 0.25, 0.25));
    const auto cursor = [&](const QPoint& place) {
      gonio::test::pointAt(*m_page, place);
      return m_page->cursor().shape();
    };
    QCOMPARE(cursor(at(0, 0.3, 0.3)), Qt::SizeAllCursor);
    QCOMPARE(cursor(at(0, 0.8, 0.8)), Qt::CrossCursor);
    QCOMPARE(cursor(QPoint(300, 300)), Qt::ArrowCursor);
  }
};

GONIO_TEST(FigurePageTest)
}  // namespace figure_page_test

#include "figure_page_test.moc"
