// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/edit_steps.h"

#include <QMimeData>
#include <QTest>
#include <memory>

#include "core/models/registry.h"
#include "tests/support/test_program.h"

namespace edit_transfer_test {
using namespace gonio;
using namespace gonio::app;

class EditTransferTest : public QObject {
  Q_OBJECT
 private:
  static editing::DifferentialEdit edit() {
    editing::DifferentialEdit result;
    result.model = &models::ggx();
    result.fitted = result.edited = models::defaultParameters(models::ggx().spec());
    result.edited.values[index("roughness")] = result.fitted.values[index("roughness")] * 2.0;
    result.edited.values[index("specular")] = Rgb(0.5, 0.25, 1.0 / 3);
    result.edited.values[index("masking")] = Rgb(1);
    return result;
  }
  static factorization::PdvFactors constantFactors(double strength) {
    factorization::PdvFactors factors{.form = factorization::PdvForm::twoFactors};
    factors.thetaNodes = factors.deviationNodes = {0, 1};
    factors.phiNodes = {0};
    factors.highest = 10;
    for (auto& channel : factors.channels) channel = {{{strength, strength}, {1, 1}, {1}}};
    return factors;
  }
  static std::size_t index(const char* id) { return *models::ggx().spec().find(id); }

 private Q_SLOTS:
  void ontoTheSameFitItIsTheSameEdit() { QVERIFY(transferredEdit(edit(), edit().fitted) == edit().edited); }

  void ratiosForLogarithmicDifferencesForOthers() {
    models::ParameterValues other = edit().fitted;
    other.values[index("roughness")] = Rgb(0.1);
    other.values[index("specular")] = Rgb(2);
    other.values[index("f0")] = Rgb(0.9);
    const models::ParameterValues result = transferredEdit(edit(), other);
    QVERIFY(qAbs(result.values[index("roughness")].x - 0.2) < 1e-12);
    QVERIFY(qAbs(result.values[index("specular")].x - 1.5) < 1e-12);
    QVERIFY(result.values[index("masking")] == Rgb(1));
    QVERIFY(result.values[index("f0")] == Rgb(0.9));  // the edit left it alone
  }

  void staysInsideTheHardRange() {
    models::ParameterValues other = edit().fitted;
    other.values[index("roughness")] = Rgb(0.9);
    QVERIFY(transferredEdit(edit(), other).values[index("roughness")] == Rgb(1));
  }

  void theClipboardKeepsEveryBit() {
    documents::EditDocument document;
    document.sourcePath = "library:sgd/chrome";
    document.sourceSha256 = std::string(64, 'a');
    document.edits = {{edit()}};
    const std::unique_ptr<QMimeData> data(toClipboard(document));
    const auto all = editsFromClipboard(data.get());
    QCOMPARE(all.size(), std::size_t(1));
    const auto* back = std::get_if<editing::DifferentialEdit>(&all[0].content);
    QVERIFY(back && back->edited == edit().edited && back->fitted == edit().fitted && back->model == edit().model);
    QMimeData text;
    text.setText("hello");
    QVERIFY(editsFromClipboard(&text).empty());
    QVERIFY(editsFromClipboard(nullptr).empty());
  }

  /// Of several edits those that change something; the only one even where it does not.
  void whatChangesNothingIsNotPasted() {
    editing::FactorEdit factors;
    factors.original = std::make_shared<const factorization::PdvFactors>(constantFactors(1));
    factors.edited = std::make_shared<const factorization::PdvFactors>(constantFactors(2));
    editing::DifferentialEdit identity = edit();
    identity.edited = identity.fitted;
    documents::EditDocument document;
    document.sourcePath = "library:sgd/chrome";
    document.sourceSha256 = std::string(64, 'a');
    document.edits = {{factors}, {identity}};
    const auto pasted = [&] { return editsFromClipboard(std::unique_ptr<QMimeData>(toClipboard(document)).get()); };
    QCOMPARE(pasted().size(), std::size_t(1));
    QVERIFY(std::get<editing::FactorEdit>(pasted()[0].content) == factors);
    document.edits = {{identity}};
    QCOMPARE(pasted().size(), std::size_t(1));
    document.edits = {{factors}, {edit()}};
    QCOMPARE(pasted().size(), std::size_t(2));
  }
};

GONIO_TEST(EditTransferTest)
}  // namespace edit_transfer_test

#include "edit_transfer_test.moc"
