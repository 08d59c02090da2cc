// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/scene/view_strip.h"

#include <QComboBox>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "app/gonio/scene/environment_controller.h"
#include "app/gonio/scene/scene_panel.h"
#include "core/io/image_io.h"
#include "tests/support/test_program.h"
#include "widgets/inputs/number_field.h"
#include "widgets/preview/preview_widget.h"

namespace view_strip_test {
using namespace gonio;
using namespace gonio::app;

class ViewStripTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    // Its own recent environments, beside tests that run at the same time.
    settings_ = std::make_unique<QTemporaryDir>();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_->path());
    preview_ = std::make_unique<widgets::PreviewWidget>();
    tasks_ = std::make_unique<BackgroundTasks>();
    document_ = std::make_unique<Document>();
    environment_ = std::make_unique<EnvironmentController>(*tasks_, preview_->content());
    scene_ = std::make_unique<ScenePanel>(*preview_, *document_, *tasks_);
    strip_ = std::make_unique<ViewStrip>(*preview_, *scene_, *environment_, *tasks_);
  }
  void cleanup() {
    strip_.reset();
    scene_.reset();
    environment_.reset();
    document_.reset();
    tasks_.reset();
    preview_.reset();
  }

  /// What is chosen is shown, and the strip shows what is: also what was changed elsewhere.
  void scenesAndLights() {
    QCOMPARE(strip_->scenes().currentText(), QString("Sphere"));
    QCOMPARE(strip_->lights().currentText(), QString("From scene"));
    choose(strip_->scenes(), "Cloth");
    QTRY_COMPARE(preview_->content().scene().name, std::string("cloth"));
    QCOMPARE(strip_->scenes().currentText(), QString("Cloth"));
    choose(strip_->lights(), "Window");
    QTRY_COMPARE(environment_->name(), QString("window"));
    QCOMPARE(strip_->lights().currentText(), QString("Window"));
    choose(strip_->lights(), "Distant light");
    QTRY_VERIFY(!preview_->content().scene().environment);
    QCOMPARE(strip_->lights().currentText(), QString("Distant light"));
    choose(strip_->lights(), "From scene");
    QCOMPARE(environment_->name(), QString("studio"));
    scene_->open("sphere-distant-light");
    QTRY_COMPARE(strip_->scenes().currentText(), QString("Sphere distant light"));
  }

  /// A picture that was opened is named, is ticked, and can be chosen again.
  void anOpenedPictureIsNamed() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("garden.exr");
    Image image(8, 4);
    for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(0.5f);
    io::writeExr(image, path.toStdString(), {});
    environment_->open(path);
    QTRY_COMPARE(strip_->lights().currentText(), QString("garden.exr"));
    QCOMPARE(environment_->recent(), QStringList{path});
    choose(strip_->lights(), "Sky");
    QTRY_COMPARE(environment_->name(), QString("sky"));
    choose(strip_->lights(), "garden.exr");
    QTRY_COMPARE(environment_->name(), path);
    QVERIFY(QFile::remove(path));
    QSignalSpy failed(environment_.get(), &EnvironmentController::failed);
    choose(strip_->lights(), "garden.exr");
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(environment_->recent().isEmpty());
  }

  void backgrounds() {
    choose(strip_->backgrounds(), "Checker");
    QVERIFY(preview_->display().checker && !preview_->content().scene().showEnvironment);
    choose(strip_->backgrounds(), "Environment");
    QVERIFY(!preview_->display().checker && preview_->content().scene().showEnvironment);
    choose(strip_->backgrounds(), "Environment, blurred");
    QVERIFY(preview_->content().scene().showEnvironment && preview_->content().scene().blurBackground);
    choose(strip_->scenes(), "Bowl");
    QTRY_COMPARE(preview_->content().scene().name, std::string("bowl"));
    QCOMPARE(strip_->backgrounds().currentText(), QString("Environment, blurred"));
    choose(strip_->lights(), "Distant light");
    QTRY_COMPARE(strip_->backgrounds().currentText(), QString("Plain"));
  }

  void exposure() {
    Q_EMIT strip_->exposure().valueEdited(1.5);
    QCOMPARE(preview_->display().exposure, 1.5);
    preview_->setExposure(-2);
    QCOMPARE(strip_->exposure().value(), -2.0);
  }

  void filesAreAskedFor() {
    QSignalSpy scene(strip_.get(), &ViewStrip::sceneFileRequested);
    QSignalSpy environment(strip_.get(), &ViewStrip::environmentFileRequested);
    choose(strip_->scenes(), "Mesh or scene...");
    choose(strip_->lights(), "Image (HDR, EXR)...");
    QCOMPARE(scene.count(), 1);
    QCOMPARE(environment.count(), 1);
    QCOMPARE(strip_->scenes().currentText(), QString("Sphere"));
    QCOMPARE(strip_->lights().currentText(), QString("From scene"));
  }

 private:
  static void choose(QComboBox& box, const QString& text) {
    const int index = box.findText(text);
    QVERIFY2(index >= 0, qPrintable(text));
    box.setCurrentIndex(index);
    Q_EMIT box.activated(index);
  }

  std::unique_ptr<QTemporaryDir> settings_;
  std::unique_ptr<widgets::PreviewWidget> preview_;
  std::unique_ptr<BackgroundTasks> tasks_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<EnvironmentController> environment_;
  std::unique_ptr<ScenePanel> scene_;
  std::unique_ptr<ViewStrip> strip_;
};

GONIO_TEST(ViewStripTest)
}  // namespace view_strip_test

#include "view_strip_test.moc"
