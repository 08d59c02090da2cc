// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_session.h"

#include <QFileInfo>
#include <QSignalSpy>
#include <QTest>
#include <latch>
#include <set>

#include "app/gonio/acquisition/acquisition_charts.h"
#include "tests/app/gonio/acquisition_test_support.h"
#include "tests/support/test_program.h"

namespace acquisition_session_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

struct Acquisition {
  SmallLibrary library;
  BackgroundTasks tasks;
  AcquisitionSession session{tasks};
  std::vector<AcquisitionSession::Step> steps;
  QStringList failures;

  Acquisition() {
    session.referenceReader().setPicture(smallPicture());
    QObject::connect(&session, &AcquisitionSession::progressed, &session, [this] {
      if (steps.empty() || steps.back() != session.step()) steps.push_back(session.step());
    });
    QObject::connect(&session, &AcquisitionSession::failed, &session,
                     [this](const QString&, const QString& text) { failures << text; });
  }
  bool waitForAll() {
    const bool done = QTest::qWaitFor([&] { return tasks.isIdle(); }, patienceMilliseconds);
    QCoreApplication::processEvents();  // what was reported on the way
    return done;
  }
  bool measure(const QString& id) {
    session.referenceReader().read(id);
    return waitForAll() && session.referenceReader().reference();
  }
  bool plan(const PlanSettings& settings) {
    session.plan(settings);
    return waitForAll() && session.planner().hasPlan();
  }
};

TabulatedBrdf::Value cellValue(const TabulatedBrdf& table, std::uint32_t cell) { return table.values()[cell]; }

class AcquisitionSessionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void planMeasureReconstruct() {
    Acquisition acquisition;
    AcquisitionSession& session = acquisition.session;
    QVERIFY(acquisition.measure(acquisition.library.subject));
    QSignalSpy directions(&session, &AcquisitionSession::directionsChanged);
    QVERIFY(acquisition.plan(acquisition.library.settings(8)));
    QVERIFY(acquisition.failures.isEmpty());
    // One by one, beside being forgotten at first and all at the end.
    QCOMPARE(directions.count(), 8 + 2);
    QCOMPARE(session.planner().directions().size(), std::size_t(8));
    const auto& cells = session.planner().selection().cells;
    QCOMPARE(std::set(cells.begin(), cells.end()).size(), std::size_t(8));
    QCOMPARE(session.planner().samplingPlan().samples.size(), std::size_t(8));
    // Without noise a reading is the table's value there.
    QCOMPARE(session.values().rgb.size(), std::size_t(8));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Rgb expected(cellValue(*session.referenceReader().reference()->table, cells[i])),
          read = session.values().rgb[i];
      QVERIFY(glm::length(read - expected) <= 1e-5 * glm::length(expected));
    }
    QVERIFY(session.result() && session.result()->error);
    QVERIFY(!session.result()->picture.isNull() && !session.result()->errorMap.isNull());
    QVERIFY(session.result()->errorRange > 0 && session.result()->deviationRange > 0);
    // The last point of the curve is the result itself.
    QCOMPARE(session.curve().size(), curveCounts(8).size());
    QCOMPARE(session.curve().back().samples, 8);
    QCOMPARE(session.curve().back().error.renderedSnr, session.result()->error->renderedSnr);
    using Step = AcquisitionSession::Step;
    QCOMPARE(acquisition.steps.back(), Step::idle);
    std::erase(acquisition.steps, Step::idle);
    const std::vector<Step> expected{Step::learning, Step::choosing, Step::reconstructing, Step::measuringCurve};
    QCOMPARE(acquisition.steps, expected);
  }

  /// The bundled dictionaries are of the MERL grid. Directions over their atoms take minutes to learn; that they need
  /// materials of that grid is said before, and the session goes on.
  void atomsNeedTheGridOfTheDictionaries() {
    Acquisition acquisition;
    QVERIFY(acquisition.measure(acquisition.library.subject));
    PlanSettings settings = acquisition.library.settings(6);
    settings.overAtoms = true;
    QVERIFY(!acquisition.plan(settings));
    QCOMPARE(acquisition.failures.size(), 1);
    QVERIFY2(acquisition.failures[0].contains(QStringLiteral("90 x 90 x 180")), qPrintable(acquisition.failures[0]));
    QVERIFY(!acquisition.session.isBusy());
    settings.overAtoms = false;
    QVERIFY(acquisition.plan(settings));
  }

  /// A material of the training set lies in the span of its components: enough samples without a ridge find it again.
  void whatWasLearnedIsFoundAgain() {
    Acquisition acquisition;
    AcquisitionSession& session = acquisition.session;
    QVERIFY(acquisition.measure(acquisition.library.training.ids[2]));
    acquisition::ReconstructionOptions exact;
    exact.ridge = 1e-9;
    exact.components = 1000;
    session.setReconstruction(exact);
    PlanSettings settings = acquisition.library.settings(40);
    settings.leaveOutReference = false;
    QVERIFY(acquisition.plan(settings));
    QVERIFY(session.isReferenceLearned());
    QVERIFY2(session.result()->error->renderedSnr > 50,
             qPrintable(QString::number(session.result()->error->renderedSnr)));
    QVERIFY(session.result()->error->logError < 1e-3);
    // Few of its samples do not.
    QVERIFY(session.curve().front().error.renderedSnr < session.result()->error->renderedSnr);
  }

  void theMeasuredMaterialIsNotLearned() {
    Acquisition acquisition;
    AcquisitionSession& session = acquisition.session;
    QVERIFY(acquisition.measure(acquisition.library.training.ids[2]));
    QVERIFY(acquisition.plan(acquisition.library.settings()));
    QCOMPARE(session.planner().learnedMaterials(), int(acquisition.library.training.ids.size()) - 1);
    QVERIFY(!session.isReferenceLearned());
    QCOMPARE(without({"library:rgl/cc_iris", "/a/cc_iris_rgb.bsdf", "/a/CC_IRIS.binary", "library:rgl/cc_iris2"},
                     "library:rgl/cc_iris"),
             QStringList{"library:rgl/cc_iris2"});
    QCOMPARE(without({"a", "b"}, {}), (QStringList{"a", "b"}));
  }

  void aLearnedSetIsKept() {
    Acquisition acquisition;
    AcquisitionSession& session = acquisition.session;
    QVERIFY(acquisition.plan(acquisition.library.settings(5)));
    const auto basis = session.planner().basis();
    acquisition.steps.clear();
    QVERIFY(acquisition.plan(acquisition.library.settings(6)));
    QCOMPARE(session.planner().basis(), basis);
    QVERIFY(std::ranges::find(acquisition.steps, AcquisitionSession::Step::learning) == acquisition.steps.end());
    // Without a material to measure there are no values and no result.
    QVERIFY(session.values().rgb.empty() && !session.result());
    // Another set is learned.
    PlanSettings other = acquisition.library.settings(5);
    other.training.ids.removeLast();
    QVERIFY(acquisition.plan(other));
    QVERIFY(session.planner().basis() != basis);
  }

  void whatIsCancelledLeavesNothing() {
    Acquisition acquisition;
    AcquisitionSession& session = acquisition.session;
    QVERIFY(acquisition.measure(acquisition.library.subject));
    QVERIFY(acquisition.plan(acquisition.library.settings(5)));
    const auto stop = connect(&session, &AcquisitionSession::directionsChanged, &session, [&] {
      if (!session.planner().directions().empty() && session.step() == AcquisitionSession::Step::choosing)
        session.cancel();
    });
    session.plan(acquisition.library.settings(30));
    QVERIFY(session.planner().directions().empty() && !session.result());
    QVERIFY(acquisition.waitForAll());
    QTest::qWait(100);
    QVERIFY(session.planner().directions().empty() && !session.planner().hasPlan() && session.values().rgb.empty() &&
            !session.result());
    QCOMPARE(session.step(), AcquisitionSession::Step::idle);
    QVERIFY(acquisition.failures.isEmpty());
    disconnect(stop);
    // Escape stops it too; here before it has begun, since other work holds both threads.
    std::latch release(1);
    for (const char* key : {"first", "second"})
      acquisition.tasks.run<bool>(
          {"other work", key},
          [&release](const TaskControl&) {
            release.wait();
            return true;
          },
          [](bool) {});
    session.plan(acquisition.library.settings(30));
    acquisition.tasks.cancelTopmost();
    release.count_down();
    QVERIFY(acquisition.waitForAll());
    QVERIFY(!session.isBusy() && !session.planner().hasPlan());
    QVERIFY(acquisition.plan(acquisition.library.settings(5)));
  }

  void valuesOfARigTakeThePlaceOfSimulatedOnes() {
    Acquisition acquisition;
    AcquisitionSession& session = acquisition.session;
    QVERIFY(acquisition.plan(acquisition.library.settings(6)));
    acquisition::MeasuredValues values;
    values.rgb.assign(5, Rgb(0.1));
    QVERIFY_THROWS_EXCEPTION(Error, session.setValues(values, "short"));
    QVERIFY(!session.result());
    values.rgb.assign(6, Rgb(0.1));
    session.setValues(values, "rig.csv");
    QVERIFY(acquisition.waitForAll());
    QCOMPARE(session.resultName(), QString("rig from 6 samples"));
    QVERIFY(session.result() && !session.result()->error && session.result()->errorMap.isNull());
    QVERIFY(!session.result()->picture.isNull() && session.curve().empty() && !session.isSimulated());
    // A material to compare with leaves them as they are.
    QVERIFY(acquisition.measure(acquisition.library.subject));
    QVERIFY(!session.isSimulated() && session.values().rgb[0] == Rgb(0.1) && session.result()->error);
    QCOMPARE(session.resultName(), QString("rig from 6 samples"));
    // Noise: simulated again, and another value.
    session.simulate({.relative = 0.1});
    QVERIFY(acquisition.waitForAll());
    QVERIFY(session.isSimulated() && session.values().rgb[0] != Rgb(0.1) && !session.values().noise.empty());
  }

  /// Without a material nothing is reconstructed, also what has begun; until another one is read the result is named
  /// after the one that it is of.
  void whatIsMeasuredIsTakenAway() {
    Acquisition acquisition;
    AcquisitionSession& session = acquisition.session;
    QVERIFY(acquisition.measure(acquisition.library.subject));
    QVERIFY(acquisition.plan(acquisition.library.settings(6)));
    session.referenceReader().read(acquisition.library.training.ids[0]);
    QCOMPARE(session.resultName(), QString("subject from 6 samples"));
    QVERIFY(acquisition.waitForAll());
    session.simulate({.relative = 0.1});
    QVERIFY(session.isBusy());
    session.referenceReader().clear();
    QVERIFY(acquisition.waitForAll());
    QVERIFY(!session.isBusy() && !session.result() && session.values().rgb.empty() && session.curve().empty());
    QVERIFY(session.planner().hasPlan());
  }

  void theResultIsAMaterialLikeAnyOther() {
    Acquisition acquisition;
    AcquisitionSession& session = acquisition.session;
    QVERIFY(acquisition.measure(acquisition.library.subject));
    QVERIFY(acquisition.plan(acquisition.library.settings(6)));
    Document document;
    const QString folder = acquisition.library.folder.filePath("acquired");
    connect(&session, &AcquisitionSession::materialMade, &document, &Document::replaceMaterial);
    session.open(folder);
    QVERIFY(acquisition.waitForAll());
    QVERIFY(document.material());
    QCOMPARE(document.material()->table()->values()[100], session.result()->reconstruction->table->values()[100]);
    const QString path = QString::fromStdString(document.material()->material.source.path.string());
    QCOMPARE(path, folder + "/subject from 6 samples.binary");
    QVERIFY(document.history().canUndo());
    document.history().undo();
    QVERIFY(!document.material());
    // The file of the first stays as it is.
    session.open(folder);
    QVERIFY(acquisition.waitForAll());
    QVERIFY(QFileInfo::exists(folder + "/subject from 6 samples 2.binary"));
  }

  void whatCannotBeLearnedIsTold() {
    Acquisition acquisition;
    PlanSettings settings = acquisition.library.settings();
    settings.training.ids.resize(1);
    QVERIFY(!acquisition.plan(settings));
    QCOMPARE(acquisition.failures, QStringList{"The training set has 1 material; it needs at least 2."});
    settings.training.ids << "/nowhere/missing.binary";
    QVERIFY(!acquisition.plan(settings));
    QVERIFY2(acquisition.failures.last().contains("/nowhere/missing.binary"), qPrintable(acquisition.failures.last()));
    QVERIFY(!acquisition.measure("/nowhere/missing.binary"));
    QVERIFY(acquisition.session.referenceReader().id().isEmpty());
    QCOMPARE(acquisition.failures.size(), 3);
  }

  void countsOfTheCurve() {
    QCOMPARE(curveCounts(60), (std::vector<int>{5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60}));
    QCOMPARE(curveCounts(5), (std::vector<int>{1, 2, 3, 4, 5}));
    QCOMPARE(curveCounts(1), std::vector<int>{1});
  }

  void theSliceTellsWhatCanBeMeasured() {
    const HalfDifferenceGrid grid{18, 18, 12};
    acquisition::MeasurableDirections measurable;
    measurable.maxPolarAngle = radians(60);
    measurable.minSeparation = radians(12);
    dictionary::MappedCells mapping{.grid = grid, .cells = {}, .weights = {}, .reference = {}};
    std::vector<float> deviations;
    const auto unlearned = grid.index(3, 4, 5);
    for (std::uint32_t cell = 0; cell < grid.size(); ++cell)
      if (cell != unlearned && grid.nodeAboveHorizon(cell)) {
        mapping.cells.push_back(cell);
        deviations.push_back(float(cell));
      }
    const auto slice = sliceAt(5, grid, measurable, &mapping, deviations);
    QCOMPARE(slice.phiD, 5 * pi / 12);
    using widgets::CellState;
    std::set<CellState> seen;
    for (int i = 0; i < 18; ++i)
      for (int j = 0; j < 18; ++j) {
        const std::size_t cell = grid.index(i, j, 5), at = std::size_t(i * 18 + j);
        const DirectionPair pair = grid.directions(cell);
        const double largest = std::max(polarAngle(pair.wi), polarAngle(pair.wo));
        const CellState expected = !grid.nodeAboveHorizon(cell)                 ? CellState::belowHorizon
                                   : largest > radians(60) + 1e-9               ? CellState::grazing
                                   : grid.node(cell).thetaD < radians(6) - 1e-9 ? CellState::forbidden
                                   : cell == unlearned                          ? CellState::unlearned
                                                                                : CellState::measurable;
        QCOMPARE(slice.states[at], expected);
        seen.insert(expected);
        if (expected == CellState::belowHorizon || expected == CellState::unlearned)
          QVERIFY(std::isnan(slice.deviations[at]));
        else
          QCOMPARE(slice.deviations[at], float(cell));
      }
    QCOMPARE(seen.size(), std::size_t(5));
    // Before anything is learned all cells count.
    const auto before = sliceAt(5, grid, measurable, nullptr, {});
    QCOMPARE(before.states[3 * 18 + 4], CellState::measurable);
    QVERIFY(before.deviations.empty());
  }
};

GONIO_TEST(AcquisitionSessionTest)
}  // namespace acquisition_session_test

#include "acquisition_session_test.moc"
