// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// The blend that becomes the document's material.
#include <QComboBox>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "app/gonio/document/edit_steps.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/interpolation_panel_test_support.h"
#include "tests/support/test_program.h"

namespace kept_blend_test {
using namespace gonio;
using namespace gonio::interpolation;
using namespace gonio::app;
using namespace gonio::app::test_support;
using interpolation::InterpolationSpace;

class KeptBlendTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The blend takes the document's place in one step; undo brings back the material with its edits and its file.
  void keepingIsAnUndoStep() {
    Editor editor;
    editor.fill(0, "dark", 0.2);
    editor.fill(1, "light", 0.6);
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.spaces().prepared(InterpolationSpace::linear), patienceMilliseconds);
    const models::Model& lambert = models::findModel("lambert");
    fitting::FitResult fit;
    fit.model = &lambert;
    fit.parameters = {{Rgb(0.6)}};
    editor.document.adoptFit(fit);
    setParameter(editor.document, 0, Rgb(0.5));
    editor.document.markSaved("/somewhere/light.gonio");
    editor.panel.moveTo({0.25, 0});
    editor.openButton().click();
    QTRY_COMPARE_WITH_TIMEOUT(editor.document.history().count(), 2, patienceMilliseconds);
    QVERIFY(std::abs(normalValue(*editor.document.material()->table()) - 0.3) < 1e-6);
    QVERIFY(editor.document.isModified() && editor.document.path().isEmpty());
    QVERIFY(editor.document.history().text(1).contains("75 % dark"));
    QTRY_VERIFY_WITH_TIMEOUT(modelEdit(editor.document), patienceMilliseconds);  // fitted as if it had been opened
    QCOMPARE(modelEdit(editor.document)->model, &defaultModel());
    // It can be edited further, and all of it goes back.
    setParameter(editor.document, 0, Rgb(0.1));
    editor.document.history().undo();
    editor.document.history().undo();
    QCOMPARE(QString::fromStdString(editor.document.material()->material.name), QStringLiteral("light"));
    QCOMPARE(editor.document.path(), QStringLiteral("/somewhere/light.gonio"));
    QVERIFY(!editor.document.isModified());
    QVERIFY(modelEdit(editor.document)->edited.values[0] == Rgb(0.5));
    editor.document.history().redo();
    QVERIFY(std::abs(normalValue(*editor.document.material()->table()) - 0.3) < 1e-6);
    QVERIFY(modelEdit(editor.document) && modelEdit(editor.document)->isIdentity());
    // What is saved names the materials and their weights.
    const documents::EditDocument stored = editor.document.toEditDocument();
    QCOMPARE(stored.blend->weights, (std::vector{0.75, 0.25}));
    QCOMPARE(stored.blend->materials[1].sourcePath, std::string("/nowhere/light.binary"));
    QCOMPARE(stored.sourceSha256, documents::blendSha256(*stored.blend));
    QTRY_VERIFY_WITH_TIMEOUT(editor.isSettled(), patienceMilliseconds);
  }

  /// A blend that is opened remembers whether it preserves detail.
  void keptWithItsDetail() {
    for (const bool preserves : {true, false}) {
      Editor editor;
      editor.fill(0, "dark", 0.2);
      editor.fill(1, "light", 0.6);
      editor.panel.spaces().setPreservesDetail(preserves);
      QComboBox& box = *editor.panel.findChildren<QComboBox*>().front();
      box.setCurrentIndex(box.findData(int(InterpolationSpace::dictionary)));
      Q_EMIT box.activated(box.currentIndex());
      QTRY_VERIFY_WITH_TIMEOUT(editor.panel.spaces().prepared(InterpolationSpace::dictionary), patienceMilliseconds);
      editor.panel.moveTo({0.25, 0});
      editor.openButton().click();
      QTRY_COMPARE_WITH_TIMEOUT(editor.document.history().count(), 1, patienceMilliseconds);
      const documents::EditDocument stored = editor.document.toEditDocument();
      QCOMPARE(stored.blend->space, InterpolationSpace::dictionary);
      QCOMPARE(stored.blend->preserveDetail, preserves);
      QTRY_VERIFY_WITH_TIMEOUT(editor.isSettled(), patienceMilliseconds);
    }
  }

  /// Current is what is seen: the material with its edits, which the kept blend remembers.
  void currentHasItsEdits() {
    Editor editor;
    editor.document.setMaterial(greyMaterial("light", 0.6));
    fitting::FitResult fit;
    fit.model = &models::findModel("lambert");
    fit.parameters = {{Rgb(0.6)}};
    editor.document.adoptFit(fit);
    setParameter(editor.document, 0, Rgb(0.5));
    editor.panel.begin();
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.materials().at(0), patienceMilliseconds);
    QVERIFY(std::abs(normalValue(*editor.panel.materials().at(0)->material.table) - 0.5) < 1e-6);
    QCOMPARE(editor.panel.materials().at(0)->source.edits.size(), std::size_t(1));
  }

  /// A blend that is still being computed does not take the place of a material that was opened meanwhile.
  void anotherMaterialStaysOpen() {
    Editor editor;
    editor.fill(0, "dark", 0.2);
    editor.fill(1, "light", 0.6);
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.spaces().prepared(InterpolationSpace::linear), patienceMilliseconds);
    editor.panel.moveTo({0.25, 0});
    editor.openButton().click();
    editor.document.setMaterial(greyMaterial("opened", 0.9));
    QTRY_VERIFY_WITH_TIMEOUT(editor.isSettled(), patienceMilliseconds);
    QCOMPARE(editor.document.material()->material.name, std::string("opened"));
  }

  /// After a swap the blend is still the same material: it names the materials in the order of their preparation.
  void keptAfterASwap() {
    Editor editor;
    editor.fill(0, "dark", 0.2);
    editor.fill(1, "light", 0.6);
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.spaces().prepared(InterpolationSpace::linear), patienceMilliseconds);
    editor.panel.materials().swap(0, 1);
    editor.panel.moveTo({0.25, 0});
    editor.openButton().click();
    QTRY_COMPARE_WITH_TIMEOUT(editor.document.history().count(), 1, patienceMilliseconds);
    QVERIFY(std::abs(normalValue(*editor.document.material()->table()) - 0.5) < 1e-6);
    const documents::EditDocument stored = editor.document.toEditDocument();
    for (std::size_t i = 0; i < 2; ++i) {
      const bool dark = stored.blend->materials[i].sourcePath == "/nowhere/dark.binary";
      QCOMPARE(stored.blend->weights[i], dark ? 0.25 : 0.75);
    }
  }
};

GONIO_TEST(KeptBlendTest)
}  // namespace kept_blend_test

#include "kept_blend_test.moc"
