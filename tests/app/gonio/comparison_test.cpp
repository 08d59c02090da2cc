// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <cmath>

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/comparison/comparison_panel.h"
#include "app/gonio/document/edit_steps.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_context.h"
#include "widgets/preview/comparison_bar.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/preview_widget.h"

namespace comparison_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;
using widgets::ComparedSubject;
using widgets::CompareMode;

LoadedMaterialPtr lambertMaterial(const char* name, double albedo) {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = name;
  const HalfDifferenceGrid grid{24, 24, 24};
  loaded->base = bakeTable(*models::findModel("lambert").instantiate({{Rgb(albedo)}}), grid);
  loaded->material.brdf = loaded->base;
  return loaded;
}

fitting::FitResult lambertFit(double albedo) {
  fitting::FitResult fit;
  fit.model = &models::findModel("lambert");
  fit.parameters = {{Rgb(albedo)}};
  return fit;
}

struct Editor {
  Document document;
  BackgroundTasks tasks;
  widgets::PreviewWidget preview;
  widgets::ComparisonBar bar;
  ComparisonController comparison{document, tasks, preview, bar};
};

class ComparisonTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    const test::OffscreenContext context;
    if (!context.isValid()) QSKIP("needs an OpenGL 4.1 context");
  }

  /// A code stands where the measurement stood, with the edits on it; one of another material counts for nothing.
  void theEditedMaterialStandsOnItsCode() {
    Editor editor;
    editor.document.setMaterial(lambertMaterial("grey", 0.5));
    editor.document.adoptFit(lambertFit(0.5));
    auto code = std::make_shared<MaterialCode>();
    code->material = editor.document.material();
    code->coefficients = 64;
    code->table = lambertMaterial("decoded", 0.45)->table();
    editor.comparison.toggle();
    QCOMPARE(editor.comparison.sides()[0], ComparedSubject::fit);
    editor.comparison.setCode(code);  // while it is compared: what the user asked to see
    QVERIFY(editor.comparison.code() == code.get());
    QVERIFY(editor.comparison.subject(ComparedSubject::edited).base() == code->table);
    QVERIFY(editor.comparison.subject(ComparedSubject::measured).base() == editor.document.material()->table());
    QCOMPARE(editor.comparison.name(ComparedSubject::edited), QStringLiteral("Encoded"));
    QCOMPARE(editor.comparison.sides()[0], ComparedSubject::edited);
    QCOMPARE(editor.comparison.sides()[1], ComparedSubject::measured);
    setParameter(editor.document, 0, Rgb(0.2));
    QCOMPARE(editor.comparison.name(ComparedSubject::edited), QStringLiteral("Encoded, edited"));
    const auto edited = editor.comparison.subject(ComparedSubject::edited);
    QVERIFY(std::get<widgets::EditedMaterial>(edited.shown).edits == editor.document.edits());
    // The preview says so, with a button that asks for the measurement.
    const widgets::PreviewBanner& banner = *editor.preview.overlay()->banner();
    QVERIFY(!banner.isHidden() && banner.text().contains("grey") && banner.text().contains("64 coefficients"));
    connect(&editor.comparison, &ComparisonController::codeDismissed, this,
            [&editor] { editor.comparison.setCode(nullptr); });
    banner.button()->click();
    QVERIFY(banner.isHidden());
    QVERIFY(editor.comparison.subject(ComparedSubject::edited).base() == editor.document.material()->table());
    editor.comparison.setCode(code);
    editor.document.setMaterial(lambertMaterial("other", 0.3));
    QVERIFY(!editor.comparison.code());
    QVERIFY(editor.comparison.subject(ComparedSubject::edited).base() == editor.document.material()->table());
  }

  /// Without an edit the fit is judged, with one the edit; C goes back to the mode of the last time.
  void usualSidesAndToggle() {
    Editor editor;
    editor.document.setMaterial(lambertMaterial("grey", 0.5));
    QCOMPARE(editor.comparison.name(ComparedSubject::fit), QString());
    editor.document.adoptFit(lambertFit(0.5));
    editor.comparison.toggle();
    QCOMPARE(editor.comparison.comparison().mode, CompareMode::split);
    QCOMPARE(editor.comparison.sides(), (std::array{ComparedSubject::fit, ComparedSubject::measured}));
    QVERIFY(editor.preview.content().isComparing());
    editor.comparison.setComparison({.mode = CompareMode::twoUp});
    editor.comparison.toggle();
    QVERIFY(!editor.preview.content().isComparing());
    setParameter(editor.document, 0, Rgb(0.4));
    editor.comparison.toggle();
    QCOMPARE(editor.comparison.comparison().mode, CompareMode::twoUp);
    QCOMPARE(editor.comparison.sides(), (std::array{ComparedSubject::edited, ComparedSubject::measured}));
  }

  /// What stands in for the edited material while two are compared is what the user works on; sides of the user's own
  /// choice stay.
  void aStandInTakesItsSide() {
    Editor editor;
    editor.document.setMaterial(lambertMaterial("grey", 0.5));
    editor.document.adoptFit(lambertFit(0.5));
    editor.comparison.toggle();
    QCOMPARE(editor.comparison.sides()[0], ComparedSubject::fit);
    const widgets::PreviewSubject other = widgets::measuredSubject(lambertMaterial("other", 0.2)->table());
    editor.comparison.setStandIn(StandIn::blend, other, "blend");
    QCOMPARE(editor.comparison.sides(), (std::array{ComparedSubject::edited, ComparedSubject::measured}));
    QCOMPARE(editor.preview.overlay()->name(0)->text(), QString("Blend"));
    // A representation that the user looks at goes before a blend.
    editor.comparison.setStandIn(StandIn::representation, other, "GGX");
    QCOMPARE(editor.comparison.standIn(), StandIn::representation);
    QCOMPARE(editor.preview.overlay()->name(0)->text(), QString("GGX"));
    editor.comparison.setStandIn(StandIn::representation, {}, {});
    QCOMPARE(editor.comparison.standIn(), StandIn::blend);
    editor.comparison.setStandIn(StandIn::blend, {}, {});
    QCOMPARE(editor.comparison.sides(), (std::array{ComparedSubject::fit, ComparedSubject::measured}));
    editor.comparison.setSides(ComparedSubject::measured, ComparedSubject::fit);
    editor.comparison.setStandIn(StandIn::blend, other, "blend");
    QCOMPARE(editor.comparison.sides(), (std::array{ComparedSubject::measured, ComparedSubject::fit}));
  }

  /// The preview says that something else than the material is shown, and a press on the button asks to end it.
  void aBannerEndsAStandIn() {
    Editor editor;
    const widgets::PreviewBanner& banner = *editor.preview.overlay()->banner();
    editor.document.setMaterial(lambertMaterial("grey", 0.5));
    QVERIFY(banner.isHidden());
    const widgets::PreviewSubject other = widgets::measuredSubject(lambertMaterial("other", 0.2)->table());
    editor.comparison.setStandIn(StandIn::representation, other, "PDV, 3 terms");
    QVERIFY(!banner.isHidden());
    QVERIFY(banner.text().contains("PDV, 3 terms") && banner.text().contains("grey"));
    std::vector<StandIn> dismissed;
    connect(&editor.comparison, &ComparisonController::standInDismissed, this,
            [&](StandIn kind) { dismissed.push_back(kind); });
    banner.button()->click();
    QVERIFY(dismissed == std::vector{StandIn::representation});
    editor.comparison.setStandIn(StandIn::representation, {}, {});
    QVERIFY(banner.isHidden());
    editor.comparison.dismissStandIn();
    QCOMPARE(dismissed.size(), std::size_t(1));
  }

  /// Any two subjects stand against each other, until the banner's button or a change of the document.
  void aPairTakesBothSides() {
    Editor editor;
    editor.document.setMaterial(lambertMaterial("grey", 0.5));
    editor.document.adoptFit(lambertFit(0.5));
    const LoadedMaterialPtr light = lambertMaterial("light", 0.8), dark = lambertMaterial("dark", 0.1);
    const std::array<ComparisonController::Named, 2> pair{
        {{widgets::measuredSubject(light->base), "light fit"}, {widgets::measuredSubject(dark->base), "dark fit"}}};
    const auto sides = editor.comparison.sides();
    for (const bool compared : {false, true}) {
      if (compared) editor.comparison.toggle();
      editor.comparison.setPair(pair);
      QVERIFY(editor.preview.content().isComparing() && editor.comparison.isReplaced());
      const auto [first, second] = editor.comparison.sides();
      QVERIFY(editor.comparison.subject(first).base() == light->base);
      QVERIFY(editor.comparison.subject(second).base() == dark->base);
      QCOMPARE(editor.comparison.name(second), QString("dark fit"));
      QVERIFY(editor.comparison.subject(ComparedSubject::measured).base() == editor.document.material()->base);
      editor.comparison.dismissStandIn();
      QVERIFY(!editor.comparison.isReplaced() && editor.preview.content().isComparing() == compared);
      if (!compared) QVERIFY(editor.comparison.sides() == sides);
    }
    editor.comparison.setPair(pair);
    editing::EditList edits = editor.document.edits();
    std::get<editing::DifferentialEdit>(edits[0].content).edited.values[0] = Rgb(0.9);
    editor.document.replaceEdits(std::move(edits), "Lighter");
    QVERIFY(!editor.comparison.isReplaced());
    QVERIFY(editor.comparison.subject(ComparedSubject::edited).base() == editor.document.material()->base);
  }

  /// A material that nobody measured is not called so.
  void theSourceIsCalledWhatItIs() {
    Editor editor;
    editor.document.setMaterial(lambertMaterial("grey", 0.5));
    QCOMPARE(editor.comparison.name(ComparedSubject::measured), "Measured");
    for (const auto& [path, name] : {std::pair("library:sgd/chrome", "Model fit"),
                                     {"library:merl-copy/chrome", "Close copy"},
                                     {"library:rgl/paper_blue", "Measured"}}) {
      auto loaded = std::make_shared<LoadedMaterial>(*lambertMaterial("", 0.5));
      loaded->material.source = materials::readMaterial(path).source;
      editor.document.setMaterial(loaded);
      QCOMPARE(editor.comparison.name(ComparedSubject::measured), QString(name));
    }
  }

  void subjectsAreWhatTheyAreCalled() {
    Editor editor;
    editor.document.setMaterial(lambertMaterial("grey", 0.5));
    editor.document.adoptFit(lambertFit(0.3));
    setParameter(editor.document, 0, Rgb(0.4));
    const Direction up{0, 0, 1};
    const auto at = [&](ComparedSubject side) {
      return widgets::subjectBrdf(editor.comparison.subject(side))->evaluate(up, up).x * pi;
    };
    QVERIFY(std::abs(at(ComparedSubject::measured) - 0.5) < 1e-6);
    QVERIFY(std::abs(at(ComparedSubject::fit) - 0.3) < 1e-6);
    QVERIFY(std::abs(at(ComparedSubject::edited) - 0.6) < 1e-6);  // 0.5 + 0.4 - 0.3
    setComposition(editor.document, editing::Composition::logPlus);
    const double logPlus = (1 + 0.5 / pi) * (1 + 0.4 / pi) / (1 + 0.3 / pi) - 1;
    QVERIFY(std::abs(at(ComparedSubject::edited) - logPlus * pi) < 1e-6);
    editor.document.history().undo();
    QVERIFY(std::abs(at(ComparedSubject::edited) - 0.6) < 1e-6);
    QVERIFY(editor.comparison.subject(ComparedSubject::reference).isEmpty());
    QCOMPARE(editor.comparison.name(ComparedSubject::fit), "Fit: Lambert");
  }

  /// A reference is read in the background, takes the second side and opens a split.
  void anotherMaterialAsReference() {
    Editor editor;
    editor.document.setMaterial(lambertMaterial("grey", 0.5));
    editor.comparison.openReference("library:sgd/green-plastic");
    QTRY_VERIFY_WITH_TIMEOUT(editor.comparison.reference() != nullptr, patienceMilliseconds);
    QCOMPARE(editor.comparison.sides()[1], ComparedSubject::reference);
    QCOMPARE(editor.comparison.comparison().mode, CompareMode::split);
    QCOMPARE(editor.comparison.name(ComparedSubject::reference), "green-plastic");
    QSignalSpy failed(&editor.comparison, &ComparisonController::failed);
    editor.comparison.openReference("/nowhere/nothing.binary");
    QTRY_COMPARE(failed.count(), 1);
    QCOMPARE(editor.comparison.name(ComparedSubject::reference), "green-plastic");
  }

  /// The numbers are those of core/metrics, of the newest edit, and say so only then.
  void numbersFollowTheEdit() {
    Editor editor;
    ComparisonPanel panel(editor.comparison, editor.tasks);
    editor.document.setMaterial(lambertMaterial("grey", 0.5));
    editor.document.adoptFit(lambertFit(0.5));
    editor.comparison.setSides(ComparedSubject::edited, ComparedSubject::measured);
    QVERIFY(panel.isSettled() && !panel.isCurrent());  // out of sight: nothing is measured
    panel.show();
    QTRY_VERIFY_WITH_TIMEOUT(panel.isCurrent(), patienceMilliseconds);
    QVERIFY(std::isinf(panel.numbers()->renderedSnr));
    setParameter(editor.document, 0, Rgb(0.45));
    setParameter(editor.document, 0, Rgb(0.4));
    QVERIFY(!panel.isCurrent());
    QTRY_VERIFY_WITH_TIMEOUT(panel.isCurrent(), patienceMilliseconds);
    // 0.4 against 0.5 everywhere: |r|^2 / |r - t|^2 = 25.
    QVERIFY(std::abs(panel.numbers()->renderedSnr - 10 * std::log10(25)) < 1e-3);
    QVERIFY(std::abs(panel.numbers()->brdfSnr - 10 * std::log10(25)) < 1e-3);
    const auto& table = editor.document.material()->table();
    const auto expected = metrics::brdfErrors(*table, *editing::applyEdits(table, editor.document.edits()));
    QVERIFY(panel.numbers()->errors == expected);
  }

  /// Formulas and their units are typeset in the table: exponents are raised.
  void unitsAreTypeset() {
    Editor editor;
    ComparisonPanel panel(editor.comparison, editor.tasks);
    editor.document.setMaterial(lambertMaterial("grey", 0.5));
    editor.document.adoptFit(lambertFit(0.5));
    panel.show();
    const auto* table = panel.findChild<QTableWidget*>();
    QTRY_VERIFY(table->rowCount() > 0);
    int typeset = 0;
    for (const ComparisonLine& line : comparisonLines(nullptr)) {
      if (!line.unit.contains('^')) continue;
      const auto found = table->findItems(line.name, Qt::MatchExactly);
      QCOMPARE(found.size(), 1);
      const auto* unit = qobject_cast<QLabel*>(table->cellWidget(found.front()->row(), 2));
      QVERIFY(unit && unit->text().contains("<sup>") && !unit->text().contains('^'));
      ++typeset;
    }
    QVERIFY(typeset > 0);
  }

  /// A model as the reference is evaluated itself: a table of it differs by the rounding to single precision.
  void aFitAsTheReference() {
    const models::Model& lambert = models::findModel("lambert");
    // Without nodes on the horizon, where a BRDF is 0.
    const auto table = bakeTable(*lambert.instantiate({{Rgb(0.5)}}), {30, 30, 36});
    const auto reference = comparisonReference({widgets::StandaloneModel{&lambert, {{Rgb(0.5)}}, table->grid()}});
    const ComparisonNumbers numbers = compareSubjects(widgets::measuredSubject(table), *reference);
    QVERIFY(numbers.errors == metrics::brdfErrors(*reference->brdf, *table));
    QVERIFY(numbers.errors[std::size_t(metrics::BrdfMetric::rms)] < 1e-8);
    QVERIFY(numbers.brdfSnr > 100);
  }

  /// Text for a spreadsheet: what is compared, a title line, one line a number, decimal points.
  void csv() {
    ComparisonNumbers numbers;
    numbers.errors.assign(metrics::allBrdfMetrics().size(), 0.25);
    numbers.renderedSnr = 12.5;
    const QStringList lines = comparisonCsv(numbers, "Edited", "Measured").split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 2 + 3 + qsizetype(metrics::allBrdfMetrics().size()));
    QVERIFY(lines[0].startsWith("# Edited against Measured"));
    QCOMPARE(lines[1], "quantity,value,unit");
    QCOMPARE(lines[2], "Rendered SNR,12.5,dB");
  }
};

GONIO_TEST(ComparisonTest)
}  // namespace comparison_test

#include "comparison_test.moc"
