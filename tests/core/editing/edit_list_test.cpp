// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit_list.h"

#include <QTest>

#include "core/models/model.h"
#include "tests/support/test_program.h"

namespace edit_list_test {
using namespace gonio;
using namespace gonio::editing;

Edit lambertEdit(double edited, const char* name) {
  return {DifferentialEdit{&models::findModel("lambert"), {{Rgb(0.5)}}, {{Rgb(edited)}}}, name};
}

Edit factorEdit(const char* name) {
  factorization::PdvFactors factors{.form = factorization::PdvForm::twoFactors};
  factors.thetaNodes = factors.deviationNodes = {0, 1};
  factors.phiNodes = {0};
  for (auto& channel : factors.channels) channel = {{{1, 1}, {1, 0}, {1}}};
  const auto curves = std::make_shared<const factorization::PdvFactors>(factors);
  return {FactorEdit{curves, curves}, name};
}

QString names(const EditList& edits) {
  QString text;
  for (const Edit& edit : edits) text += QString::fromStdString(edit.name);
  return text;
}

class EditListTest : public QObject {
  Q_OBJECT
 private:
  const EditList edits_{lambertEdit(0.6, "a"), factorEdit("b"), lambertEdit(0.7, "c"), lambertEdit(0.8, "d")};

 private Q_SLOTS:
  void newListsLeaveTheOldOneAlone() {
    QCOMPARE(names(moved(edits_, 0, 2)), QStringLiteral("bcad"));
    QCOMPARE(names(moved(edits_, 3, 0)), QStringLiteral("dabc"));
    QCOMPARE(names(moved(edits_, 1, 1)), QStringLiteral("abcd"));
    QCOMPARE(names(removed(edits_, 1)), QStringLiteral("acd"));
    QCOMPARE(names(inserted(edits_, 4, factorEdit("e"))), QStringLiteral("abcde"));
    QCOMPARE(names(withEdit(edits_, 1, [](Edit& edit) { edit.name = "B"; })), QStringLiteral("aBcd"));
    const EditList brighter = withParameter(edits_, 2, 0, Rgb(0.9));
    QVERIFY(std::get<DifferentialEdit>(brighter[2].content).edited.values[0] == Rgb(0.9));
    QVERIFY(brighter[0] == edits_[0] && brighter[3] == edits_[3]);
    QCOMPARE(names(edits_), QStringLiteral("abcd"));
  }

  void theOrderOfClampedEditsCounts() {
    const HalfDifferenceGrid grid{2, 2, 2};
    const auto base = std::make_shared<const TabulatedBrdf>(
        grid, std::vector<TabulatedBrdf::Value>(grid.size(), TabulatedBrdf::Value(0.05f)),
        std::vector<std::uint8_t>(grid.size(), 1));
    const EditList edits{lambertEdit(0, "darker"), lambertEdit(1, "brighter")};
    const auto value = [&](const EditList& list) { return applyEdits(base, list)->evaluate({0, 0, 1}, {0, 0, 1}).x; };
    QVERIFY(std::abs(value(edits) - 0.5 / pi) < 1e-6);
    QVERIFY(std::abs(value(moved(edits, 0, 1)) - 0.05) < 1e-6);
  }

  /// Curves that both lists hold are in memory once.
  void sharedCurvesDoNotCount() {
    const EditList one{edits_[1]}, copy{edits_[1]}, other{factorEdit("b")};
    const auto& curves = std::get<FactorEdit>(one[0].content).original;
    QCOMPARE(unsharedBytes(one, other) - unsharedBytes(one, copy), 2 * bytesOf(curves));
    QVERIFY(unsharedBytes(edits_, edits_) >= 4 * sizeof(Edit));
  }
};

GONIO_TEST(EditListTest)
}  // namespace edit_list_test

#include "edit_list_test.moc"
