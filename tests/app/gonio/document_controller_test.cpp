// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/document_controller.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/gonio/document/edit_steps.h"
#include "app/gonio/document/file_exports.h"
#include "core/factorization/pdv_operations.h"
#include "core/formats/formats.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"

namespace document_controller_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

/// A table: exports hold what the edits make of its cells.
const QString material = QStringLiteral("library:merl-copy/green-plastic");

struct Editor {
  Document document;
  BackgroundTasks tasks;
  DocumentController controller{document, tasks};
  FileExports exports{document, tasks};

  /// Files are written although they lose something.
  Editor() {
    QObject::connect(&exports, &FileExports::lossesFound, &document,
                     [](const QString&, const QString&, const std::function<void()>& write) { write(); });
  }
};

class DocumentControllerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The main job end to end: open, automatic fit, edit, save, open again, export, open the export.
  void openFitEditSaveOpenExport() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("mine.gonio"), exported = folder.filePath("mine.binary");
    Editor editor;
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);
    QVERIFY(!editor.document.isModified());
    QCOMPARE(editor.document.history().count(), 0);

    const int roughness = int(*modelEdit(editor.document)->model->spec().find("roughness"));
    setParameter(editor.document, roughness, Rgb(0.3));
    QVERIFY(editor.controller.save(path, {{"exposure", 1.5}}));
    QVERIFY(!editor.document.isModified());

    Editor again;
    QSignalSpy warned(&again.controller, &DocumentController::warned);
    double exposure = 0;
    connect(&again.controller, &DocumentController::viewRestored, this,
            [&](const nlohmann::json& view) { exposure = view.at("exposure").get<double>(); });
    again.controller.open(path);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(again.document), patienceMilliseconds);
    QVERIFY(modelEdit(again.document)->edited == modelEdit(editor.document)->edited);
    QVERIFY(modelEdit(again.document)->fitted == modelEdit(editor.document)->fitted);
    QCOMPARE(exposure, 1.5);
    QCOMPARE(warned.count(), 0);
    QVERIFY(!again.document.isModified());
    QCOMPARE(again.document.name(), QStringLiteral("mine"));

    QSignalSpy done(&again.exports, &FileExports::exported);
    again.exports.writeMaterial(exported, formats::merlFormat);
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, patienceMilliseconds);
    const LoadedMaterialPtr reopened = loadMaterial(exported.toStdString());
    const auto baked = editing::bakeEdits(editor.document.material()->table(), editor.document.edits());
    QCOMPARE(reopened->table()->validCount(), baked->validCount());
    double worst = 0;
    for (std::size_t i = 0; i < baked->values().size(); i += 97)
      for (int c = 0; c < 3; ++c) {
        const double a = baked->values()[i][c], b = reopened->table()->values()[i][c];
        worst = std::max(worst, std::abs(a - b) / std::max(a, 1e-6));
      }
    QVERIFY(worst < 1e-6);
  }

  /// With factor curves: every field comes back from the file, and the export holds what the curves make of it.
  void factorsAreSavedOpenedAndBaked() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("pulled.gonio"), exported = folder.filePath("pulled.binary");
    Editor editor;
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(editor.document.material(), patienceMilliseconds);
    const auto factors = factorization::factorizePdv(*editor.document.material()->table(), {.terms = 2}).factors;
    editing::FactorEdit edit;
    edit.original = std::make_shared<const factorization::PdvFactors>(factors);
    edit.edited = std::make_shared<const factorization::PdvFactors>(factorization::widenF2(factors, 1.7));
    edit.preserveDetail = false;
    replaceFactors(editor.document, edit, "Wider");
    setEditStrength(editor.document, 0, 0.75);
    QVERIFY(editor.document.isModified());
    QVERIFY(editor.controller.save(path, nlohmann::json::object()));
    QVERIFY(!editor.document.isModified());

    Editor again;
    again.controller.open(path);
    QTRY_VERIFY_WITH_TIMEOUT(factorEdit(again.document), patienceMilliseconds);
    const editing::FactorEdit& back = *factorEdit(again.document);
    QVERIFY(*back.original == *edit.original && *back.edited == *edit.edited);
    QVERIFY(!back.preserveDetail && again.document.edits()[0].enabled);
    QCOMPARE(again.document.edits()[0].strength, 0.75);

    QSignalSpy done(&again.exports, &FileExports::exported);
    again.exports.writeMaterial(exported, formats::merlFormat);
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, patienceMilliseconds);
    const auto reopened = loadMaterial(exported.toStdString())->table();
    const TabulatedBrdf& measured = *editor.document.material()->table();
    const auto pdv = factorization::makePdvBrdf(*edit.edited);
    double worst = 0, maxChange = 0;
    for (std::size_t cell = 0; cell < measured.values().size(); cell += 4999) {
      if (!measured.valid()[cell]) continue;
      const DirectionPair pair = measured.grid().directions(cell);
      const Rgb before(measured.values()[cell]), model = pdv->evaluate(pair.wi, pair.wo);
      const Rgb expected = glm::max(Rgb(0), 0.25 * before + 0.75 * model), found(reopened->values()[cell]);
      worst = std::max(worst, glm::length(found - expected) / std::max(1e-6, glm::length(expected)));
      maxChange = std::max(maxChange, glm::length(found - before) / std::max(1e-6, glm::length(before)));
    }
    QVERIFY(worst < 1e-5);
    QVERIFY(maxChange > 0.1);
  }

  /// Onto the material it was made on, an edit of curves is the same edit; onto another, that one's curves change.
  void factorsArePasted() {
    Editor editor;
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(editor.document.material(), patienceMilliseconds);
    const auto factors = factorization::factorizePdv(*editor.document.material()->table(), {.terms = 2}).factors;
    editing::FactorEdit edit;
    edit.original = std::make_shared<const factorization::PdvFactors>(factors);
    edit.edited = std::make_shared<const factorization::PdvFactors>(factorization::widenF2(factors, 1.7));
    editor.controller.paste({{edit, "", 0.5}});
    QTRY_VERIFY_WITH_TIMEOUT(factorEdit(editor.document), patienceMilliseconds);
    QVERIFY(*factorEdit(editor.document) == edit);
    QCOMPARE(editor.document.history().count(), 1);

    editor.controller.open("library:sgd/chrome");
    QTRY_VERIFY_WITH_TIMEOUT(editor.document.name() == "chrome", patienceMilliseconds);
    QVERIFY(!factorEdit(editor.document));
    editor.controller.paste({{edit, "", 0.5}});
    QTRY_VERIFY_WITH_TIMEOUT(factorEdit(editor.document), patienceMilliseconds);
    const editing::FactorEdit& carried = *factorEdit(editor.document);
    QVERIFY(carried.original->deviationNodes != edit.original->deviationNodes);
    QCOMPARE(editor.document.edits()[0].strength, 0.5);
    // Wider at every place, as the edit is.
    const auto &before = carried.original->channels[1][0].f2, &after = carried.edited->channels[1][0].f2;
    for (std::size_t i = 0; i < before.size(); ++i) QVERIFY(after[i] >= before[i] - 0.02);
    QVERIFY(after[before.size() / 4] > before[before.size() / 4] + 0.05);
  }

  /// Curves and sliders that were copied together come as one step, with their strengths and eyes; so does a model that
  /// has to be fitted first.
  void whatWasCopiedTogetherIsOneStep() {
    Editor editor;
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);
    const auto factors = factorization::factorizePdv(*editor.document.material()->table(), {.terms = 1}).factors;
    editing::FactorEdit curves;
    curves.original = std::make_shared<const factorization::PdvFactors>(factors);
    curves.edited = std::make_shared<const factorization::PdvFactors>(factorization::widenF2(factors, 1.7));
    for (const char* id : {"ggx", "lambert"}) {
      const models::Model& model = models::findModel(id);
      editing::DifferentialEdit sliders{.model = &model, .fitted = {}, .edited = {}};
      sliders.fitted = sliders.edited = models::defaultParameters(model.spec());
      sliders.edited.values[0] = 0.5 * sliders.fitted.values[0];
      const EditState before = editor.document.state();
      const int steps = editor.document.history().index();
      editor.controller.paste({{curves}, {sliders, "mine", 0.5, false}});
      QTRY_VERIFY_WITH_TIMEOUT(editor.tasks.isIdle() && editor.document.history().index() > steps,
                               patienceMilliseconds);
      QCOMPARE(editor.document.history().index(), steps + 1);
      QVERIFY(*factorEdit(editor.document) == curves);
      const editing::DifferentialEdit& pasted = *modelEdit(editor.document);
      QVERIFY(pasted.model == &model && pasted.edited != pasted.fitted);
      QCOMPARE(editor.document.edits().size(), std::size_t(2));
      const editing::Edit& last = editor.document.edits()[1];
      QVERIFY(last.strength == 0.5 && !last.enabled && last.name == "mine");
      editor.document.history().undo();
      QVERIFY(editor.document.edits() == before.edits);
    }
  }

  /// Another edit of the model in use starts from the same fit; with none left, one of the default model is made.
  void modelEditsAreAdded() {
    Editor editor;
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);
    const editing::DifferentialEdit first = *modelEdit(editor.document);
    setParameter(editor.document, 0, Rgb(0.4));
    editor.controller.addModelEdit();
    QCOMPARE(editor.document.edits().size(), std::size_t(2));
    QVERIFY(*modelEdit(editor.document) == first && editor.document.state().selected == 1);
    QVERIFY(editor.document.fitOf(*modelEdit(editor.document)));
    // Pasted: edits of the same kind make way for both.
    const editing::EditList both = editor.document.edits();
    editor.controller.paste({both[0]});
    QCOMPARE(editor.document.edits().size(), std::size_t(1));
    editor.controller.paste(both);
    QVERIFY(editor.document.edits() == both);
    deleteEdit(editor.document, 1);
    deleteEdit(editor.document, 0);
    editor.controller.addModelEdit();  // the fit is known
    QVERIFY(*modelEdit(editor.document) == first);
    QVERIFY(editor.document.history().text(editor.document.history().index() - 1).startsWith("Fit"));
  }

  /// Without a picture there is no view to keep: the document opens all the same.
  void aDocumentWithoutAViewOpens() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("blind.gonio");
    Editor editor, again;
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);
    QVERIFY(editor.controller.save(path, {}));
    QSignalSpy failed(&again.controller, &DocumentController::failed);
    again.controller.open(path);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(again.document) || failed.count() > 0, patienceMilliseconds);
    QCOMPARE(failed.count(), 0);
  }

  /// Edits of another file are not applied before the user says so; however the answer is, the document on the disk
  /// stays as it is.
  void aChangedSourceWaitsForTheUser() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("old.gonio");
    const models::Model& model = models::findModel("lambert");
    documents::EditDocument stored;
    stored.sourcePath = material.toStdString();
    stored.sourceSha256 = std::string(64, '0');
    stored.edits = {{editing::DifferentialEdit{&model, {{Rgb(0.2)}}, {{Rgb(0.4)}}}}};
    documents::writeDocument(stored, path.toStdString());
    for (const ChangedSource choice : {ChangedSource::withEdits, ChangedSource::withoutEdits, ChangedSource::cancel}) {
      Editor editor;
      QSignalSpy changed(&editor.controller, &DocumentController::sourceChanged);
      editor.controller.open(path);
      QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 1, patienceMilliseconds);
      QVERIFY(changed[0][0].toString().contains("changed"));
      QVERIFY(!editor.document.material());
      editor.controller.openChangedSource(choice);
      QCOMPARE(editor.document.material() != nullptr, choice != ChangedSource::cancel);
      QCOMPARE(editor.document.isModified(), choice == ChangedSource::withEdits);
      QCOMPARE(editor.document.path(), choice == ChangedSource::withEdits ? path : QString());
      QCOMPARE(modelEdit(editor.document) != nullptr, choice == ChangedSource::withEdits);
    }
    QCOMPARE(documents::readDocument(path.toStdString()).sourceSha256, stored.sourceSha256);
  }

  /// The user edits on while a file opens: what was changed meanwhile is not lost without a question.
  void editsMadeWhileAFileOpensAreAskedAbout() {
    Editor editor;
    QSignalSpy asked(&editor.controller, &DocumentController::unsavedChanges);
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);
    const int roughness = int(*modelEdit(editor.document)->model->spec().find("roughness"));
    for (const bool replace : {false, true}) {
      asked.clear();
      editor.controller.open("library:sgd/chrome");
      setParameter(editor.document, roughness, Rgb(replace ? 0.4 : 0.3));
      QTRY_VERIFY_WITH_TIMEOUT(editor.controller.opening().isEmpty(), patienceMilliseconds);
      QCOMPARE(asked.count(), 1);
      QCOMPARE(asked[0][0].toString(), QString("chrome"));
      QCOMPARE(editor.document.name(), QString("green-plastic"));
      QVERIFY(editor.document.isModified());
      editor.controller.replaceUnsaved(replace);
      QCOMPARE(editor.document.name(), QString(replace ? "chrome" : "green-plastic"));
      QCOMPARE(editor.document.isModified(), !replace);
    }
    editor.controller.replaceUnsaved(true);  // nothing waits any more
    QCOMPARE(editor.document.name(), QString("chrome"));
  }

  /// The caller of open() has asked about what was unsaved then, and asks once.
  void changesThatWereKnownAreNotAskedAboutAgain() {
    Editor editor;
    QSignalSpy asked(&editor.controller, &DocumentController::unsavedChanges);
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);
    setParameter(editor.document, int(*modelEdit(editor.document)->model->spec().find("roughness")), Rgb(0.3));
    editor.controller.open("library:sgd/chrome");
    QTRY_COMPARE_WITH_TIMEOUT(editor.document.name(), QString("chrome"), patienceMilliseconds);
    QCOMPARE(asked.count(), 0);
  }

  /// The question about a changed source comes later still.
  void editsMadeBeforeAnAnswerAreAskedAbout() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("old.gonio");
    documents::EditDocument stored;
    stored.sourcePath = "library:sgd/chrome";
    stored.sourceSha256 = std::string(64, '0');
    documents::writeDocument(stored, path.toStdString());
    for (const ChangedSource choice : {ChangedSource::withEdits, ChangedSource::withoutEdits}) {
      Editor editor;
      QSignalSpy asked(&editor.controller, &DocumentController::unsavedChanges);
      QSignalSpy changed(&editor.controller, &DocumentController::sourceChanged);
      editor.controller.open(material);
      QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);
      editor.controller.open(path);
      QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 1, patienceMilliseconds);
      setParameter(editor.document, int(*modelEdit(editor.document)->model->spec().find("roughness")), Rgb(0.3));
      editor.controller.openChangedSource(choice);
      QCOMPARE(asked.count(), 1);
      QCOMPARE(editor.document.name(), QString("green-plastic"));
      editor.controller.replaceUnsaved(true);
      QCOMPARE(editor.document.name(), QString(choice == ChangedSource::withEdits ? "old" : "chrome"));
      QCOMPARE(editor.document.isModified(), choice == ChangedSource::withEdits);
    }
  }

  /// A blend or a reconstruction has no file of the edits before it: saving it would not save them.
  void aMaterialInMemoryReplacesUnsavedEditsAfterAQuestion() {
    Editor editor;
    QSignalSpy asked(&editor.controller, &DocumentController::unsavedChanges);
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);
    const LoadedMaterialPtr chrome = loadMaterial("library:sgd/chrome");
    editor.controller.openInMemory(chrome, "Open chrome");
    QCOMPARE(asked.count(), 0);
    QCOMPARE(editor.document.material(), chrome);
    editor.document.history().undo();
    setParameter(editor.document, int(*modelEdit(editor.document)->model->spec().find("roughness")), Rgb(0.3));
    for (const bool replace : {false, true}) {
      editor.controller.openInMemory(chrome, "Open chrome");
      QCOMPARE(editor.document.name(), QString("green-plastic"));
      editor.controller.replaceUnsaved(replace);
    }
    QCOMPARE(asked.count(), 2);
    QCOMPARE(editor.document.material(), chrome);
  }

  /// Two editors with one document: the second is asked before it replaces what the first has saved.
  void aDocumentSavedByAnotherEditorIsNoticed() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("shared.gonio");
    Editor first, second;
    first.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(first.document), patienceMilliseconds);
    QVERIFY(!first.controller.hasChangedOnDisk(path));
    QVERIFY(first.controller.save(path, {}));
    second.controller.open(path);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(second.document), patienceMilliseconds);
    QVERIFY(!first.controller.hasChangedOnDisk(path) && !second.controller.hasChangedOnDisk(path));

    setParameter(first.document, int(*modelEdit(first.document)->model->spec().find("roughness")), Rgb(0.3));
    QVERIFY(first.controller.save(path, {}));
    QVERIFY(!first.controller.hasChangedOnDisk(path));
    QVERIFY(second.controller.hasChangedOnDisk(path));
    QVERIFY(second.controller.save(path, {}));
    QVERIFY(first.controller.hasChangedOnDisk(path) && !second.controller.hasChangedOnDisk(path));
    // Nothing is lost by saving a document whose file was removed.
    QVERIFY(QFile::remove(path));
    QVERIFY(!first.controller.hasChangedOnDisk(path));
  }

  void aFileThatNobodyReadsIsToldAndChangesNothing() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("poem.binary");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("not a material");
    file.close();
    Editor editor;
    QSignalSpy failed(&editor.controller, &DocumentController::failed);
    editor.controller.open(path);
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, patienceMilliseconds);
    QVERIFY(failed[0][1].toString().contains("poem.binary"));
    QVERIFY(!editor.document.material());
  }

  /// A newer load wins; a fit that is stopped offers its best so far, and applying that is one step.
  void aFitKeepsTheChosenConventions() {
    Editor editor;
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);
    const std::size_t masking = *modelEdit(editor.document)->model->spec().find("masking");
    const Rgb heightCorrelated(1);
    QVERIFY(modelEdit(editor.document)->fitted.values[masking] != heightCorrelated);
    setParameter(editor.document, int(masking), heightCorrelated);
    editor.controller.fit();
    QTRY_VERIFY_WITH_TIMEOUT(editor.tasks.isIdle(), patienceMilliseconds);
    QCOMPARE(modelEdit(editor.document)->fitted.values[masking], heightCorrelated);
    QVERIFY(modelEdit(editor.document)->isIdentity());
  }

  /// Several lobes are proposed where they are much closer than the automatic fit, and chosen by the user alone.
  void severalLobesAreProposed() {
    Editor editor;
    QSignalSpy offered(&editor.controller, &DocumentController::proposalOffered);
    editor.controller.open("library:merl-copy/two-layer-silver");
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);
    QVERIFY(modelEdit(editor.document)->model == &models::ggx());
    QTRY_VERIFY_WITH_TIMEOUT(editor.tasks.isIdle(), patienceMilliseconds);
    QCOMPARE(offered.count(), 1);
    // What an artist sees comes first, the name of the model last.
    const QString question = offered.front().front().toString();
    QVERIFY(question.startsWith("This material has several highlights") && question.contains("(Layered"));
    QVERIFY(modelEdit(editor.document)->model == &models::ggx() && !editor.document.isModified());
    editor.controller.applyProposal();
    QVERIFY(modelEdit(editor.document)->model == &models::findModel("layered"));
    editor.document.history().undo();
    QVERIFY(modelEdit(editor.document)->model == &models::ggx());

    editor.controller.open("library:merl-copy/red-fabric");
    QTRY_COMPARE_WITH_TIMEOUT(editor.document.name(), QStringLiteral("red-fabric"), patienceMilliseconds);
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document) && editor.tasks.isIdle(), patienceMilliseconds);
    QCOMPARE(offered.count(), 1);
  }

  void aNewerLoadWinsAndAStoppedFitIsAProposal() {
    Editor editor;
    QSignalSpy offered(&editor.controller, &DocumentController::proposalOffered);
    editor.controller.open("library:sgd/chrome");
    editor.controller.open(material);
    QTRY_VERIFY_WITH_TIMEOUT(editor.controller.isFitting(), patienceMilliseconds);
    QCOMPARE(editor.document.name(), QStringLiteral("green-plastic"));
    // Before the first progress there is nothing to offer.
    QVERIFY(QTest::qWaitFor([&] { return editor.tasks.topmost() && editor.tasks.topmost()->fraction > 0; }));
    editor.tasks.cancelTopmost();
    QTRY_VERIFY_WITH_TIMEOUT(editor.tasks.isIdle(), patienceMilliseconds);
    QCOMPARE(offered.count(), 1);
    QVERIFY(!modelEdit(editor.document));
    editor.controller.applyProposal();
    QVERIFY(modelEdit(editor.document));
    QCOMPARE(editor.document.history().count(), 1);
    editor.document.history().undo();
    QVERIFY(!modelEdit(editor.document));
  }
};

GONIO_TEST(DocumentControllerTest)
}  // namespace document_controller_test

#include "document_controller_test.moc"
