// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/formula_text.h"

#include <QTest>
#include <QTextDocument>

#include "core/metrics/brdf_metric.h"
#include "core/metrics/image_errors.h"
#include "core/models/model.h"
#include "tests/support/test_program.h"

namespace formula_text_test {
using namespace gonio;
using widgets::formulaHtml;

class FormulaTextTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void formulas_data() {
    QTest::addColumn<QString>("formula");
    QTest::addColumn<QString>("html");
    QTest::newRow("index") << "k_d / pi"
                           << "<i>k</i><sub><i>d</i></sub> / π";
    QTest::newRow("exponent") << "alpha^2"
                              << "α<sup>2</sup>";
    QTest::newRow("negative exponent") << "u^-C"
                                       << "<i>u</i><sup>−<i>C</i></sup>";
    QTest::newRow("expression") << "v^(-(c + 1) / 2)"
                                << "<i>v</i><sup>−(<i>c</i> + 1) / 2</sup>";
    QTest::newRow("both") << "h_x^2 / alpha_x^2"
                          << "<i>h</i><sub><i>x</i></sub><sup>2</sup> / α<sub><i>x</i></sub><sup>2</sup>";
    QTest::newRow("root") << "sqrt(1 - x), sqrt rho"
                          << "√(1 − <i>x</i>), √ρ";
    QTest::newRow("relation") << "k <= 1, m >= 2"
                              << "<i>k</i> ≤ 1, <i>m</i> ≥ 2";
    QTest::newRow("mean") << "<|d|^(2/3)>"
                          << "⟨|<i>d</i>|<sup>2/3</sup>⟩";
    QTest::newRow("word") << "sqrt mean(d^2), d: difference of rho"
                          << "√mean(<i>d</i><sup>2</sup>), <i>d</i>: difference of ρ";
    QTest::newRow("product") << "cos theta_d = h . i"
                             << "cos θ<sub><i>d</i></sub> = <i>h</i> · <i>i</i>";
    QTest::newRow("difference") << "Delta E of Dp"
                                << "Δ<i>E</i> of Δp";
    QTest::newRow("capitals") << "Gamma(p), Lambda(o), Omega, psi"
                              << "Γ(<i>p</i>), Λ(<i>o</i>), Ω, ψ";
    QTest::newRow("hyphen") << "half-vector: 8 - n"
                            << "half-vector: 8 − <i>n</i>";
    QTest::newRow("markup") << "a & b"
                            << "<i>a</i> &amp; <i>b</i>";
    QTest::newRow("nothing") << ""
                             << "";
    QTest::newRow("cut off") << "a^"
                             << "<i>a</i>";
    QTest::newRow("open") << "a^(b"
                          << "<i>a</i><sup>(<i>b</i></sup>";
  }
  void formulas() {
    QFETCH(QString, formula);
    QFETCH(QString, html);
    QCOMPARE(formulaHtml(formula.toStdString()), html);
  }

  /// No formula of a model or metric keeps a sign of plain text.
  void allSpecs() {
    const auto check = [](std::string_view formula) {
      QTextDocument page;
      page.setHtml(formulaHtml(formula));
      const QString text = page.toPlainText();
      for (const char* sign : {"_", "^", "<", ">", "alpha", "theta", "sqrt", "pi ", "Lambda", "Omega"})
        QVERIFY2(!text.contains(sign), qPrintable(text + " contains " + sign));
    };
    for (const models::Model* model : models::allModels()) {
      check(model->spec().formula);
      for (const models::ParameterSpec& parameter : model->spec().parameters) {
        check(parameter.symbol);
        check(parameter.formula);
      }
    }
    for (const metrics::MetricRecord& record : metrics::metricRecords()) check(record.formula);
    for (const metrics::ImageMetricRecord& record : metrics::imageMetricRecords()) check(record.formula);
  }
};

GONIO_TEST(FormulaTextTest)
}  // namespace formula_text_test

#include "formula_text_test.moc"
