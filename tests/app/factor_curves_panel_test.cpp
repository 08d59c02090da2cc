// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/factor_curves_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "app/gonio/factor_terms_view.h"
#include "core/factorization/pdv_operations.h"
#include "core/io/pdv_file.h"
#include "widgets/curves/curve_editor.h"
#include "widgets/curves/residual_strip.h"
#include "widgets/library/material_drag.h"

using namespace gonio;
using namespace gonio::app;
using factorization::PdvFactors;

namespace {

constexpr int patienceMilliseconds = 120000;

LoadedMaterialPtr glossyMaterial(double roughness) {
  const models::Model& ggx = models::findModel("ggx");
  models::ParameterValues values = models::defaultParameters(ggx.spec());
  values.values[*ggx.spec().find("roughness")] = Rgb(roughness);
  values.values[*ggx.spec().find("specular")] = Rgb(0.9, 0.6, 0.3);
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = "glossy";
  loaded->table = bakeTable(*ggx.instantiate(values), {24, 24, 24});
  loaded->material.brdf = loaded->table;
  return loaded;
}

/// The largest difference, relative to the largest value of b.
double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(b[i]));
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  return difference / std::max(largest, 1e-300);
}

}  // namespace

/// The dock's panel on one material: every test begins with all steps undone.
class FactorCurvesPanelTest : public QObject {
  Q_OBJECT
 private:
  BackgroundTasks m_tasks;
  Document m_document;
  std::unique_ptr<FactorCurvesPanel> m_panel;

