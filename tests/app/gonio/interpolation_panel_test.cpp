// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "app/gonio/document/edit_steps.h"
#include "core/models/registry.h"
#include "tests/app/gonio/interpolation_panel_test_support.h"
#include "tests/support/test_program.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"
#include "widgets/interpolation/blend_pad.h"
#include "widgets/interpolation/blend_strip.h"
#include "widgets/interpolation/material_slot_widget.h"
#include "widgets/library/material_drag.h"
#include "widgets/panels/model_panel.h"

namespace interpolation_panel_test {
using namespace gonio;
using namespace gonio::interpolation;
using namespace gonio::app;
using namespace gonio::app::test_support;
using interpolation::InterpolationSpace;

widgets::ParameterSlider& slider(const Editor& editor) { return *editor.panel.findChild<widgets::ParameterSlider*>(); }
widgets::NumberField& number(const Editor& editor) { return *editor.panel.findChild<widgets::NumberField*>(); }
widgets::BlendPad& pad(const Editor& editor) { return *editor.panel.findChild<widgets::BlendPad*>(); }
widgets::BlendStrip& strip(const Editor& editor) { return *editor.panel.findChild<widgets::BlendStrip*>(); }
QComboBox& spaceBox(const Editor& editor) { return *test::child<QComboBox>(editor.panel, "Method of blending"); }
widgets::ModelBox& modelBox(const Editor& editor) { return *editor.panel.findChild<widgets::ModelBox*>(); }
QPushButton& drawButton(const Editor& editor) { return *test::child<QPushButton>(editor.panel, "Resume Rendering"); }

class InterpolationPanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Nothing in the wells: nothing to show or to keep, and asking for it states why.
  void theEmptyPanel() {
    Editor editor;
    QVERIFY(editor.panel.isSettled());
    QVERIFY(!editor.panel.subject());
    QVERIFY(strip(editor).rows().empty());
    QVERIFY(!editor.openButton().isEnabled());
    QVERIFY(!test::child<QToolButton>(editor.slotWidget(0), "Current")->isEnabled());
    QSignalSpy failed(&editor.panel, &InterpolationPanel::failed);
    editor.panel.openAsMaterial();
    QCOMPARE(failed.count(), 1);
    QVERIFY(!editor.document.material());
  }

