// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/scene/view_strip.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QScopeGuard>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <memory>

#include "app/gonio/scene/environment_controller.h"
#include "app/gonio/scene/scene_panel.h"
#include "core/io/image_io.h"
#include "tests/support/test_program.h"
#include "tests/widgets/child.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"
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
    QCOMPARE(box("Scene").currentText(), QString("Sphere"));
    QCOMPARE(box("Light").currentText(), QString("From scene"));
    choose(box("Scene"), "Cloth");
    QTRY_COMPARE(preview_->content().scene().name, std::string("cloth"));
    QCOMPARE(box("Scene").currentText(), QString("Cloth"));
    choose(box("Light"), "Window");
    QTRY_COMPARE(environment_->name(), QString("window"));
    QCOMPARE(box("Light").currentText(), QString("Window"));
    choose(box("Light"), "Distant light");
    QTRY_VERIFY(!preview_->content().scene().environment);
    QCOMPARE(box("Light").currentText(), QString("Distant light"));
    choose(box("Light"), "From scene");
    QCOMPARE(environment_->name(), QString("studio"));
    scene_->open("sphere-distant-light");
    QTRY_COMPARE(box("Scene").currentText(), QString("Sphere, distant light"));
  }

  /// A picture that was opened is named, is ticked, and can be chosen again.
  void anOpenedPictureIsNamed() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("garden.exr");
    Image image(8, 4);
    for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(0.5f);
    io::writeExr(image, path.toStdString(), {});
    environment_->open(path);
    QTRY_COMPARE(box("Light").currentText(), QString("garden.exr"));
    QCOMPARE(environment_->recent(), QStringList{path});
    choose(box("Light"), "Sky");
    QTRY_COMPARE(environment_->name(), QString("sky"));
    choose(box("Light"), "garden.exr");
    QTRY_COMPARE(environment_->name(), path);
    QVERIFY(QFile::remove(path));
    QSignalSpy failed(environment_.get(), &EnvironmentController::failed);
    choose(box("Light"), "garden.exr");
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(environment_->recent().isEmpty());
  }

  void backgrounds() {
    choose(box("Background"), "Checker");
    QVERIFY(preview_->display().checker && !preview_->content().scene().showEnvironment);
    choose(box("Background"), "Environment");
    QVERIFY(!preview_->display().checker && preview_->content().scene().showEnvironment);
    choose(box("Background"), "Environment, blurred");
    QVERIFY(preview_->content().scene().showEnvironment && preview_->content().scene().blurBackground);
    choose(box("Scene"), "Bowl");
    QTRY_COMPARE(preview_->content().scene().name, std::string("bowl"));
    QCOMPARE(box("Background").currentText(), QString("Environment, blurred"));
    choose(box("Light"), "Distant light");
    QTRY_COMPARE(box("Background").currentText(), QString("Plain"));
  }

  void exposure() {
    auto* exposure = strip_->findChild<widgets::NumberField*>();
    Q_EMIT exposure->valueEdited(1.5);
    QCOMPARE(preview_->display().exposure, 1.5);
    preview_->setExposure(-2);
    QCOMPARE(exposure->value(), -2.0);
  }

  /// A narrow strip leaves out the slider of the exposure; the field remains.
  void aNarrowStripHasNoSlider() {
    QWidget window;
    strip_->setParent(&window);
    const auto free = qScopeGuard([this] { strip_->setParent(nullptr); });
    window.show();
    strip_->show();
    const auto* slider = strip_->findChild<widgets::ParameterSlider*>();
    const QSize narrow = strip_->minimumSizeHint();
    strip_->resize(narrow);
    QVERIFY(slider->isHidden() && !strip_->findChild<widgets::NumberField*>()->isHidden());
    QCOMPARE(strip_->minimumSizeHint(), narrow);
    strip_->resize(2 * narrow);
    QVERIFY(!slider->isHidden());
    QCOMPARE(strip_->minimumSizeHint(), narrow);
  }

  /// The list of scenes draws their images beside the names: the icon of the sphere has dark and light pixels.
  void scenesHaveImages() {
    QWidget window;
    strip_->setParent(&window);
    const auto free = qScopeGuard([this] { strip_->setParent(nullptr); });
    window.show();
    QComboBox& scenes = box("Scene");
    scenes.showPopup();
    const QSize rowSize = scenes.view()->visualRect(scenes.model()->index(0, 0)).size();
    const auto spread = [&scenes] {
      const QRect row = scenes.view()->visualRect(scenes.model()->index(1, 0));
      const QImage image =
          scenes.view()->viewport()->grab({row.topLeft(), QSize(row.height(), row.height())}).toImage();
      int least = 255, most = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
          least = std::min(least, qGray(image.pixel(x, y)));
          most = std::max(most, qGray(image.pixel(x, y)));
        }
      return most - least;
    };
    QVERIFY(spread() < 8);  // not rendered yet
    QTRY_VERIFY_WITH_TIMEOUT(spread() > 50, 30000);
    QCOMPARE(scenes.view()->visualRect(scenes.model()->index(0, 0)).size(), rowSize);
    scenes.hidePopup();
  }

  void filesAreAskedFor() {
    QSignalSpy scene(strip_.get(), &ViewStrip::sceneFileRequested);
    QSignalSpy environment(strip_.get(), &ViewStrip::environmentFileRequested);
    choose(box("Scene"), "Mesh or scene...");
    choose(box("Light"), "Image (HDR, EXR)...");
    QCOMPARE(scene.count(), 1);
    QCOMPARE(environment.count(), 1);
    QCOMPARE(box("Scene").currentText(), QString("Sphere"));
    QCOMPARE(box("Light").currentText(), QString("From scene"));
  }

 private:
  QComboBox& box(const QString& label) const { return *test::child<QComboBox>(*strip_, label); }
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