  const editing::FactorEdit& edit() const { return *m_document.factors(); }
  widgets::CurveEditor& editor(FactorAxis axis) const { return m_panel->column(axis).editor(); }
  template <class Widget>
  Widget* child(const QString& accessibleName) const {
    for (Widget* one : m_panel->findChildren<Widget*>())
      if (one->accessibleName() == accessibleName) return one;
    return nullptr;
  }
  void press(FactorAxis axis, const QString& text) const {
    for (QToolButton* button : m_panel->column(axis).findChildren<QToolButton*>())
      if (button->text() == text) return button->click();
    QFAIL(qPrintable("no button " + text));
  }
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
  void initTestCase() {
    m_panel = std::make_unique<FactorCurvesPanel>(m_document, m_tasks);
    m_panel->resize(1200, 400);
    m_document.setMaterial(glossyMaterial(0.3));
    QVERIFY(editor(FactorAxis::theta).nodes().empty());
    m_panel->show();
    QVERIFY(!m_panel->isSettled());
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds);
  }

  void init() {
    m_document.history().setIndex(0);
    m_document.history().clear();
    m_panel->termsView().setTerms(3);
    QVERIFY(!m_document.factors());
  }

  void cleanupTestCase() { m_panel.reset(); }

  /// Looking at the curves is no edit; they are those of the factorisation.
  void showsTheFirstTerm() {
    QCOMPARE(m_document.history().count(), 0);
    const auto expected = factorization::factorizePdv(*m_document.material()->table,
                                                      {.form = factorization::PdvForm::twoFactors, .terms = 1});
    for (const FactorAxis axis : {FactorAxis::theta, FactorAxis::deviation}) {
      QVERIFY(editor(axis).nodes() == nodesOf(expected.factors, axis));
      for (std::size_t c = 0; c < 3; ++c)
        QVERIFY(editor(axis).curves()[c] == curveOf(expected.factors.channels[c][0], axis));
    }
    QVERIFY(!m_panel->column(FactorAxis::phi).isVisible());
  }

  /// The values are those of the transform that the document's curves were made in, the terms' errors too.
  void theValuesAreThoseOfTheTransform() {
    QVERIFY(editor(FactorAxis::theta).axis().valueLabel.contains("ln(1 + ρ)"));
    editing::FactorEdit other;
    const factorization::PdvOptions options{
        .form = factorization::PdvForm::twoFactors, .transform = DataTransform::root, .terms = 3};
    const auto found = factorization::factorizePdv(*m_document.material()->table, options);
    other.original = std::make_shared<const PdvFactors>(found.factors);
    other.edited = std::make_shared<const PdvFactors>(factorization::widenF2(found.factors, 1.5));
    m_document.setFactors(other, "other transform");
    QVERIFY(editor(FactorAxis::theta).axis().valueLabel.contains("√ρ"));
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds);
    QString text;
    for (const QLabel* label : m_panel->termsView().findChildren<QLabel*>())
      if (label->text().contains("kB")) text = label->text();
    QVERIFY2(text.contains(QString::number(100 * found.residuals[3], 'f', 1) + " %"), qPrintable(text));
    m_document.history().undo();
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds);
    QVERIFY(editor(FactorAxis::theta).axis().valueLabel.contains("ln(1 + ρ)"));
  }

  /// The limits of F2 are those of the angle that is pointed at in F1: 1 -+ sin theta_R.
  void theLimitsFollowTheAngle() {
    widgets::CurveEditor& strength = editor(FactorAxis::theta);
    for (const double share : {0.2, 0.5, 0.9}) {
      const double left = strength.pointPosition(0).x();
      const double right = strength.pointPosition(strength.points().size() - 1).x();
      QTest::mouseMove(&strength, QPoint(int(left + share * (right - left)), strength.height() / 2));
      const double theta = strength.limits().at(0).place;
      QVERIFY(std::abs(theta - share * strength.nodes().back()) < 0.01);
      const auto& limits = editor(FactorAxis::deviation).limits();
      QVERIFY(std::abs(limits.at(0).place - (1 - std::sin(theta))) < 1e-12);
      QVERIFY(std::abs(limits.at(1).place - (1 + std::sin(theta))) < 1e-12);
    }
  }

  /// A drag that Escape takes back leaves no step.
  void escapeLeavesNoStep() {
    widgets::CurveEditor& strength = editor(FactorAxis::theta);
    strength.setFocus();
    const QPoint from = strength.pointPosition(0).toPoint();
    QTest::mousePress(&strength, Qt::LeftButton, {}, from);
    QTest::mouseMove(&strength, from - QPoint(0, 20));
    QVERIFY(m_document.factors().has_value());
    QTest::keyClick(&strength, Qt::Key_Escape);
    QTest::mouseRelease(&strength, Qt::LeftButton, {}, from);
    QCOMPARE(m_document.history().count(), 0);
    QVERIFY(!m_document.factors());
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
    QVERIFY(!m_document.factors());
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
      QVERIFY(largestDifference(edit().edited->channels[1][term].f1,
                                factorization::scaled(edit().original->channels[1][term].f1, 1.1)) < 1e-12);
    QCOMPARE(m_document.history().text(0), QStringLiteral("F1: stronger"));
    press(FactorAxis::theta, "Weaker");
    QVERIFY(std::abs(f1(0, last) / was(0, last) - 1) < 1e-12);
    QCOMPARE(m_document.history().count(), 2);
    press(FactorAxis::theta, "Tilt up");
    QVERIFY(std::abs(f1(2, 0) / was(2, 0) - 0.9) < 1e-12 && std::abs(f1(2, last) / was(2, last) - 1.1) < 1e-12);
    press(FactorAxis::theta, "Reset");
    QVERIFY(!m_document.factors());
    press(FactorAxis::theta, "Tilt down");
    QVERIFY(std::abs(f1(2, 0) / was(2, 0) - 1.1) < 1e-12 && std::abs(f1(2, last) / was(2, last) - 0.9) < 1e-12);
    press(FactorAxis::theta, "Reset");
    QVERIFY(!m_document.factors());

    // Half of its height is reached 10 % farther out, for every colour.
    press(FactorAxis::deviation, "Wider");
    const std::vector<double> nodes = edit().edited->deviationNodes;
    for (std::size_t c = 0; c < 3; ++c)
      QVERIFY(largestDifference(edit().edited->channels[c][0].f2,
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
    m_document.setFactors(spike, "spike");
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
    QVERIFY(m_panel->keepDetail().isChecked());
    m_panel->keepDetail().click();
    QCOMPARE(m_document.history().count(), 1);
    QVERIFY(!edit().keepDetail && !edit().isIdentity());
    m_document.history().undo();
    QVERIFY(m_panel->keepDetail().isChecked());
    m_document.history().redo();
    QVERIFY(!m_panel->keepDetail().isChecked());
    m_panel->keepDetail().click();
    QVERIFY(m_panel->keepDetail().isChecked());
    QVERIFY(!m_document.factors());  // what changes nothing is no edit
  }

  /// Fewer terms: the edit keeps what it changed in those that stay; terms that come are those of the measurement.
  void theNumberOfTermsIsAChoice() {
    QSlider* slider = m_panel->termsView().findChild<QSlider*>();
    slider->setValue(2);
    QCOMPARE(m_document.history().count(), 0);  // nothing is edited: nothing to undo
    press(FactorAxis::theta, "Stronger");
    QCOMPARE(edit().edited->terms(), 2);
    const PdvFactors stronger = *edit().edited;
    slider->setValue(5);
    QCOMPARE(m_document.history().count(), 2);
    QCOMPARE(edit().edited->terms(), 5);
    QCOMPARE(edit().original->terms(), 5);
    for (std::size_t c = 0; c < 3; ++c) {
      QVERIFY(edit().edited->channels[c][1] == stronger.channels[c][1]);
      QVERIFY(edit().edited->channels[c][4] == edit().original->channels[c][4]);
    }
    slider->setValue(2);
    QVERIFY(edit().edited->channels == stronger.channels);
    QCOMPARE(m_document.history().text(2), QStringLiteral("Use 2 terms"));
    m_document.history().undo();
    QCOMPARE(slider->value(), 5);
    slider->setValue(1);
    QCOMPARE(m_document.history().text(2), QStringLiteral("Use 1 term"));
  }

  /// What the numbers beside the slider say is what was measured of that many terms.
  void theCostOfTermsIsTold() {
    QString texts[2];
    for (const int terms : {1, 8}) {
      m_panel->termsView().setTerms(terms);
      for (const QLabel* label : m_panel->termsView().findChildren<QLabel*>())
        if (label->text().contains("kB")) texts[terms > 1] = label->text();
      const PdvFactors factors =
          factorization::factorizePdv(*m_document.material()->table,
                                      {.form = factorization::PdvForm::twoFactors, .terms = terms})
              .factors;
      QVERIFY(texts[terms > 1].contains(QString::number(double(io::pdvFileBytes(factors)) / 1000, 'f', 1) + " kB"));
    }
    QVERIFY(texts[0] != texts[1] && texts[0].contains("ns"));
  }

  /// Under each curve: what that many terms leave unexplained at its nodes.
  void whatIsUnexplainedIsShown() {
    for (const int terms : {1, 6}) {
      m_panel->termsView().findChild<QSlider*>()->setValue(terms);
      const auto found = factorization::factorizePdv(*m_document.material()->table,
                                                     {.form = factorization::PdvForm::twoFactors, .terms = terms});
      const auto along = factorization::residualsAlong(*m_document.material()->table, found.factors);
      for (const FactorAxis axis : {FactorAxis::theta, FactorAxis::deviation}) {
        const auto& strip = m_panel->column(axis).residuals();
        QVERIFY(strip.shares() == along[std::size_t(terms - 1)][std::size_t(axis)]);
        QVERIFY(strip.scale() >= *std::max_element(strip.shares().begin(), strip.shares().end()));
        QCOMPARE(strip.width(), editor(axis).width());
      }
    }
  }

  /// A thumbnail on a curve: that curve of the first term is the other material's, on the nodes of this one.
  void aDroppedMaterialLendsItsCurve() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("other.pdv");
    const auto other = glossyMaterial(0.6);
    io::writePdv(factorization::factorizePdv(*other->table, {.terms = 1}).factors, path.toStdString());
    for (const FactorAxis axis : {FactorAxis::theta, FactorAxis::deviation}) {
      init();
      drop(axis, path);
      QVERIFY(!m_panel->isSettled());
      QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds);
      QCOMPARE(m_document.history().count(), 1);
      QVERIFY(m_document.history().text(0).contains("other.pdv"));
      QCOMPARE(edit().edited->terms(), 1);
      const auto table = io::readMaterial(path.toStdString()).tabulated();
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
      QVERIFY(!m_document.factors());
    }
  }

  /// Nothing to take from a file that nobody reads: told, and nothing changed.
  void aDropThatCannotBeReadIsTold() {
    QSignalSpy failed(m_panel.get(), &FactorCurvesPanel::failed);
    drop(FactorAxis::deviation, "/nowhere/at-all.binary");
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, patienceMilliseconds);
    QVERIFY(failed[0][1].toString().contains("at-all.binary"));
    QCOMPARE(m_document.history().count(), 0);
  }

  void resetAllDropsTheEdit() {
    press(FactorAxis::deviation, "Wider");
    for (QPushButton* button : m_panel->findChildren<QPushButton*>())
      if (button->text().remove('&') == "Reset All") button->click();
    QVERIFY(!m_document.factors());
    QCOMPARE(m_document.history().count(), 2);
    QVERIFY(editor(FactorAxis::deviation).nodes().size() > 2);
  }

  /// Another form: other curves, found anew; the way back leads to the edit that was.
  void theFormWithThreeFactors() {
    auto* form = child<QComboBox>("Form of the factors");
    form->setCurrentIndex(1);
    Q_EMIT form->activated(1);
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds);
    QVERIFY(m_panel->column(FactorAxis::phi).isVisible());
    QVERIFY(editor(FactorAxis::phi).nodes().size() > 100);
    press(FactorAxis::phi, "Smooth");
    QVERIFY(edit().edited->form == factorization::PdvForm::threeFactors);
    m_document.history().setIndex(0);
    form->setCurrentIndex(0);
    Q_EMIT form->activated(0);
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds);
    QVERIFY(!m_panel->column(FactorAxis::phi).isVisible());
  }
};

QTEST_MAIN(FactorCurvesPanelTest)
#include "factor_curves_panel_test.moc"