  /// Two greys in the linear space: the grey in between, at once under the hand; slider, number and strip agree.
  void twoMaterialsAndTheSlider() {
    Editor editor;
    editor.fill(0, "dark", 0.2);
    QVERIFY(!editor.panel.subject());
    editor.fill(1, "light", 0.6);
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.spaces().prepared(InterpolationSpace::linear), patienceMilliseconds);
    QSignalSpy changed(&editor.panel, &InterpolationPanel::subjectChanged);
    Q_EMIT slider(editor).numberEdited(0.25);
    QVERIFY(changed.count() > 0);
    QCOMPARE(number(editor).value(), 0.25);
    QCOMPARE(slider(editor).number(), 0.25);
    QVERIFY(std::holds_alternative<widgets::PreviewBlend>(editor.panel.subject()->shown));
    QVERIFY(std::abs(normalValue(*widgets::subjectBrdf(*editor.panel.subject())) - 0.3) < 1e-6);
    Q_EMIT number(editor).valueEdited(0.5);
    QCOMPARE(slider(editor).number(), 0.5);
    QVERIFY(std::abs(normalValue(*widgets::subjectBrdf(*editor.panel.subject())) - 0.4) < 1e-6);
    QVERIFY(editor.panel.description().contains("50 % dark") && editor.panel.description().contains("Linear"));
    QCOMPARE(editor.slotWidget(1).content().note, QStringLiteral("50 %"));
    // The end is the material, not a blend of one.
    Q_EMIT slider(editor).numberEdited(1);
    QVERIFY(editor.panel.subject()->isMeasured());
    QVERIFY(editor.panel.subject()->base() == editor.panel.materials().at(1)->material.table);
    // Swapped: the same place, the other end.
    editor.panel.materials().swap(0, 1);
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.subject(), patienceMilliseconds);
    QVERIFY(std::abs(normalValue(*widgets::subjectBrdf(*editor.panel.subject())) - 0.2) < 1e-6);
  }

  /// Every space has its row; a click on a sphere takes its space and its place.
  void theStripShowsTheSpaces() {
    Editor editor;
    editor.fill(0, "dark", 0.2);
    editor.fill(1, "light", 0.6);
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.isSettled(), patienceMilliseconds);
    const auto& rows = strip(editor).rows();
    QCOMPARE(rows.size(), editor.panel.spaces().spaces().size());
    for (const auto& row : rows) {
      QVERIFY2(row.note.isEmpty(), qPrintable(row.name + ": " + row.note));
      QCOMPARE(int(row.pictures.size()), BlendSpaces::pictureCount);
      for (const QImage& picture : row.pictures) QVERIFY(!picture.isNull());
      QVERIFY(row.pictures.front() != row.pictures.back());
      QVERIFY(row.pictures.front() == rows[0].pictures.front());  // an end is the material in every space
      QVERIFY(!row.toolTip.isEmpty());
    }
    Q_EMIT strip(editor).chosen(1, 2);
    QCOMPARE(editor.panel.space(), editor.panel.spaces().spaces()[1]);
    QCOMPARE(spaceBox(editor).currentIndex(), 1);
    QVERIFY(std::abs(editor.panel.position().x() - 1 / 3.0) < 1e-12);
    // Its name takes the space alone.
    Q_EMIT strip(editor).chosen(0, -1);
    QCOMPARE(editor.panel.space(), InterpolationSpace::linear);
    QVERIFY(std::abs(editor.panel.position().x() - 1 / 3.0) < 1e-12);
  }

  /// The cost is that of the present weights, measured where the position rests; before it is that of equal ones.
  void theCostFollowsThePosition() {
    Editor editor;
    editor.fill(0, "dark", 0.2);
    editor.fill(1, "light", 0.6);
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.isSettled(), patienceMilliseconds);
    const auto shown = [&](const QString& begin) {
      const auto labels = editor.panel.findChildren<QLabel*>();
      return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text().contains(begin); });
    };
    QVERIFY(shown("\nThe blend takes"));
    editor.panel.moveTo({0.25, 0});
    QVERIFY(shown("\nAt equal weights, the blend takes") && !editor.panel.isSettled());
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.isSettled(), patienceMilliseconds);
    QVERIFY(shown("\nThe blend takes"));
    editor.panel.moveTo({0.3, 0});
    QVERIFY(shown("\nAt equal weights, the blend takes"));
    editor.panel.moveTo({0.5, 0});
    QVERIFY(shown("\nThe blend takes"));
  }

  /// Three materials: the pad takes the slider's place; its weights are those of the blend.
  void threeMaterialsAndThePad() {
    Editor editor;
    editor.fill(0, "dark", 0.2);
    editor.fill(1, "light", 0.6);
    QVERIFY(slider(editor).isVisible());
    editor.panel.materials().addSlot();
    QVERIFY(!slider(editor).isVisible() && pad(editor).isVisible());
    QVERIFY(!editor.panel.subject());
    for (const double weight : editor.panel.weights()) QVERIFY(std::abs(weight - 1 / 3.0) < 1e-12);  // as before: equal
    editor.fill(2, "white", 0.9);
    QTRY_VERIFY_WITH_TIMEOUT(
        editor.panel.subject() || !test::child<QCheckBox>(editor.panel, "Show in the preview")->isChecked(),
        patienceMilliseconds);
    pad(editor).setFocus();
    QTest::keyClick(&pad(editor), Qt::Key_Home);
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.subject(), patienceMilliseconds);
    QVERIFY(pad(editor).place() == editor.panel.position());
    QVERIFY(editor.panel.weights() == pad(editor).weights());
    QVERIFY(std::abs(normalValue(*widgets::subjectBrdf(*editor.panel.subject())) - 1.7 / 3) < 1e-6);
    QTest::keyClick(&pad(editor), Qt::Key_3);
    QVERIFY(std::abs(normalValue(*widgets::subjectBrdf(*editor.panel.subject())) - 0.9) < 1e-6);
    // Back to two: the place goes to the nearest that there is.
    test::child<QToolButton>(editor.panel, "Material C: empty the slot")->click();
    QCOMPARE(editor.panel.materials().count(), 2);
    QVERIFY(slider(editor).isVisible());
    QCOMPARE(editor.panel.weights(), (std::vector<double>{1, 0}));
  }

  /// A drop of something that nobody reads: reported with its name, shown in the well, and the well can be used again.
  void aDropThatCannotBeReadIsTold() {
    Editor editor;
    QSignalSpy failed(&editor.panel, &InterpolationPanel::failed);
    const std::unique_ptr<QMimeData> data(widgets::toDrag("/nowhere/at-all.binary"));
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&editor.slotWidget(0), &enter);
    QDropEvent drop(QPointF(9, 9), Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&editor.slotWidget(0), &drop);
    QCOMPARE(editor.slotWidget(0).content().note, QStringLiteral("Opening..."));
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, patienceMilliseconds);
    QVERIFY(failed[0][1].toString().contains("at-all.binary"));
    QVERIFY(editor.slotWidget(0).content().failed);
    editor.fill(0, "dark", 0.2);
    QVERIFY(!editor.slotWidget(0).content().failed);
  }

  /// Beside the wells, too: the nearest one takes it, and says so while it is dragged there.
  void aDropBesideAWellGoesIntoTheNearest() {
    Editor editor;
    const std::unique_ptr<QMimeData> data(widgets::toDrag("library:sgd/nickel"));
    BlendSlots& blendSlots = *editor.panel.findChild<BlendSlots*>();
    const widgets::MaterialSlotWidget& second = blendSlots.slotWidget(1);
    const QPoint below = second.mapTo(blendSlots.viewport(), QPoint(5, second.height() + 12));
    QVERIFY(!second.geometry().contains(below));
    const QPoint above = blendSlots.slotWidget(0).mapTo(blendSlots.viewport(), QPoint(5, -2));
    QDragEnterEvent enter(above, Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QVERIFY(QApplication::sendEvent(blendSlots.viewport(), &enter) && enter.isAccepted());
    QDragMoveEvent move(below, Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(blendSlots.viewport(), &move);
    QDropEvent drop(below, Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(blendSlots.viewport(), &drop);
    QVERIFY(!editor.panel.materials().isReading(0) && editor.panel.materials().isReading(1));
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.materials().at(1), patienceMilliseconds);
    QCOMPARE(editor.panel.materials().at(1)->name, QStringLiteral("nickel"));
  }

  /// Library materials are taken into the first empty place; a hidden panel leaves the preview alone.
  void materialsFromTheLibrary() {
    Editor editor;
    editor.panel.useMaterials({"library:sgd/nickel"});
    editor.panel.useMaterials({"library:sgd/red-fabric"});
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.materials().isComplete(), patienceMilliseconds);
    QCOMPARE(editor.panel.materials().at(0)->name, QStringLiteral("nickel"));
    QCOMPARE(editor.panel.materials().at(1)->name, QStringLiteral("red-fabric"));
    QVERIFY(!editor.panel.materials().at(0)->picture.isNull());
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.subject(), patienceMilliseconds);
    QSignalSpy changed(&editor.panel, &InterpolationPanel::subjectChanged);
    editor.panel.hide();
    QVERIFY(changed.count() > 0 && !editor.panel.subject());
  }

  /// Several at once: as many places as there are materials, in their order.
  void severalFromTheLibrary() {
    Editor editor;
    editor.fill(0, "dark", 0.2);
    editor.panel.useMaterials({"library:sgd/nickel", "library:sgd/red-fabric", "library:sgd/chrome"});
    QCOMPARE(editor.panel.materials().count(), 3);
    QTRY_VERIFY_WITH_TIMEOUT(!editor.panel.materials().isReading(), patienceMilliseconds);
    QCOMPARE(editor.panel.materials().at(0)->name, QString("nickel"));
    QCOMPARE(editor.panel.materials().at(2)->name, QString("chrome"));
    editor.panel.useMaterials({"library:sgd/chrome", "library:sgd/nickel"});
    QCOMPARE(editor.panel.materials().count(), 2);
    QSignalSpy failed(&editor.panel, &InterpolationPanel::failed);
    editor.panel.useMaterials({"a", "b", "c", "d", "e"});
    QVERIFY(failed.count() == 1 && editor.panel.materials().count() == 2);
    // One more takes a slot of its own, also while the others are being read; without a free slot nothing is replaced.
    for (const char* more : {"library:sgd/red-fabric", "library:sgd/alumina-oxide", "library:sgd/black-fabric"})
      editor.panel.useMaterials({more});
    QVERIFY(failed.count() == 2 && editor.panel.materials().count() == 4);
    QTRY_VERIFY_WITH_TIMEOUT(!editor.panel.materials().isReading(), patienceMilliseconds);
    QCOMPARE(editor.panel.materials().at(1)->name, QString("nickel"));
    QCOMPARE(editor.panel.materials().at(3)->name, QString("alumina-oxide"));
    editor.panel.spaces().pause();
  }

  /// The choice of a model is there where the space has one.
  void theModelOfASpace() {
    Editor editor;
    const auto choose = [&](InterpolationSpace space) {
      QComboBox& box = spaceBox(editor);
      box.setCurrentIndex(box.findData(int(space)));
      Q_EMIT box.activated(box.currentIndex());
    };
    QVERIFY(modelBox(editor).isHidden());
    choose(InterpolationSpace::differential);
    QVERIFY(!modelBox(editor).isHidden());
    Q_EMIT modelBox(editor).modelChosen(&models::findModel("ward"));
    QVERIFY(&editor.panel.spaces().model() == &models::findModel("ward"));
    choose(InterpolationSpace::factors);
    QVERIFY(modelBox(editor).isHidden());
  }

  /// The switch of the detail is there where the space loses it.
  void theDetailOfASpace() {
    Editor editor;
    auto& detail = *test::child<QCheckBox>(editor.panel, "Preserve measured detail");
    const auto choose = [&](InterpolationSpace space) {
      QComboBox& box = spaceBox(editor);
      box.setCurrentIndex(box.findData(int(space)));
      Q_EMIT box.activated(box.currentIndex());
    };
    for (const InterpolationSpace space : editor.panel.spaces().spaces()) {
      choose(space);
      QCOMPARE(!detail.isHidden(), interpolation::losesDetail(space));
    }
    QVERIFY(detail.isChecked() && editor.panel.spaces().preservesDetail());
    detail.click();
    QVERIFY(!editor.panel.spaces().preservesDetail());
    choose(InterpolationSpace::linear);
    choose(InterpolationSpace::factors);
    QVERIFY(!detail.isChecked());
  }

  /// Cancelled work says so, and the button does it after all.
  void cancelledSpacesCanBeDrawn() {
    Editor editor;
    editor.fill(0, "dark", 0.2);
    editor.fill(1, "light", 0.6);
    const auto cancelled = [&] {
      for (const auto& row : strip(editor).rows())
        if (row.note == "Cancelled") return true;
      return false;
    };
    // Work that ends before it hears of the cancel is done: the next is cancelled.
    const auto cancel = [&] {
      editor.tasks.cancelTopmost();
      return cancelled();
    };
    QTRY_VERIFY_WITH_TIMEOUT(cancel(), patienceMilliseconds);
    QVERIFY(editor.panel.isSettled() && drawButton(editor).isVisible());
    drawButton(editor).click();
    QVERIFY(!editor.panel.isSettled());
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.isSettled(), patienceMilliseconds);
    QVERIFY(!cancelled() && !drawButton(editor).isVisible());
  }

  /// What is edited is what is seen: the preview leaves the blend, and comes back to it with the hand.
  void editingTakesThePreviewBack() {
    Editor editor;
    editor.fill(0, "dark", 0.2);
    editor.fill(1, "light", 0.6);
    editor.panel.moveTo({0.5, 0});
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.subject(), patienceMilliseconds);
    fitting::FitResult fit;
    fit.model = &models::findModel("lambert");
    fit.parameters = {{Rgb(0.6)}};
    editor.document.adoptFit(fit);
    QVERIFY(editor.panel.subject());
    setParameter(editor.document, 0, Rgb(0.5));
    QVERIFY(!editor.panel.subject());
    editor.panel.moveTo({0.6, 0});
    QVERIFY(editor.panel.subject());
  }
};

GONIO_TEST(InterpolationPanelTest)
}  // namespace interpolation_panel_test

#include "interpolation_panel_test.moc"
