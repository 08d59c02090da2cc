// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/factorization/pdv_operations.h"
#include "core/formats/pdv.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/factor_curves_test_support.h"
#include "tests/support/test_program.h"
#include "tests/widgets/pointer.h"
#include "widgets/curves/residual_strip.h"

namespace factor_curves_panel_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;
using factorization::PdvFactors;

/// What the panel shows, and what can be chosen: every test begins with all steps undone.
class FactorCurvesPanelTest : public QObject, private OpenFactorCurves {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { openPanel(); }
  void init() { undoAll(); }
  void cleanupTestCase() { m_panel.reset(); }

  /// Looking at the curves is no edit; they are those of the factorisation.
  void showsTheFirstTerm() {
    QCOMPARE(m_document.history().count(), 0);
    const auto expected = factorization::factorizePdv(*m_document.material()->table(),
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
    const auto found = factorization::factorizePdv(*m_document.material()->table(), options);
    other.original = std::make_shared<const PdvFactors>(found.factors);
    other.edited = std::make_shared<const PdvFactors>(factorization::widenF2(found.factors, 1.5));
    replaceFactors(m_document, other, "other transform");
    QVERIFY(editor(FactorAxis::theta).axis().valueLabel.contains("√ρ"));
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds);
    QString text;
    for (const QLabel* label : termsView().findChildren<QLabel*>())
      if (label->text().contains("kB")) text = label->text();
    QVERIFY2(text.contains(QString::number(100 * found.residuals[3], 'f', 1) + " %"), qPrintable(text));
    m_document.history().undo();
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds);
    QVERIFY(editor(FactorAxis::theta).axis().valueLabel.contains("ln(1 + ρ)"));
  }

  /// The curves as they are now, edits too, are a file that reads back to the same.
  void theCurvesAreSaved() {
    m_panel->widen(1.3);
    const QTemporaryDir folder;
    const std::string path = folder.filePath("curves.pdv").toStdString();
    QSignalSpy saved(m_panel.get(), &FactorCurvesPanel::saveRequested);
    for (QPushButton* button : m_panel->findChildren<QPushButton*>())
      if (button->text().contains("Save")) button->click();
    QCOMPARE(saved.count(), 1);
    const auto save = saved[0][0].value<FileSave>();
    QCOMPARE(save.suffix, QString(".pdv"));
    save.write(path, {});
    const PdvFactors read = formats::readPdv(path);
    const PdvFactors& expected = *factorEdit(m_document)->edited;
    QCOMPARE(read.terms(), expected.terms());
    for (std::size_t i = 0; i < expected.channels[1][0].f2.size(); ++i)
      QVERIFY(std::abs(read.channels[1][0].f2[i] - expected.channels[1][0].f2[i]) <=
              1e-6 * std::abs(expected.channels[1][0].f2[i]));
  }

  /// The limits of F2 are those of the angle that is pointed at in F1: 1 -+ sin theta_R.
  void theLimitsFollowTheAngle() {
    widgets::CurveEditor& strength = editor(FactorAxis::theta);
    for (const double fraction : {0.2, 0.5, 0.9}) {
      const double left = strength.pointPosition(0).x();
      const double right = strength.pointPosition(strength.points().size() - 1).x();
      test::pointAt(strength, QPoint(int(left + fraction * (right - left)), strength.height() / 2));
      const double theta = strength.limits().at(0).place;
      QVERIFY(std::abs(theta - fraction * strength.nodes().back()) < 0.01);
      const auto& limits = editor(FactorAxis::deviation).limits();
      QVERIFY(std::abs(limits.at(0).place - (1 - std::sin(theta))) < 1e-12);
      QVERIFY(std::abs(limits.at(1).place - (1 + std::sin(theta))) < 1e-12);
    }
  }

  /// Fewer terms: the edit keeps what it changed in those that stay; terms that come are those of the measurement.
  void theNumberOfTermsIsAChoice() {
    QSlider* slider = termsView().findChild<QSlider*>();
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
      termsView().setTerms(terms);
      for (const QLabel* label : termsView().findChildren<QLabel*>())
        if (label->text().contains("kB")) texts[terms > 1] = label->text();
      const PdvFactors factors =
          factorization::factorizePdv(*m_document.material()->table(),
                                      {.form = factorization::PdvForm::twoFactors, .terms = terms})
              .factors;
      QVERIFY(
          texts[terms > 1].contains(QString::number(double(formats::pdvFileBytes(factors)) / 1000, 'f', 1) + " kB"));
    }
    QVERIFY(texts[0] != texts[1] && texts[0].contains("ns"));
  }

  /// Under each curve: what that many terms leave unexplained at its nodes.
  void whatIsUnexplainedIsShown() {
    QVERIFY(!termsView().isVisible() && !m_panel->column(FactorAxis::theta).residuals().isVisible());
    m_panel->details().setChecked(true);
    for (const int terms : {1, 6}) {
      termsView().findChild<QSlider*>()->setValue(terms);
      const auto found = factorization::factorizePdv(*m_document.material()->table(),
                                                     {.form = factorization::PdvForm::twoFactors, .terms = terms});
      const auto along = factorization::residualsAlong(*m_document.material()->table(), found.factors);
      for (const FactorAxis axis : {FactorAxis::theta, FactorAxis::deviation}) {
        const auto& strip = m_panel->column(axis).residuals();
        QVERIFY(strip.fractions() == along[std::size_t(terms - 1)][std::size_t(axis)]);
        QVERIFY(strip.scale() >= *std::max_element(strip.fractions().begin(), strip.fractions().end()));
        QTRY_COMPARE(strip.width(), editor(axis).width());
      }
    }
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

GONIO_TEST(FactorCurvesPanelTest)
}  // namespace factor_curves_panel_test

#include "factor_curves_panel_test.moc"
