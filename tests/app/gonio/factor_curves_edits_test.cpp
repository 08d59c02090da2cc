// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "app/gonio/document/edit_steps.h"
#include "core/factorization/pdv_operations.h"
#include "core/formats/pdv.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/factor_curves_test_support.h"
#include "tests/support/test_program.h"
#include "widgets/library/material_drag.h"

namespace factor_curves_edits_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;
using factorization::PdvFactors;

/// The largest difference, relative to the largest value of b.
double maxDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(b[i]));
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  return difference / std::max(largest, 1e-300);
}

/// What the hand does to the curves: every test begins with all steps undone.
class FactorCurvesEditsTest : public QObject, private OpenFactorCurves {
  Q_OBJECT
 private:
  void drop(FactorAxis axis, const QString& id) {
    FactorColumn& column = m_panel->column(axis);
    const std::unique_ptr<QMimeData> data(widgets::toDrag(id));
    QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&column, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(20, 20), Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&column, &event);
  }

 private Q_SLOTS:
  void initTestCase() { openPanel(); }
  void init() { undoAll(); }
  void cleanupTestCase() { m_panel.reset(); }

  /// A drag that Escape takes back leaves no step.
  void escapeLeavesNoStep() {
    widgets::CurveEditor& strength = editor(FactorAxis::theta);
    strength.setFocus();
    const QPoint from = strength.pointPosition(0).toPoint();
    QTest::mousePress(&strength, Qt::LeftButton, {}, from);
    QTest::mouseMove(&strength, from - QPoint(0, 20));
    QVERIFY(factorEdit(m_document));
    QTest::keyClick(&strength, Qt::Key_Escape);
    QTest::mouseRelease(&strength, Qt::LeftButton, {}, from);
    QCOMPARE(m_document.history().count(), 0);
    QVERIFY(!factorEdit(m_document));
  }

  /// All steps of the hand are one step back: pulled points, in between seen at once.
  void aDragIsOneStep() {
    widgets::CurveEditor& strength = editor(FactorAxis::theta);
    const widgets::ChannelCurves before = strength.curves();
    const QPoint from = strength.pointPosition(0).toPoint();
    QSignalSpy changed(&m_document, &Document::editChanged);
    QTest::mousePress(&strength, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 4; ++i) QTest::mouseMove(&strength, from - QPoint(0, 6 * i));
    QCOMPARE(changed.count(), 4);
    QTest::mouseRelease(&strength, Qt::LeftButton, {}, from - QPoint(0, 24));
    QCOMPARE(m_document.history().count(), 1);
    QCOMPARE(m_document.history().text(0), QStringLiteral("Change F1"));
    QVERIFY(edit().edited->channels[0][0].f1[0] > before[0][0]);
    QVERIFY(edit().edited->channels[0][0].f2 == edit().original->channels[0][0].f2);
    m_document.history().undo();
    QVERIFY(!factorEdit(m_document));
    QVERIFY(strength.curves() == before);
    m_document.history().redo();
    QVERIFY(strength.curves() ==
            widgets::ChannelCurves({edit().edited->channels[0][0].f1, edit().edited->channels[1][0].f1,
                                    edit().edited->channels[2][0].f1}));
  }

  /// What each button does to the curves, by a property of its own; the clean words of its undo step.
  void buttonsDoWhatTheySay() {
    const std::size_t last = editor(FactorAxis::theta).nodes().size() - 1;
    const auto f1 = [this](std::size_t channel, std::size_t at) { return edit().edited->channels[channel][0].f1[at]; };
    const auto was = [this](std::size_t channel, std::size_t at) {
      return edit().original->channels[channel][0].f1[at];
    };
    press(FactorAxis::theta, "Stronger");
    for (std::size_t term = 0; term < 3; ++term)
      QVERIFY(maxDifference(edit().edited->channels[1][term].f1,
                            factorization::scaled(edit().original->channels[1][term].f1, 1.1)) < 1e-12);
    QCOMPARE(m_document.history().text(0), QStringLiteral("F1: Stronger"));
    press(FactorAxis::theta, "Weaker");
    QVERIFY(std::abs(f1(0, last) / was(0, last) - 1) < 1e-12);
    QCOMPARE(m_document.history().count(), 2);
    press(FactorAxis::theta, "Tilt up");
    QVERIFY(std::abs(f1(2, 0) / was(2, 0) - 0.9) < 1e-12 && std::abs(f1(2, last) / was(2, last) - 1.1) < 1e-12);
    press(FactorAxis::theta, "Reset");
    QVERIFY(!factorEdit(m_document));
    press(FactorAxis::theta, "Tilt down");
    QVERIFY(std::abs(f1(2, 0) / was(2, 0) - 1.1) < 1e-12 && std::abs(f1(2, last) / was(2, last) - 0.9) < 1e-12);
    press(FactorAxis::theta, "Reset");
    QVERIFY(!factorEdit(m_document));

    // Half of its height is reached 10 % farther out, for every colour.
    press(FactorAxis::deviation, "Wider");
    const std::vector<double> nodes = edit().edited->deviationNodes;
    for (std::size_t c = 0; c < 3; ++c)
      QVERIFY(maxDifference(edit().edited->channels[c][0].f2,
                            factorization::widened(nodes, edit().original->channels[c][0].f2, 1.1)) < 1e-12);
    press(FactorAxis::deviation, "Narrower");
    // What was widened beyond the last node does not come back.
    const std::vector<double>&back = edit().edited->channels[0][0].f2, &before = edit().original->channels[0][0].f2;
    for (std::size_t i = 0; i < nodes.size() && nodes[i] < nodes.back() / 1.1; ++i)
      QVERIFY(std::abs(back[i] - before[i]) < 0.02);
    // A spike spreads and keeps its sum.
    PdvFactors spiky = *edit().edited;
    std::vector<double>& curve = spiky.channels[0][0].f1;
    curve.assign(curve.size(), 0);
    curve[45] = 1;
    editing::FactorEdit spike = edit();
    spike.edited = std::make_shared<const PdvFactors>(spiky);
    replaceFactors(m_document, spike, "spike");
    press(FactorAxis::theta, "Smooth");
    QVERIFY(f1(0, 45) < 0.5 && f1(0, 44) > 0.1 && f1(0, 46) == f1(0, 44));
  }

  /// A button acts on the chosen channel alone.
  void oneChannelAlone() {
    auto* channel = child<QComboBox>("Channel");
    QVERIFY(channel);
    channel->setCurrentIndex(2);
    press(FactorAxis::theta, "Stronger");
    channel->setCurrentIndex(0);
    QVERIFY(edit().edited->channels[0] == edit().original->channels[0]);
    QVERIFY(edit().edited->channels[2] == edit().original->channels[2]);
    QVERIFY(edit().edited->channels[1] != edit().original->channels[1]);
    QCOMPARE(editor(FactorAxis::theta).channel(), widgets::CurveEditor::allChannels);
  }

  void theDetailStaysOrGoes() {
    QVERIFY(m_panel->preserveDetail().isChecked());
    m_panel->preserveDetail().click();
    QCOMPARE(m_document.history().count(), 1);
    QVERIFY(!edit().preserveDetail && !edit().isIdentity());
    m_document.history().undo();
    QVERIFY(m_panel->preserveDetail().isChecked());
    m_document.history().redo();
    QVERIFY(!m_panel->preserveDetail().isChecked());
    m_panel->preserveDetail().click();
    QVERIFY(m_panel->preserveDetail().isChecked());
    QVERIFY(!factorEdit(m_document));  // what changes nothing is no edit
  }

  /// A thumbnail on a curve: that curve of the first term is the other material's, on the nodes of this one.
  void aDroppedMaterialLendsItsCurve() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("other.pdv");
    const auto other = glossyMaterial(0.6, {24, 24, 24});
    formats::writePdv(factorization::factorizePdv(*other->table(), {.terms = 1}).factors, path.toStdString());
    for (const FactorAxis axis : {FactorAxis::theta, FactorAxis::deviation}) {
      undoAll();
      drop(axis, path);
      QVERIFY(!m_panel->isSettled());
      QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds);
      QCOMPARE(m_document.history().count(), 1);
      QVERIFY(m_document.history().text(0).contains("other.pdv"));
      QCOMPARE(edit().edited->terms(), 1);
      const auto table = materials::readMaterial(path.toStdString()).tabulated();
      const PdvFactors expected =
          factorization::factorizePdv(*table, {.form = factorization::PdvForm::twoFactors,
                                               .terms = 1,
                                               .deviationNodes = edit().original->deviationNodes})
              .factors;
      for (std::size_t c = 0; c < 3; ++c)
        for (const FactorAxis one : {FactorAxis::theta, FactorAxis::deviation})
          QVERIFY(curveOf(edit().edited->channels[c][0], one) ==
                  curveOf((one == axis ? expected : *edit().original).channels[c][0], one));
      m_document.history().undo();
      QVERIFY(!factorEdit(m_document));
    }
  }

  /// Nothing to take from a file that nobody reads: reported, and nothing changed.
  void aDropThatCannotBeReadIsTold() {
    QSignalSpy failed(m_panel.get(), &FactorCurvesPanel::failed);
    drop(FactorAxis::deviation, "/nowhere/at-all.binary");
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, patienceMilliseconds);
    QVERIFY(failed[0][1].toString().contains("at-all.binary"));
    QCOMPARE(m_document.history().count(), 0);
  }

  /// A second edit of the curves starts from those of the measurement; the selected one is what the panel changes.
  void theSelectedEditIsTheOneThatChanges() {
    press(FactorAxis::deviation, "Wider");
    const editing::FactorEdit wider = edit();
    m_panel->addEdit();
    QCOMPARE(m_document.edits().size(), std::size_t(2));
    QCOMPARE(m_document.state().selected, 1);
    QVERIFY(edit().isIdentity() && edit().original == wider.original);
    press(FactorAxis::theta, "Stronger");
    QVERIFY(std::get<editing::FactorEdit>(m_document.edits()[0].content) == wider);
    QVERIFY(editor(FactorAxis::theta).curves()[0] == edit().edited->channels[0][0].f1);
    m_document.select(0);
    QVERIFY(edit() == wider);
    QVERIFY(editor(FactorAxis::deviation).curves()[0] == wider.edited->channels[0][0].f2);
    // A drag that comes back leaves the edit where it was, though it changes nothing in between.
    m_document.select(1);
    const editing::EditList before = m_document.edits();
    m_document.beginInteraction();
    press(FactorAxis::theta, "Weaker");
    press(FactorAxis::theta, "Reset");
    QVERIFY(edit().isIdentity() && m_document.edits().size() == 2);
    press(FactorAxis::theta, "Stronger");
    m_document.endInteraction();
    QVERIFY(m_document.edits() == before);
    press(FactorAxis::theta, "Reset");
    QCOMPARE(m_document.edits().size(), std::size_t(1));
  }

  void resetAllDropsTheEdit() {
    press(FactorAxis::deviation, "Wider");
    for (QPushButton* button : m_panel->findChildren<QPushButton*>())
      if (button->text().remove('&') == "Reset All") button->click();
    QVERIFY(!factorEdit(m_document));
    QCOMPARE(m_document.history().count(), 2);
    QVERIFY(editor(FactorAxis::deviation).nodes().size() > 2);
  }
};

GONIO_TEST(FactorCurvesEditsTest)
}  // namespace factor_curves_edits_test

#include "factor_curves_edits_test.moc"
