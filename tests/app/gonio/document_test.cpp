// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/document.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <cstring>

#include "app/gonio/document/edit_steps.h"
#include "core/models/registry.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/support/test_program.h"

namespace document_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

LoadedMaterialPtr smallMaterial() {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = "grey";
  loaded->material.source.path = "/materials/grey.binary";
  loaded->material.source.sha256 = "00ff";
  const HalfDifferenceGrid grid{2, 2, 2};
  loaded->base =
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

class DocumentTest : public QObject {
  Q_OBJECT
 private:
  Document* m_document = nullptr;
  int index(const char* id) const { return int(*models::ggx().spec().find(id)); }

 private Q_SLOTS:
  /// Exports start beside the measured file, but not in a folder of Gonio's own data.
  void theFolderOfTheUsersFiles() {
    QStandardPaths::setTestModeEnabled(true);
    const QTemporaryDir users;
    const QString own = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/acquired";
    QVERIFY(QDir().mkpath(own));
    const std::pair<QString, QString> expected[] = {{users.path(), users.path()}, {own, QString()}};
    for (const auto& [folder, shown] : expected) {
      const QString path = folder + "/grey.binary";
      QVERIFY(QFile(path).open(QIODevice::WriteOnly));
      auto material = std::make_shared<LoadedMaterial>(*smallMaterial());
      material->material.source.path = path.toStdString();
      Document document;
      document.setMaterial(material);
      QCOMPARE(document.folder(), shown);
      QFile::remove(path);
    }
    Document bundled;
    bundled.setMaterial(smallMaterial());  // its file does not exist
    QVERIFY(bundled.folder().isEmpty());
    QStandardPaths::setTestModeEnabled(false);
  }

  void init() {
    m_document = new Document;
    m_document->setMaterial(smallMaterial());
    m_document->adoptFit(fitOf(models::ggx()));
  }
  void cleanup() { delete m_document; }

  /// What would take for ever to show is not changed, and says so.
  void editsBeyondTheLimitAreRefused() {
    const editing::Edit edit{editing::DifferentialEdit{&models::findModel("lambert"), {{Rgb(0.2)}}, {{Rgb(0.3)}}}};
    m_document->replaceEdits(editing::EditList(editing::maxEdits, edit), "Many");
    QCOMPARE(m_document->edits().size(), editing::maxEdits);
    QSignalSpy refused(m_document, &Document::refused);
    m_document->replaceEdits(editing::EditList(editing::maxEdits + 1, edit), "One more");
    QCOMPARE(refused.count(), 1);
    QVERIFY(refused[0][0].toString().contains("100 edits"));
    QCOMPARE(m_document->edits().size(), editing::maxEdits);
    QCOMPARE(m_document->history().count(), 1);
  }

  void openingAndTheFirstFitAreNoSteps() {
    QCOMPARE(m_document->history().count(), 0);
    QVERIFY(!m_document->isModified());
    QVERIFY(modelEdit(*m_document)->isIdentity());
    QCOMPARE(m_document->name(), QStringLiteral("grey"));
  }

  /// Every kind of step, then all undone, then all redone: the same bits each time.
  void undoAndRedoRestoreEveryBit() {
    std::vector<EditState> states{m_document->state()};
    const auto note = [&] { states.push_back(m_document->state()); };
    setParameter(*m_document, index("roughness"), Rgb(0.42)), note();
    setParameter(*m_document, index("specular"), Rgb(0.1, 0.3, 1.0 / 3)), note();
    resetParameter(*m_document, index("roughness")), note();
    resetParameters(*m_document), note();
    setComposition(*m_document, editing::Composition::additive), note();
    setControl(*m_document, editing::ArtistControl::roughness, Rgb(2)), note();
    setControl(*m_document, editing::ArtistControl::tint, Rgb(1, 0.5, 1.0 / 3)), note();
    resetControl(*m_document, editing::ArtistControl::roughness), note();
    m_document->chooseFit(fitOf(models::lambert())), note();
    setParameter(*m_document, 0, Rgb(0.7, 0.1, 0.2)), note();
    editing::DifferentialEdit edit = identityEdit(fitOf(models::ggx()));
    edit.edited = std::get<editing::DifferentialEdit>(states[2].edits[0].content).edited;
    pasteEdits(*m_document, {{edit}}), note();
    pasteEdits(*m_document, {{factorEdit(2)}, {edit, "mine", 0.5}}), note();
    addEdit(*m_document, {identityEdit(fitOf(models::lambert()))}), note();
    moveEdit(*m_document, 2, 0), note();
    duplicateEdit(*m_document, 1), note();
    renameEdit(*m_document, 0, "Base"), note();
    setEditEnabled(*m_document, 3, false), note();
    setEditStrength(*m_document, 2, 1.0 / 3), note();
    deleteEdit(*m_document, 1), note();
    QCOMPARE(m_document->history().count(), int(states.size()) - 1);
    for (int round = 0; round < 2; ++round) {
      for (int i = int(states.size()) - 1; i >= 0; --i) {
        m_document->history().setIndex(i);
        const EditState& expected = states[std::size_t(i)];
        QVERIFY(m_document->edits() == expected.edits);
        for (std::size_t k = 0; k < expected.edits.size(); ++k)
          if (const auto* one = std::get_if<editing::DifferentialEdit>(&expected.edits[k].content)) {
            const auto& now = std::get<editing::DifferentialEdit>(m_document->edits()[k].content);
            QVERIFY(sameBits(now.edited, one->edited) && sameBits(now.fitted, one->fitted));
          }
        QCOMPARE(m_document->state().selected, expected.selected);
        // As opened; everything reset; another model chosen, which changes nothing yet.
        QCOMPARE(m_document->isModified(), i != 0 && i != 4 && i != 9);
      }
    }
  }

  void oneDragIsOneStep() {
    setParameter(*m_document, index("roughness"), Rgb(0.3));
    m_document->beginInteraction();
    for (double value = 0.31; value <= 0.4201; value += 0.01) setParameter(*m_document, index("roughness"), Rgb(value));
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 2);
    QCOMPARE(m_document->history().text(1), QStringLiteral("Change Roughness from 0.3 to 0.42"));
    m_document->beginInteraction();
    setParameter(*m_document, index("roughness"), Rgb(0.5));
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 3);
    m_document->history().undo();
    m_document->history().undo();
    QVERIFY(modelEdit(*m_document)->edited.values[std::size_t(index("roughness"))] == Rgb(0.3));
  }

  void aDragThatReturnsLeavesNoStep() {
    const Rgb before = modelEdit(*m_document)->edited.values[std::size_t(index("roughness"))];
    m_document->beginInteraction();
    setParameter(*m_document, index("roughness"), Rgb(0.9));
    setParameter(*m_document, index("roughness"), before);
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 0);
    QVERIFY(modelEdit(*m_document)->isIdentity());
    QVERIFY(!m_document->isModified());
  }

  /// Of factor curves too: what one drag did is one step, what two did are two.
  void oneDragOfFactorsIsOneStep() {
    for (const double end : {1.5, 2.5}) {
      m_document->beginInteraction();
      for (double strength = end - 0.4; strength <= end + 1e-9; strength += 0.1)
        replaceFactors(*m_document, factorEdit(strength), "Change F1");
      m_document->endInteraction();
    }
    QCOMPARE(m_document->history().count(), 2);
    QVERIFY(std::abs(app::test_support::factorEdit(*m_document)->edited->channels[0][0].f1[0] - 2.5) < 1e-9);
    m_document->history().undo();
    QVERIFY(std::abs(app::test_support::factorEdit(*m_document)->edited->channels[0][0].f1[0] - 1.5) < 1e-9);
    m_document->history().undo();
    QVERIFY(!app::test_support::factorEdit(*m_document));
    replaceFactors(*m_document, factorEdit(2), "Stronger");
    replaceFactors(*m_document, factorEdit(3), "Stronger");
    QCOMPARE(m_document->history().count(), 2);  // two presses of a button
  }

  /// Without a step: the edit is as it was when the drag began.
  void aDragOfFactorsThatReturnsLeavesNoStep() {
    replaceFactors(*m_document, factorEdit(2), "Change F1");
    const editing::EditList before = m_document->edits();
    m_document->beginInteraction();
    replaceFactors(*m_document, factorEdit(3), "Change F1");
    replaceFactors(*m_document, factorEdit(2), "Change F1");  // equal numbers, another owner
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 1);
    QVERIFY(m_document->edits() == before);
  }

  void keysOutsideAnInteractionAreStepsOfTheirOwn() {
    setParameter(*m_document, index("f0"), Rgb(0.5));
    setParameter(*m_document, index("f0"), Rgb(0.6));
    QCOMPARE(m_document->history().count(), 2);
  }

  void whatChangesNothingIsNoStep() {
    resetParameters(*m_document);
    resetParameter(*m_document, 0);
    setParameter(*m_document, 0, modelEdit(*m_document)->edited.values[0]);
    pasteEdits(*m_document, m_document->edits());
    renameEdit(*m_document, 0, "");
    moveEdit(*m_document, 0, 0);
    QCOMPARE(m_document->history().count(), 0);
  }

  /// Edits that were undone to a material that can be opened again leave nothing to save, even if another state was
  /// saved.
  void aMaterialWithoutEditsIsNotModified() {
    setParameter(*m_document, index("f0"), Rgb(0.5));
    m_document->history().setClean();
    QVERIFY(!m_document->isModified());
    m_document->history().undo();
    QVERIFY(!m_document->history().isClean() && !m_document->isModified());
  }

  void savingIsWhatModifiedComparesWith() {
    QSignalSpy title(m_document, &Document::titleChanged);
    setParameter(*m_document, index("f0"), Rgb(0.5));
    QVERIFY(m_document->isModified());
    QVERIFY(!m_document->describedEdits().empty());
    m_document->markSaved("/tmp/mine.gonio");
    QVERIFY(!m_document->isModified());
    QCOMPARE(m_document->name(), QStringLiteral("mine"));
    // A name that the user chose needs no description.
    QVERIFY(m_document->describedEdits().empty());
    m_document->history().undo();
    QVERIFY(m_document->isModified());
    QVERIFY(title.count() >= 3);
  }

  /// Every step of factors and of a model, in turn, and all of it in the stored form.
  void factorsLiveBesideTheModel() {
    replaceFactors(*m_document, factorEdit(2), "Change F1");
    setParameter(*m_document, index("roughness"), Rgb(0.4));
    m_document->chooseFit(fitOf(models::lambert()));
    QVERIFY(*app::test_support::factorEdit(*m_document) == factorEdit(2));
    deleteEdit(*m_document, 0);
    QVERIFY(!app::test_support::factorEdit(*m_document));
    m_document->history().setIndex(2);
    const documents::EditDocument stored = m_document->toEditDocument();
    QCOMPARE(stored.edits.size(), std::size_t(2));
    Document other;
    other.setMaterial(smallMaterial(), stored, "/tmp/mine.gonio");
    QVERIFY(*app::test_support::factorEdit(other) == factorEdit(2));
    QVERIFY(sameBits(modelEdit(other)->edited, modelEdit(*m_document)->edited));
  }

  /// Any order, several of one kind: as they were stored.
  void anyListOfEditsOpens() {
    documents::EditDocument stored = m_document->toEditDocument();
    const editing::Edit fit = stored.edits[0];
    stored.edits = {{factorEdit(2)}, fit, {factorEdit(3), "third"}, fit};
    Document other;
    other.setMaterial(smallMaterial(), stored, "/tmp/four.gonio");
    QVERIFY(other.edits() == stored.edits && other.toEditDocument().edits == stored.edits);
    QVERIFY(!other.isModified());
    QCOMPARE(editName(other.edits(), 0), QStringLiteral("Factor curves"));
    QCOMPARE(editName(other.edits(), 2), QStringLiteral("third"));
    QCOMPARE(editName(other.edits(), 3), editName(other.edits(), 1) + " 2");
  }

  /// The sliders act on the selected edit of a model, else on the last; curves likewise.
  void theSelectedEditIsTheOneThatChanges() {
    addEdit(*m_document, {identityEdit(fitOf(models::lambert()))});
    replaceFactors(*m_document, factorEdit(2), "Change F1");
    QCOMPARE(m_document->edits().size(), std::size_t(3));  // factors, ggx, lambert
    m_document->select(2);
    QSignalSpy selection(m_document, &Document::selectionChanged);
    m_document->select(1);
    QCOMPARE(selection.count(), 1);
    QCOMPARE(modelEdit(*m_document)->model, &models::ggx());
    setParameter(*m_document, index("roughness"), Rgb(0.4));
    QVERIFY(!m_document->edits()[1].isIdentity() && m_document->edits()[2].isIdentity());
    m_document->select(0);
    QCOMPARE(modelEdit(*m_document)->model, &models::lambert());
    QVERIFY(*app::test_support::factorEdit(*m_document) == factorEdit(2));
    m_document->select(2);
    moveEdit(*m_document, 2, 0);
    QCOMPARE(m_document->state().selected, 0);
    QCOMPARE(m_document->history().text(m_document->history().index() - 1), QStringLiteral("Move Lambert up"));
    deleteEdit(*m_document, 0);
    m_document->history().undo();
    QCOMPARE(modelEdit(*m_document)->model, &models::lambert());
  }

  /// What was done before the automatic fit came can be undone, and the fit stays.
  void undoneStepsKeepTheAutomaticFit() {
    Document early;
    early.setMaterial(smallMaterial());
    replaceFactors(early, factorEdit(2), "Change F1");
    replaceFactors(early, factorEdit(3), "Change F1");
    early.history().undo();
    early.adoptFit(fitOf(models::ggx()));
    QCOMPARE(early.history().count(), 2);
    early.history().redo();
    QVERIFY(*app::test_support::factorEdit(early) == factorEdit(3) && modelEdit(early));
    early.history().setIndex(0);
    QVERIFY(!app::test_support::factorEdit(early) && modelEdit(early)->isIdentity());
    QVERIFY(!early.isModified());
  }

  /// A fit that comes in the midst of a drag is a step of its own, and so is what is dragged after it.
  void aFitDoesNotMergeWithADrag() {
    m_document->beginInteraction();
    setParameter(*m_document, index("roughness"), Rgb(0.4));
    fitting::FitResult fit = fitOf(models::ggx());
    fit.parameters.values[std::size_t(index("roughness"))] = Rgb(0.2);
    m_document->chooseFit(fit);
    setParameter(*m_document, index("roughness"), Rgb(0.5));
    setParameter(*m_document, index("roughness"), Rgb(0.6));
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 3);
    QCOMPARE(m_document->history().text(2), QStringLiteral("Change Roughness from 0.2 to 0.6"));
  }

  /// The facts of a fit belong to the values that it found: undoing a fit brings those of the one before.
  void eachEditKnowsItsFit() {
    QCOMPARE(m_document->fitOf(*modelEdit(*m_document))->errors[0], 0.125);
    fitting::FitResult better = fitOf(models::ggx());
    better.parameters.values[0] = Rgb(0.3);
    better.errors = {0.0625};
    m_document->chooseFit(better);
    QCOMPARE(m_document->fitOf(*modelEdit(*m_document))->errors[0], 0.0625);
    m_document->history().undo();
    QCOMPARE(m_document->fitOf(*modelEdit(*m_document))->errors[0], 0.125);
    QVERIFY(!m_document->knownFit(models::lambert()));
  }

  /// Curves are what the history's bound counts.
  void factorsCountInTheHistory() {
    m_document->history().setByteLimit(6 * editing::bytesOf(factorEdit(1).original));
    for (int i = 2; i < 12; ++i) replaceFactors(*m_document, factorEdit(i), "Change F1");
    while (m_document->history().canUndo()) m_document->history().undo();
    QVERIFY(app::test_support::factorEdit(*m_document));  // the first steps were forgotten
    QVERIFY(m_document->history().text(0).contains("too old"));
  }

  /// The strength of a drag is one step; the eye is one; what is deleted comes back with both.
  void anEditHasAStrengthAndAnEye() {
    setParameter(*m_document, index("f0"), Rgb(0.5));
    m_document->beginInteraction();
    for (const double strength : {0.9, 0.6, 0.25}) setEditStrength(*m_document, 0, strength);
    m_document->endInteraction();
    QCOMPARE(m_document->history().count(), 2);
    QVERIFY(m_document->history().text(1).endsWith("25 %"));
    setEditEnabled(*m_document, 0, false);
    QVERIFY(m_document->edits()[0].isIdentity());
    setEditEnabled(*m_document, 0, false);
    QCOMPARE(m_document->history().count(), 3);
    deleteEdit(*m_document, 0);
    QVERIFY(m_document->edits().empty() && !modelEdit(*m_document));
    m_document->history().undo();
    m_document->history().undo();
    QVERIFY(m_document->edits()[0].enabled);
    QCOMPARE(m_document->edits()[0].strength, 0.25);
    m_document->history().undo();
    QCOMPARE(m_document->edits()[0].strength, 1.0);
  }

  void storedFormHoldsSourceAndEdit() {
    setParameter(*m_document, index("f0"), Rgb(0.5));
    const documents::EditDocument stored = m_document->toEditDocument();
    QCOMPARE(stored.sourceSha256, std::string("00ff"));
    QCOMPARE(stored.edits.size(), std::size_t(1));
    Document other;
    other.setMaterial(smallMaterial(), stored, "/tmp/mine.gonio");
    QVERIFY(sameBits(modelEdit(other)->edited, modelEdit(*m_document)->edited));
    QVERIFY(!other.isModified());
  }
};

GONIO_TEST(DocumentTest)
}  // namespace document_test

#include "document_test.moc"
