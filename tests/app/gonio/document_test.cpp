// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/document.h"

#include <QSignalSpy>
#include <QTest>
#include <cstring>

#include "core/models/registry.h"
#include "tests/support/test_program.h"

using namespace gonio;
using namespace gonio::app;

namespace {

LoadedMaterialPtr smallMaterial() {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = "grey";
  loaded->material.source.path = "/materials/grey.binary";
  loaded->material.source.sha256 = "00ff";
  const HalfDifferenceGrid grid{2, 2, 2};
  loaded->table =
      std::make_shared<TabulatedBrdf>(grid, std::vector<TabulatedBrdf::Value>(grid.size(), {0.1f, 0.2f, 0.3f}),
                                      std::vector<std::uint8_t>(grid.size(), 1));
  return loaded;
}

fitting::FitResult fitOf(const models::Model& model) {
  fitting::FitResult fit;
  fit.model = &model;
  fit.parameters = models::defaultParameters(model.spec());
  for (std::size_t i = 0; i < fit.parameters.values.size(); ++i)
    if (model.spec().parameters[i].choices.empty()) fit.parameters.values[i] *= 0.9 + 0.01 * double(i);
  fit.errors = {0.125};
  return fit;
}

/// An edit of factors whose F1 is `strength`.
editing::FactorEdit factorEdit(double strength) {
  factorization::PdvFactors factors{.form = factorization::PdvForm::twoFactors};
  factors.thetaNodes = factors.deviationNodes = {0, 1};
  factors.phiNodes = {0};
  factors.highest = 10;
  for (auto& channel : factors.channels) channel = {{{1, 1}, {1, 0}, {1}}};
  editing::FactorEdit edit{.original = std::make_shared<const factorization::PdvFactors>(factors), .edited = {}};
  for (auto& channel : factors.channels) channel[0].f1 = {strength, strength};
  edit.edited = std::make_shared<const factorization::PdvFactors>(factors);
  return edit;
}

/// Equal bits, not equal numbers.
bool sameBits(const models::ParameterValues& a, const models::ParameterValues& b) {
  return a.values.size() == b.values.size() &&
         std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(Rgb)) == 0;
}

}  // namespace

class DocumentTest : public QObject {
  Q_OBJECT
 private:
  Document* m_document = nullptr;
  int index(const char* id) const { return int(*models::ggx().spec().find(id)); }

 private Q_SLOTS:
  void init() {
    m_document = new Document;
    m_document->setMaterial(smallMaterial());
    m_document->adoptFit(fitOf(models::ggx()));
  }
  void cleanup() { delete m_document; }

  void openingAndTheFirstFitAreNoSteps() {
    QCOMPARE(m_document->history().count(), 0);
    QVERIFY(!m_document->isModified());
    QVERIFY(m_document->edit()->isIdentity());
    QCOMPARE(m_document->name(), QStringLiteral("grey"));
  }

  /// Every kind of step, then all undone, then all redone: the same bits each time.
  void undoAndRedoRestoreEveryBit() {
    std::vector<EditState> states{m_document->state()};
    const auto note = [&] { states.push_back(m_document->state()); };
    m_document->setParameter(index("roughness"), Rgb(0.42)), note();
    m_document->setParameter(index("specular"), Rgb(0.1, 0.3, 1.0 / 3)), note();
    m_document->resetParameter(index("roughness")), note();
    m_document->resetAll(), note();
    m_document->chooseFit(fitOf(models::lambert())), note();
    m_document->setParameter(0, Rgb(0.7, 0.1, 0.2)), note();
    models::ParameterValues pasted = states[2].edit->edited;
    editing::DifferentialEdit edit = identityEdit(fitOf(models::ggx()));
    edit.edited = pasted;
    m_document->paste({}, edit, fitOf(models::ggx())), note();
    m_document->paste(factorEdit(2), edit), note();
    QCOMPARE(m_document->history().count(), int(states.size()) - 1);
    for (int round = 0; round < 2; ++round) {
      for (int i = int(states.size()) - 1; i >= 0; --i) {
        m_document->history().setIndex(i);
        const EditState& expected = states[std::size_t(i)];
        QCOMPARE(m_document->edit()->model, expected.edit->model);
        QVERIFY(sameBits(m_document->edit()->edited, expected.edit->edited));
        QVERIFY(sameBits(m_document->edit()->fitted, expected.edit->fitted));
        QVERIFY(m_document->factors() == expected.factors);
        QCOMPARE(m_document->isModified(), i != 0);
      }
    }
  }

