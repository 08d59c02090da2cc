// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/study/study_scatter.h"

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <limits>

#include "tests/support/test_program.h"
#include "tests/widgets/pixels.h"
#include "tests/widgets/pointer.h"

namespace study_scatter_test {
using namespace gonio;
using namespace gonio::widgets;

study::StudyRecord record(const study::Representation& representation, double nanoseconds, double snr) {
  return {.representation = representation,
          .bytes = std::size_t(1000 / nanoseconds),
          .evaluation = {nanoseconds, nanoseconds, nanoseconds},
          .errors = std::vector<double>(metrics::allBrdfMetrics().size(), 1 / nanoseconds),
          .renderedSnr = snr};
}

/// The dear one first; the last has no place.
std::vector<study::StudyRecord> records() {
  const auto all = study::representationsOf({.names = {"table", "factors"}, .terms = {1, 10}});
  return {record(all[1], 500, std::numeric_limits<double>::infinity()), record(all[2], 20, 10), record(all[3], 100, 30),
          record(all[0], 50, std::nan(""))};
}

struct Shown {
  StudyScatter scatter;
  QWidget& chart = *scatter.findChild<QWidget*>("chart");
  Shown() {
    scatter.resize(500, 300);
    scatter.show();
    scatter.setRecords(records(), {});
    QTest::qWait(0);  // for the layout
  }
  QPoint at(int point) const { return scatter.place(point)->toPoint(); }
};

class StudyScatterTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void betterIsHigherAndDearerIsFurther() {
    Shown shown;
    QVERIFY(shown.at(1).x() < shown.at(2).x() && shown.at(2).x() < shown.at(0).x());
    QVERIFY(shown.at(1).y() > shown.at(2).y() && shown.at(2).y() > shown.at(0).y());
    QVERIFY(!shown.scatter.place(3) && !shown.scatter.place(4) && !shown.scatter.place(-1));
    for (const int point : {0, 1, 2}) QVERIFY(shown.chart.rect().contains(shown.at(point)));
    // Over bytes the order turns round, and so does that of errors.
    shown.scatter.setRecords(records(), {.cost = study::Cost::bytes, .quality = metrics::BrdfMetric::log});
    QTest::qWait(0);
    QVERIFY(shown.at(0).x() < shown.at(1).x());
    QVERIFY(shown.at(0).y() > shown.at(1).y());
  }

  void aClickChoosesAPoint() {
    Shown shown;
    QSignalSpy chosen(&shown.scatter, &StudyScatter::chosen);
    QTest::mouseClick(&shown.chart, Qt::LeftButton, {}, shown.at(2) + QPoint(2, -1));
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen[0][0].toInt(), 2);
    QCOMPARE(shown.scatter.current(), 2);
    QTest::mouseClick(&shown.chart, Qt::LeftButton, {}, (shown.at(2) + shown.at(1)) / 2);
    QCOMPARE(chosen.count(), 1);
  }

  void thePointerTellsWhereItIs() {
    Shown shown;
    QSignalSpy hovered(&shown.scatter, &StudyScatter::hovered);
    test::pointAt(shown.chart, shown.at(1));
    test::pointAt(shown.chart, (shown.at(2) + shown.at(1)) / 2);
    QCOMPARE(hovered.count(), 2);
    QCOMPARE(hovered[0][0].toInt(), 1);
    QCOMPARE(hovered[1][0].toInt(), -1);
  }

  /// From the cheapest to the dearest and no further, passing over what has no place.
  void keysGoFromPointToPoint() {
    Shown shown;
    QSignalSpy current(&shown.scatter, &StudyScatter::currentChanged), chosen(&shown.scatter, &StudyScatter::chosen),
        activated(&shown.scatter, &StudyScatter::activated), dismissed(&shown.scatter, &StudyScatter::dismissed);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Space}) QTest::keyClick(&shown.scatter, key);
    QCOMPARE(chosen.count() + activated.count(), 0);
    for (const int expected : {1, 2, 0, 0}) {
      QTest::keyClick(&shown.scatter, Qt::Key_Right);
      QCOMPARE(shown.scatter.current(), expected);
    }
    QTest::keyClick(&shown.scatter, Qt::Key_Left);
    QCOMPARE(current.last()[0].toInt(), 2);
    QTest::keyClick(&shown.scatter, Qt::Key_Space);
    QCOMPARE(chosen.last()[0].toInt(), 2);
    QCOMPARE(activated.count(), 0);
    QTest::keyClick(&shown.scatter, Qt::Key_Return);
    QCOMPARE(activated.last()[0].toInt(), 2);
    QTest::mouseDClick(&shown.chart, Qt::LeftButton, {}, shown.at(1));
    QCOMPARE(activated.last()[0].toInt(), 1);
    QTest::keyClick(&shown.scatter, Qt::Key_Escape);
    QCOMPARE(dismissed.count(), 1);
  }

  void withoutPointsItShowsItsHint() {
    Shown shown;
    shown.scatter.setHint("Measure first.");
    shown.scatter.setMarks(2, 0);
    shown.scatter.setRecords({}, {});
    const auto* hint = shown.scatter.findChild<QLabel*>();
    QVERIFY(hint->isVisible() && hint->text() == "Measure first.");
    QTest::keyClick(&shown.scatter, Qt::Key_Right);
    QCOMPARE(shown.scatter.current(), -1);
    shown.scatter.setRecords(records(), {});
    QVERIFY(!hint->isVisible());
    // Nor are there points of costs that were not measured.
    study::StudyRecord untimed = records()[1];
    untimed.evaluation.median = std::nan("");
    shown.scatter.setRecords({untimed}, {});
    QVERIFY(hint->isVisible() && !shown.scatter.place(0));
  }

  /// A ring in the accent's colour about the point that is shown, about none other.
  void marksAreDrawn() {
    Shown shown;
    const QColor accent = PlotStyle::of(shown.scatter.palette()).accent;
    const auto ringed = [&](int point) { return test::colouredAround(shown.chart, shown.at(point), 8.5, accent); };
    for (const int marked : {-1, 2, 1}) {
      shown.scatter.setMarks(marked, 0);
      QTest::qWait(0);
      for (const int point : {0, 1, 2})
        QVERIFY2((point == marked) ? ringed(point) > 0.8 : ringed(point) < 0.2, qPrintable(QString::number(point)));
    }
  }
};

GONIO_TEST(StudyScatterTest)
}  // namespace study_scatter_test

#include "study_scatter_test.moc"
