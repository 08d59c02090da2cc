// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/scene/scene_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include "app/gonio/window/document_files.h"
#include "core/models/registry.h"
#include "core/rendering/environment.h"
#include "core/rendering/sampling_method.h"
#include "core/rendering/scene_file.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/support/test_program.h"
#include "tests/widgets/child.h"
#include "widgets/interpolation/material_slot_widget.h"
#include "widgets/panels/effect_list.h"
#include "widgets/preview/preview_widget.h"

namespace scene_panel_test {
using namespace gonio;
using namespace gonio::rendering;
using app::ScenePanel;

class ScenePanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    preview_ = std::make_unique<widgets::PreviewWidget>();
    tasks_ = std::make_unique<app::BackgroundTasks>();
    document_ = std::make_unique<app::Document>();
    panel_ = std::make_unique<ScenePanel>(*preview_, *document_, *tasks_);
  }
  void cleanup() {
    panel_.reset();
    document_.reset();
    tasks_.reset();
    preview_.reset();
  }

  /// A scene that is chosen is shown, and the plan is that of the scene: of these effects the lone sphere has one.
  void aChosenSceneIsPlanned() {
    QVERIFY(!content().plan().simulates(Effect::castShadows));
    choose("sphere-point-light");
    QTRY_COMPARE(content().scene().name, std::string("sphere-point-light"));
    QVERIFY(content().plan().simulates(Effect::castShadows) && content().plan().simulates(Effect::directLight));
    QVERIFY(!content().plan().simulates(Effect::environmentLight));
    QVERIFY(shows(QString::fromStdString(content().plan()[Effect::castShadows].reason)));
    choose("bowl");
    QTRY_VERIFY(content().plan().simulates(Effect::selfShadowing));
    QVERIFY(shows(QString::fromStdString(content().plan()[Effect::selfShadowing].reason)));
  }

  /// The environment and the background that the user chose stay when the scene changes; until then, and after "As the
  /// Scene", each scene has its own.
  void theChosenLightStays() {
    choose("sphere-point-light");
    QTRY_COMPARE(content().scene().name, std::string("sphere-point-light"));
    QVERIFY(!content().scene().environment);
    const auto sky = openEnvironment("sky");
    content().setEnvironment(sky);
    content().setBackground(true, true);
    preview_->setExposure(1.5);
    choose("bowl");
    QTRY_COMPARE(content().scene().name, std::string("bowl"));
    QCOMPARE(content().scene().environment, sky);
    QVERIFY(content().scene().showEnvironment && content().isEnvironmentChosen());
    QCOMPARE(preview_->display().exposure, 1.5);
    content().resetEnvironment();
    const Scene own = openScene("bowl");
    QCOMPARE(content().scene().environment != nullptr, own.environment != nullptr);
    QCOMPARE(content().scene().directionalLights.size(), own.directionalLights.size());
    choose("sphere-point-light");
    QTRY_COMPARE(content().scene().name, std::string("sphere-point-light"));
    QVERIFY(!content().scene().environment);
  }

  /// The switch forces, the row states it, and back by the plan nothing is left of it.
  void aSwitchForces() {
    QComboBox& shadows = *test::child<QComboBox>(*panel_, "Cast shadows: auto, on or off");
    activate(shadows, 1);
    QVERIFY(content().plan().simulates(Effect::castShadows) && !content().plan()[Effect::castShadows].calledFor);
    QVERIFY(shows("yes, forced"));
    activate(shadows, 0);
    QVERIFY(!content().plan().simulates(Effect::castShadows) && content().overrides() == EffectOverrides{});
    QVERIFY(!shows("yes, forced"));
  }

  /// Nothing can be measured without a material; with one every effect gets its cost, until another scene comes.
  void costsAreMeasured() {
    QVERIFY(!button("Measure Effects").isEnabled() && !button("Compare with Reference").isEnabled());
    content().setSubject(widgets::measuredSubject(
        app::test_support::glossyMaterial(0.3, {.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36})->base));
    QTRY_VERIFY(button("Measure Effects").isEnabled());
    button("Measure Effects").click();
    QTRY_VERIFY_WITH_TIMEOUT(panel_->costs(), 60000);
    QCOMPARE(panel_->costs()->effects.size(), effectCount);
    QVERIFY(panel_->costs()->seconds > 0);
    QCOMPARE(rowsWithCost(), int(effectCount));
    choose("torus");
    QTRY_VERIFY(!panel_->costs());
    QCOMPARE(rowsWithCost(), 0);
  }

  /// Every sampling method of goniotool can be chosen, with its name and a sentence, and the measurement uses it.
  void measurementsSampleByAMethod() {
    auto* sampling = test::child<QComboBox>(*panel_, "Sampling");
    QCOMPARE(sampling->count(), int(samplingMethods().size()));
    for (int i = 0; i < sampling->count(); ++i) {
      QCOMPARE(sampling->itemData(i).toString().toStdString(), std::string(samplingMethods()[std::size_t(i)].id));
      QVERIFY(!sampling->itemData(i, Qt::ToolTipRole).toString().isEmpty());
    }
    content().setSubject(widgets::measuredSubject(
        app::test_support::glossyMaterial(0.3, {.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36})->base));
    QTRY_VERIFY(button("Measure Effects").isEnabled());
    activate(*sampling, sampling->findData("cosine"));
    button("Measure Effects").click();
    QTRY_VERIFY_WITH_TIMEOUT(panel_->costs(), 60000);
  }

  /// At rest the plan is checked against a picture with everything on: what it wrongly leaves out comes back.
  void aPlanThatLeavesOutTooMuchIsExtended() {
    content().setSubject(widgets::measuredSubject(
        app::test_support::glossyMaterial(0.3, {.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36})->base));
    choose("bowl");
    QTRY_VERIFY(content().first().material() && content().plan().reflections > 1);
    const EffectPlan right = content().plan();
    EffectPlan wrong = right;
    wrong.reflections = 1;
    content().setCheckedPlan(wrong);
    QCOMPARE(content().plan().reflections, 1);
    QTRY_VERIFY_WITH_TIMEOUT(content().plan() == right, 60000);
  }

  /// The picture after one, two... reflections: the plan has no more, and all again with "All".
  void reflectionsAreShownOneAfterTheOther() {
    content().setSubject(widgets::measuredSubject(
        app::test_support::glossyMaterial(0.3, {.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36})->base));
    choose("bowl");
    QTRY_VERIFY(content().first().material() && content().plan().reflections > 2);
    const int all = content().plan().reflections;
    auto* reflections = panel_->findChild<QSpinBox*>();
    for (const int limit : {1, 2}) {
      reflections->setValue(limit);
      QCOMPARE(content().plan().reflections, limit);
    }
    reflections->setValue(0);
    QCOMPARE(reflections->text(), QString("All"));
    QCOMPARE(content().plan().reflections, all);
  }

  /// A scene of several places has a well for each but the first; what is put there is traced, and measured, with it.
  void anotherMaterialStandsBeside() {
    const auto wellsShown = [this] {
      int shown = 0;
      for (int place = 0; place < app::SceneMaterialSlots::count; ++place) shown += !slotWidget(place).isHidden();
      return shown;
    };
    QVERIFY(panel_->otherSlots().isHidden());
    choose("row");
    QTRY_COMPARE(wellsShown(), 3);
    choose("two-spheres");
    QTRY_COMPARE(wellsShown(), 1);
    QVERIFY(!test::child<QToolButton>(slotWidget(0), "Current")->isEnabled());
    const auto material =
        app::test_support::glossyMaterial(0.3, {.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36});
    document_->replaceMaterial(material, {});
    content().setSubject(widgets::measuredSubject(material->base));
    QTRY_VERIFY(content().first().material() && content().tracing() == widgets::Tracing::never);
    test::child<QToolButton>(slotWidget(0), "Current")->click();
    QTRY_VERIFY(content().tracing() == widgets::Tracing::atRest);
    QVERIFY(content().otherSlotMaterials()[0] && content().otherSlotMaterials()[0] != content().first().material());
    QVERIFY(!slotWidget(0).content().name.isEmpty());
    choose("sphere");
    QTRY_VERIFY(content().tracing() == widgets::Tracing::never);  // it has no second place
    choose("two-spheres");
    QTRY_VERIFY(content().tracing() == widgets::Tracing::atRest);
    test::child<QToolButton>(slotWidget(0), "Material B: empty the slot")->click();
    QVERIFY(content().tracing() == widgets::Tracing::never && slotWidget(0).content().name.isEmpty());
    QSignalSpy failed(panel_.get(), &ScenePanel::failed);
    panel_->otherSlots().read(0, "/nowhere/metal.binary");
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(slotWidget(0).content().failed && content().tracing() == widgets::Tracing::never);
  }

  void aSceneThatCannotBeReadIsTold() {
    QSignalSpy failed(panel_.get(), &ScenePanel::failed);
    panel_->open("/nowhere/scene.json");
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(failed[0][1].toString().contains("/nowhere/scene.json"));
    QCOMPARE(content().scene().name, std::string("sphere"));
  }

  /// A document keeps the scene by its name; one from before there were scenes has the lone sphere.
  void aViewKeepsTheScene() {
    choose("two-spheres");
    QTRY_COMPARE(content().scene().name, std::string("two-spheres"));
    QCOMPARE(app::sceneNameOf(app::viewToJson(*preview_)), QString("two-spheres"));
    QCOMPARE(app::sceneNameOf({{"yaw", 0.1}}), QString("sphere"));
  }

  /// A mesh is shown with the axis that was chosen, again when it is chosen from the list, and the view keeps the axis.
  void aMeshIsStoodUpright() {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    const auto path = test::writeFile("scenes/tooth.obj", std::as_bytes(std::span(text)));
    auto* up = test::child<QComboBox>(*panel_, "Up axis");
    const auto isUpright = [this] {
      const auto* shape = std::get_if<MeshShape>(&content().scene().objects[0].shape);
      if (!shape) return false;
      const auto bounds = (*shape)->mesh().bounds();
      return bounds.max.y - bounds.min.y > bounds.max.z - bounds.min.z;
    };
    QVERIFY(up->isHidden());
    panel_->open(QString::fromStdString(path.string()));
    QTRY_COMPARE(content().scene().name, std::string("tooth"));
    QVERIFY(!up->isHidden() && up->currentText() == "Y up" && !isUpright());
    activate(*up, 1);
    QTRY_VERIFY(isUpright());
    const nlohmann::json view = app::viewToJson(*preview_);
    QVERIFY(app::scenePoseOf(view) == MeshPose(UpAxis::z));
    QVERIFY(app::scenePoseOf({{"scene", path.string()}}) == MeshPose());
    choose("sphere");
    QTRY_COMPARE(content().scene().name, std::string("sphere"));
    QVERIFY(up->isHidden());
    choose(path.string().c_str());
    QTRY_VERIFY(isUpright());
    QCOMPARE(up->currentText(), QString("Z up"));
  }

  /// A mesh that shows its back is turned with a button; the turn belongs to the view, and to the mesh when it is
  /// chosen again.
  void aMeshIsTurnedToTheViewer() {
    const std::string text = "v -1 0 1\nv 1 0 1\nv 0 1 1\nv 0 0 -3\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";
    const auto path = test::writeFile("scenes/back.obj", std::as_bytes(std::span(text)));
    auto* turn = test::child<QPushButton>(*panel_, "Turn mesh");
    const auto tip = [this] {
      const auto* shape = std::get_if<MeshShape>(&content().scene().objects[0].shape);
      return shape ? (*shape)->mesh().positions()[3] : glm::vec3(0);
    };
    QVERIFY(turn->isHidden());
    panel_->open(QString::fromStdString(path.string()));
    QTRY_COMPARE(content().scene().name, std::string("back"));
    QVERIFY(!turn->isHidden() && tip().z < -0.5f);
    turn->click();
    QTRY_VERIFY(tip().x < -0.5f);
    turn->click();
    QTRY_VERIFY(tip().z > 0.5f);
    QVERIFY(app::scenePoseOf(app::viewToJson(*preview_)) == MeshPose(UpAxis::y, 2));
    choose("sphere");
    QTRY_VERIFY(turn->isHidden());
    choose(path.string().c_str());
    QTRY_VERIFY(tip().z > 0.5f);
  }

 private:
  widgets::PreviewContent& content() { return preview_->content(); }

  QPushButton& button(const QString& text) const { return *test::child<QPushButton>(*panel_, text); }
  widgets::MaterialSlotWidget& slotWidget(int place) const {
    return *panel_->otherSlots().findChildren<widgets::MaterialSlotWidget*>().at(place);
  }
  void choose(const char* scene) {
    auto* scenes = test::child<QComboBox>(*panel_, "Scene");
    activate(*scenes, scenes->findData(QString(scene)));
  }
  void activate(QComboBox& box, int index) {
    box.setCurrentIndex(index);
    Q_EMIT box.activated(index);
  }
  int rowsWithCost() {
    int rows = 0;
    for (const QLabel* cost : panel_->findChildren<QLabel*>("cost")) rows += cost->text() != "-";
    return rows;
  }
  bool shows(const QString& text) {
    for (const QLabel* label : panel_->findChildren<QLabel*>())
      if (label->text().contains(text)) return true;
    return false;
  }

  std::unique_ptr<widgets::PreviewWidget> preview_;
  std::unique_ptr<app::BackgroundTasks> tasks_;
  std::unique_ptr<app::Document> document_;
  std::unique_ptr<ScenePanel> panel_;
};

GONIO_TEST(ScenePanelTest)
}  // namespace scene_panel_test

#include "scene_panel_test.moc"