  void oneDragIsOneStep() {
    m_document->setParameter(index("roughness"), Rgb(0.3));
    m_document->beginInteraction();
    for (double value = 0.31; value <= 0.4201; value += 0.01) m_document->setParameter(index("roughness"), Rgb(value));
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 2);
    QCOMPARE(m_document->history().text(1), QStringLiteral("Change roughness 0.3 to 0.42"));
    m_document->beginInteraction();
    m_document->setParameter(index("roughness"), Rgb(0.5));
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 3);
    m_document->history().undo();
    m_document->history().undo();
    QVERIFY(m_document->edit()->edited.values[std::size_t(index("roughness"))] == Rgb(0.3));
  }

  void aDragThatReturnsLeavesNoStep() {
    const Rgb before = m_document->edit()->edited.values[std::size_t(index("roughness"))];
    m_document->beginInteraction();
    m_document->setParameter(index("roughness"), Rgb(0.9));
    m_document->setParameter(index("roughness"), before);
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 0);
    QVERIFY(m_document->edit()->isIdentity());
    QVERIFY(!m_document->isModified());
  }

  /// Of factor curves too: what one drag did is one step, what two did are two.
  void oneDragOfFactorsIsOneStep() {
    for (const double end : {1.5, 2.5}) {
      m_document->beginInteraction();
      for (double strength = end - 0.4; strength <= end + 1e-9; strength += 0.1)
        m_document->setFactors(factorEdit(strength), "Change F1");
      m_document->endInteraction();
    }
    QCOMPARE(m_document->history().count(), 2);
    QVERIFY(std::abs(m_document->factors()->edited->channels[0][0].f1[0] - 2.5) < 1e-9);
    m_document->history().undo();
    QVERIFY(std::abs(m_document->factors()->edited->channels[0][0].f1[0] - 1.5) < 1e-9);
    m_document->history().undo();
    QVERIFY(!m_document->factors());
    m_document->setFactors(factorEdit(2), "Stronger");
    m_document->setFactors(factorEdit(3), "Stronger");
    QCOMPARE(m_document->history().count(), 2);  // two presses of a button
  }

  /// Without a step: the edit is as it was when the drag began.
  void aDragOfFactorsThatReturnsLeavesNoStep() {
    m_document->setFactors(factorEdit(2), "Change F1");
    const auto before = m_document->factors();
    m_document->beginInteraction();
    m_document->setFactors(factorEdit(3), "Change F1");
    m_document->setFactors(factorEdit(2), "Change F1");  // equal numbers, another owner
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 1);
    QVERIFY(m_document->factors() == before);
  }

  void keysOutsideAnInteractionAreStepsOfTheirOwn() {
    m_document->setParameter(index("f0"), Rgb(0.5));
    m_document->setParameter(index("f0"), Rgb(0.6));
    QCOMPARE(m_document->history().count(), 2);
  }

  void whatChangesNothingIsNoStep() {
    m_document->resetAll();
    m_document->resetParameter(0);
    m_document->setParameter(0, m_document->edit()->edited.values[0]);
    m_document->paste({}, m_document->edit());
    QCOMPARE(m_document->history().count(), 0);
  }

  void savingIsWhatModifiedComparesWith() {
    QSignalSpy title(m_document, &Document::titleChanged);
    m_document->setParameter(index("f0"), Rgb(0.5));
    QVERIFY(m_document->isModified());
    m_document->markSaved("/tmp/mine.gonio");
    QVERIFY(!m_document->isModified());
    QCOMPARE(m_document->name(), QStringLiteral("mine"));
    m_document->history().undo();
    QVERIFY(m_document->isModified());
    QVERIFY(title.count() >= 3);
  }

  /// Every step of factors and of a model, in turn, and all of it in the stored form.
  void factorsLiveBesideTheModel() {
    m_document->setFactors(factorEdit(2), "Change F1");
    m_document->setParameter(index("roughness"), Rgb(0.4));
    m_document->chooseFit(fitOf(models::lambert()));
    QVERIFY(m_document->factors() == factorEdit(2));
    m_document->setFactors({}, "Reset");
    m_document->history().setIndex(2);
    const editing::EditDocument stored = m_document->toEditDocument();
    QCOMPARE(stored.edits.size(), std::size_t(2));
    Document other;
    other.setMaterial(smallMaterial(), stored, "/tmp/mine.gonio");
    QVERIFY(other.factors() == factorEdit(2));
    QVERIFY(sameBits(other.edit()->edited, m_document->edit()->edited));
    // What the editor does not keep it does not open: two edits of factors.
    editing::EditDocument two = stored;
    two.edits = {factorEdit(2), factorEdit(3)};
    QVERIFY_THROWS_EXCEPTION(Error, other.setMaterial(smallMaterial(), two, "/tmp/two.gonio"));
  }

  /// Curves are what the history's bound counts.
  void factorsCountInTheHistory() {
    m_document->history().setByteLimit(3 * factorEdit(1).bytes());
    for (int i = 2; i < 12; ++i) m_document->setFactors(factorEdit(i), "Change F1");
    while (m_document->history().canUndo()) m_document->history().undo();
    QVERIFY(m_document->factors().has_value());  // the first steps were forgotten
    QVERIFY(m_document->history().text(0).contains("too old"));
  }

  /// The strength of a drag is one step; the eye is one; deleting goes back to the fit at full strength.
  void theModelsEditHasAStrengthAndAnEye() {
    m_document->setParameter(index("f0"), Rgb(0.5));
    m_document->beginInteraction();
    for (const double strength : {0.9, 0.6, 0.25}) m_document->setEditStrength(strength);
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 2);
    QVERIFY(m_document->history().text(1).endsWith("25 %"));
    m_document->setEditEnabled(false);
    QVERIFY(m_document->edit()->isIdentity());
    m_document->setEditEnabled(false);
    QCOMPARE(m_document->history().count(), 3);
    m_document->deleteEdit();
    QVERIFY(m_document->edit()->enabled && m_document->edit()->strength == 1);
    QVERIFY(m_document->edit()->edited == m_document->edit()->fitted);
    m_document->history().undo();
    m_document->history().undo();
    QVERIFY(m_document->edit()->enabled);
    QCOMPARE(m_document->edit()->strength, 0.25);
    m_document->history().undo();
    QCOMPARE(m_document->edit()->strength, 1.0);
  }

  void storedFormHoldsSourceAndEdit() {
    m_document->setParameter(index("f0"), Rgb(0.5));
    const editing::EditDocument stored = m_document->toEditDocument();
    QCOMPARE(stored.sourceSha256, std::string("00ff"));
    QCOMPARE(stored.edits.size(), std::size_t(1));
    Document other;
    other.setMaterial(smallMaterial(), stored, "/tmp/mine.gonio");
    QVERIFY(sameBits(other.edit()->edited, m_document->edit()->edited));
    QVERIFY(!other.isModified());
  }
};

GONIO_TEST(DocumentTest)
#include "document_test.moc"
