// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_widget.h"

#include <QFocusEvent>
#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include "core/metrics/image_metrics.h"
#include "core/models/model.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/scene_file.h"
#include "offscreen_context.h"
#include "tests/support/test_program.h"
#include "widgets/preview/false_colour_legend.h"
#include "widgets/preview/gl/scene_uniforms.h"
#include "widgets/preview/picture_drawer.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/split_bar.h"

namespace preview_widget_test {
using namespace gonio;
using namespace gonio::rendering;
using widgets::PreviewContent;
using widgets::PreviewInput;
using widgets::PreviewWidget;
using widgets::Tracing;

std::shared_ptr<const TabulatedBrdf> grey() {
  const models::Model& model = models::findModel("lambert");
  return bakeTable(*model.instantiate(models::defaultParameters(model.spec())));
}
class PreviewWidgetTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    const test::OffscreenContext context;
    if (!context.isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    table_ = grey();
  }

  void init() {
    widget_ = std::make_unique<PreviewWidget>();
    widget_->resize(220, 220);
    content().showScene(openScene("sphere-distant-light"));
    widget_->show();
    QVERIFY(QTest::qWaitForWindowExposed(widget_.get()));
  }
  void cleanup() { widget_.reset(); }

  void emptyStateShowsAHintAndNothingElse() {
    QVERIFY(!content().hasMaterial());
    QVERIFY(!widget_->converged());
    const QImage picture = widget_->grabPicture();
    QCOMPARE(picture.pixel(2, 2), picture.pixel(110, 4));
  }

  /// What is being opened shows its thumbnail above its name, in the empty preview and over the dimmed picture, not
  /// larger than it is; then the picture is as before.
  void whatIsBeingOpenedShowsItsThumbnail() {
    QImage thumbnail(40, 40, QImage::Format_RGB32);
    thumbnail.fill(Qt::red);
    const auto shown = [&] { return widget_->grab().toImage().convertToFormat(QImage::Format_RGB32); };
    const auto reds = [](const QImage& image) {
      int count = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == QColor(Qt::red);
      return count;
    };
    for (const bool isEmpty : {true, false}) {
      if (!isEmpty) {
        content().setSubject(widgets::measuredSubject(table_));
        QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 20000);
      }
      widget_->grabPicture();  // the last one that is drawn
      const QImage before = shown();
      widget_->setLoading("red paint", thumbnail);
      QCOMPARE(reds(shown()), 40 * 40);
      QCOMPARE(shown().pixelColor(110, 70), QColor(Qt::red));
      widget_->setLoading("another");
      QCOMPARE(reds(shown()), 0);
      widget_->setLoading({});
      QVERIFY(shown() == before);
    }
  }

  /// Who hears of a plan may request a picture: both plans are those of the scene, or the shader's objects have no
  /// blockers.
  void plansBelongToTheSceneWhenTheyAreAnnounced() {
    int heard = 0;
    const auto connection = connect(&content(), &PreviewContent::planChanged, this, [&] {
      ++heard;
      const widgets::PictureRequest request = content().request();
      for (const widgets::PictureRequest::Side& side : request.sides)
        QCOMPARE(side.plan.blockers.size(), request.scene.objects.size());
    });
    for (const char* name : {"row", "sphere", "two-spheres"}) content().setScene(openScene(name));
    disconnect(connection);
    QCOMPARE(heard, 3);
  }

  /// The plan of a mesh says what it calls for; OpenGL draws it.
  void aMeshIsDrawn() {
    widget_->setFixedSize(96, 96);
    QSignalSpy planned(&content(), &PreviewContent::planChanged);
    content().showScene(openScene("bowl"));  // first: no picture of another scene may be read
    content().setSubject(widgets::measuredSubject(table_));
    QVERIFY(content().tracing() != Tracing::always && planned.count() > 0);
    QVERIFY(content().plan().simulates(Effect::selfShadowing) && !content().plan().simulates(Effect::castShadows));
    showsSomethingAfter(4);
    QVERIFY(widget_->linearPicture().at(4, 4).x == 0);
  }

  /// Materials that reflect each other are drawn at once and traced at rest, to the end; a change draws again.
  void severalMaterialsAreTracedAtRest() {
    widget_->setFixedSize(96, 96);
    content().setSubject(widgets::measuredSubject(table_));
    content().showScene(openScene("two-spheres", 2));
    const auto other = grey();
    content().setOtherSlotMaterials({{widgets::measuredSubject(other), std::make_shared<const RenderMaterial>(other)}});
    QVERIFY(content().tracing() == Tracing::atRest);
    int drawn = 0, traced = 0;  // frames, samples
    const QObject watch;
    connect(widget_.get(), &PreviewWidget::frameRendered, &watch, [&](double, int samples) {
      if (widget_->showsFilm())
        traced = samples;
      else
        ++drawn;
    });
    // While the hand moves nothing is traced, however long the shader takes to compile.
    QTRY_VERIFY_WITH_TIMEOUT((QTest::keyClick(widget_.get(), Qt::Key_Right), drawn > 0), 60000);
    QTRY_VERIFY_WITH_TIMEOUT(traced >= 16, 20000);
    QVERIFY(widget_->linearPicture().at(widget_->width() / 2, widget_->height() / 2).x > 0.02f);
    drawn = 0;
    QTest::keyClick(widget_.get(), Qt::Key_Right);
    QTRY_VERIFY_WITH_TIMEOUT(drawn > 0, 20000);
    content().setOtherSlotMaterials({});
    QVERIFY(content().tracing() == Tracing::never);
    content().showScene(openScene("sphere"));
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 120000);
  }

  /// Looked at from elsewhere the plan stays; only a lamp that comes into view changes it.
  void orbitingKeepsThePlan() {
    content().showScene(openScene("two-spheres"));
    QSignalSpy planned(&content(), &PreviewContent::planChanged), moved(&content(), &PreviewContent::sceneChanged);
    for (int i = 0; i < 12; ++i) QTest::keyClick(widget_.get(), Qt::Key_Right);
    QCOMPARE(planned.count(), 0);
    QCOMPARE(moved.count(), 12);
    content().showScene(openScene("sphere-under-lamp"));
    planned.clear();
    const EffectPlan before = content().plan();
    for (int i = 0; i < 12; ++i) QTest::keyClick(widget_.get(), Qt::Key_Down);
    Scene scene = content().scene();
    QVERIFY(content().plan() == widgets::previewPlan(scene, content().first().material() ? content().first().material()
                                                                                         : diffuseMaterial(Rgb(0.5))));
    QCOMPARE(planned.count() > 0, !(before == content().plan()));
  }

  /// What the user forces off is gone from the picture and the plan; resetting brings it back.
  void aForcedEffectChangesThePicture() {
    widget_->setFixedSize(96, 96);
    content().showScene(openScene("sphere-point-light"));
    content().setSubject(widgets::measuredSubject(table_));
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 120000);
    const auto shadowed = [&] { return luminance(Rgb(widget_->linearPicture().at(79, 74))); };
    const double inShadow = shadowed();
    EffectOverrides overrides;
    overrides[std::size_t(Effect::castShadows)] = false;
    content().setOverrides(overrides);
    QVERIFY(!content().plan().simulates(Effect::castShadows) && content().plan()[Effect::castShadows].calledFor);
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 120000);
    QVERIFY2(shadowed() > 2 * inShadow, qPrintable(QString("%1 against %2").arg(shadowed()).arg(inShadow)));
  }

  /// Where Tab leads is seen; a click needs no ring.
  void focusByTheKeyboardShowsARing() {
    const auto send = [this](QEvent::Type type, Qt::FocusReason reason) {
      QFocusEvent event(type, reason);
      QCoreApplication::sendEvent(widget_.get(), &event);
      return widget_->overlay()->hasFocusRing();
    };
    QVERIFY(!send(QEvent::FocusIn, Qt::MouseFocusReason));
    QVERIFY(!send(QEvent::FocusOut, Qt::TabFocusReason));
    QVERIFY(send(QEvent::FocusIn, Qt::TabFocusReason));
    QVERIFY(!send(QEvent::FocusOut, Qt::TabFocusReason));
    QVERIFY(send(QEvent::FocusIn, Qt::BacktabFocusReason));
  }

  void controlClickPicksTheViewersAngle() {
    QSignalSpy picked(&widget_->input(), &PreviewInput::polarAnglePicked);
    QTest::mouseClick(widget_.get(), Qt::LeftButton, Qt::ControlModifier, {110, 110});
    QVERIFY(picked.count() == 1 && picked[0][0].toDouble() < 0.01);
    QTest::mouseClick(widget_.get(), Qt::LeftButton, {}, {60, 110});
    QCOMPARE(picked.count(), 1);
    widget_->input().setPicking(true);
    QTest::mouseClick(widget_.get(), Qt::LeftButton, {}, {60, 110});
    QVERIFY(picked.count() == 2 && picked[1][0].toDouble() > 0.3);
    QTest::mouseClick(widget_.get(), Qt::LeftButton, {}, {2, 2});  // beside the sphere
    QCOMPARE(picked.count(), 2);
  }

  void oneSampleIsNotSamples() {
    QCOMPARE(widgets::samplesText(1), QStringLiteral("1 sample"));
    QCOMPARE(widgets::samplesText(64), QStringLiteral("64 samples"));
  }

  void convergesAndThenRests() {
    content().setSubject(widgets::measuredSubject(table_));
    QSignalSpy frames(widget_.get(), &PreviewWidget::frameRendered);
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 60000);
    const auto count = frames.count();
    QTest::qWait(200);
    QCOMPARE(frames.count(), count);
    // A grey ball under a white light: grey in the middle, background in the corner.
    const QColor centre = widget_->grabPicture().pixelColor(110, 110);
    QVERIFY(centre.red() > 60 && centre.red() == centre.green() && centre.green() == centre.blue());
  }

  void dragMovesTheDirectionalLight() {
    content().setSubject(widgets::measuredSubject(table_));
    QSignalSpy changes(&content(), &PreviewContent::sceneChanged);
    const Direction before = content().scene().directionalLights.front().toLight;
    QTest::mousePress(widget_.get(), Qt::LeftButton, {}, {60, 110});
    QTest::mouseRelease(widget_.get(), Qt::LeftButton, {}, {60, 110});
    QVERIFY(changes.count() >= 1);
    QVERIFY(content().scene().directionalLights.front().toLight != before);
    QVERIFY(content().scene().directionalLights.front().toLight.x < 0);
  }

  void keyboardOrbitsZoomsAndResets() {
    content().setSubject(widgets::measuredSubject(table_));
    const double distance = content().scene().camera.distance;
    QTest::keyClick(widget_.get(), Qt::Key_Left);
    QTest::keyClick(widget_.get(), Qt::Key_Up);
    QTest::keyClick(widget_.get(), Qt::Key_Plus);
    QVERIFY(content().scene().camera.yaw > 0);
    QVERIFY(content().scene().camera.pitch < 0);
    QVERIFY(content().scene().camera.distance < distance);
    QTest::keyClick(widget_.get(), Qt::Key_R);
    QCOMPARE(content().scene().camera.yaw, 0.0);
    QCOMPARE(content().scene().camera.distance, distance);
  }

  /// Samples follow the edit: a rough material edited into a mirror is a clean mirror, not a dark one with sparkles.
  void sharpenedHighlightIsSampledWhereItIs() {
    widget_->setFixedSize(96, 96);
    const models::Model& model = models::findModel("ggx");
    editing::DifferentialEdit edit{.model = &model, .fitted = models::defaultParameters(model.spec())};
    edit.edited = edit.fitted;
    edit.edited.values[*model.spec().find("roughness")] = Rgb(0.01);
    const auto rough = bakeTable(*model.instantiate(edit.fitted));
    const Scene scene = comparisonScene();
    content().setScene(scene);
    content().setSubject({widgets::EditedMaterial{rough, {{edit}}}, std::make_shared<const TabulatedDensity>(*rough)});
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 120000);
    const Image shown = widget_->linearPicture();
    const auto edited = editing::applyEdits(rough, editing::EditList{{edit}});
    const Image reference =
        renderPicture(*edited, scene, {.width = shown.width, .height = shown.height, .samples = 256, .seed = 3});
    const double snr = metrics::signalToNoiseRatio(reference, shown);
    QVERIFY2(snr > 25, qPrintable(QString("%1 dB").arg(snr)));
  }

  /// A comparison draws the second subject beside the first, with names; the key shows it whole; off costs no frame
  /// more.
  void comparisonOfTwoSubjects() {
    const auto black = bakeTable(*models::findModel("lambert").instantiate({{Rgb(0)}}));
    content().setSubject(widgets::measuredSubject(table_), "Grey");
    content().setSecond(widgets::measuredSubject(black), "Black");
    content().setComparison({.mode = widgets::CompareMode::split, .split = 0.5});
    QVERIFY(content().isComparing());
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 60000);
    QImage picture = widget_->grabPicture();
    QVERIFY(picture.pixelColor(90, 110).red() > 60 && picture.pixelColor(130, 110).red() < 10);
    QCOMPARE(widget_->overlay()->name(0)->text(), "Grey");
    QCOMPARE(widget_->overlay()->name(1)->text(), "Black");
    widget_->setFlickering(true);
    QVERIFY(widget_->grabPicture().pixelColor(90, 110).red() < 10);
    QCOMPARE(widget_->overlay()->name(0)->text(), "Black");
    widget_->setFlickering(false);
    content().setComparison({});
    QVERIFY(!content().isComparing() && widget_->converged());
    QVERIFY(widget_->grabPicture().pixelColor(130, 110).red() > 60);
    QVERIFY(!widget_->overlay()->name(0)->isVisible());
  }

  /// The bar follows the mouse and the keys, and states its position.
  void splitBarMoves() {
    content().setSubject(widgets::measuredSubject(table_), "A");
    content().setSecond(widgets::measuredSubject(table_), "B");
    content().setComparison({.mode = widgets::CompareMode::split, .split = 0.5});
    QSignalSpy moves(widget_.get(), &PreviewWidget::splitMoved);
    widgets::SplitBar* bar = widget_->overlay()->splitBar();
    QVERIFY(bar->isVisible());
    const QPoint middle(bar->width() / 2, bar->height() / 2);
    QTest::mousePress(bar, Qt::LeftButton, {}, middle);
    QTest::mouseMove(bar, middle + QPoint(44, 0));
    QTest::mouseRelease(bar, Qt::LeftButton, {}, bar->rect().center());
    QVERIFY(std::abs(content().comparison().split - 0.7) < 0.02);
    QTest::keyClick(bar, Qt::Key_Left);
    QVERIFY(std::abs(content().comparison().split - 0.68) < 0.02);
    QTest::keyClick(bar, Qt::Key_Home);
    QCOMPARE(content().comparison().split, 0.5);
    QVERIFY(moves.count() >= 3);
    // The focus of a bar that disappears is the preview's, not that of the next widget.
    widget_->activateWindow();
    bar->setFocus();
    QTRY_VERIFY(bar->hasFocus());
    content().setComparison({});
    QVERIFY(!bar->isVisible() && widget_->hasFocus());
  }

  /// The legend states the range of the colours: 0.18 against black is a difference of at most 0.18 here.
  void differenceFindsItsRange() {
    const auto black = bakeTable(*models::findModel("lambert").instantiate({{Rgb(0)}}));
    content().setSubject(widgets::measuredSubject(table_), "Grey");
    content().setSecond(widgets::measuredSubject(black), "Black");
    content().setComparison({.mode = widgets::CompareMode::difference});
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 60000);
    const double found = widget_->differenceRange();
    QVERIFY2(found >= 0.1 && found <= 1, qPrintable(QString::number(found)));
    QCOMPARE(widget_->overlay()->legend()->range(), found);
    QVERIFY(widget_->overlay()->legend()->isVisible());
    content().setComparison({.mode = widgets::CompareMode::difference, .range = 0.25});
    widget_->grabPicture();
    QCOMPARE(widget_->differenceRange(), 0.25);
  }

  /// While shaders are compiled and tables uploaded, the picture before stays, and the status states why.
  void thePictureStaysUntilTheNextOneIsDone() {
    const auto status = [&] {
      QStringList texts;
      for (const QLabel* label : widget_->findChildren<QLabel*>()) texts << label->text();
      return texts.join('\n');
    };
    content().setSubject(widgets::measuredSubject(table_));
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 60000);
    QSignalSpy frames(widget_.get(), &PreviewWidget::frameRendered);
    const models::Model& model = models::findModel("cook-torrance");
    bool hasReason = false;
    content().setSubject({widgets::StandaloneModel{&model, models::defaultParameters(model.spec())}});
    while (frames.isEmpty()) {
      QVERIFY(widget_->picture().pixelColor(110, 110).red() > 60);
      QTest::qWait(1);
      hasReason = hasReason || status().contains("Compiling");
    }
    QVERIFY(hasReason);
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 60000);
    QVERIFY(!status().contains("Compiling"));
  }

  /// A shader that does not compile is reported, and the next one is drawn.
  void aFailureIsToldAndNotForEver() {
    QSignalSpy failures(widget_.get(), &PreviewWidget::failed);
    const models::Model &ward = models::findModel("ward"), &ggx = models::findModel("ggx");
    qputenv("GONIO_SHADER_DIR", "/nowhere");
    content().setSubject({widgets::StandaloneModel{&ward, models::defaultParameters(ward.spec())}});
    QTRY_COMPARE_WITH_TIMEOUT(failures.count(), 1, 20000);
    QVERIFY(failures[0][0].toString().contains("/nowhere"));
    // It fails once more, which the widget only hears when something else is shown.
    widget_->setExposure(1);
    QThread::msleep(500);
    qunsetenv("GONIO_SHADER_DIR");
    content().setSubject({widgets::StandaloneModel{&ggx, models::defaultParameters(ggx.spec())}});
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 60000);
    QCOMPARE(failures.count(), 1);
  }

  /// A dock that floats gives the widget another window, and with it another context.
  void anotherWindowShowsThePictureAgain() {
    content().setSubject(widgets::measuredSubject(table_));
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 60000);
    QWidget window;
    window.resize(260, 260);
    widget_->setParent(&window);
    widget_->show();
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QTRY_VERIFY_WITH_TIMEOUT(widget_->picture().pixelColor(widget_->rect().center()).red() > 60, 20000);
    widget_->setParent(nullptr);
  }

  /// Taking the material away shows the empty state again, never a stale picture.
  void materialCanBeTakenAway() {
    content().setSubject(widgets::measuredSubject(table_));
    QTRY_VERIFY_WITH_TIMEOUT(widget_->converged(), 60000);
    content().setSubject({});
    QTest::qWait(50);
    const QImage picture = widget_->grabPicture();
    QCOMPARE(picture.pixel(110, 110), picture.pixel(2, 2));
  }

 private:
  PreviewContent& content() { return widget_->content(); }

  void showsSomethingAfter(int samples) {
    QSignalSpy rendered(widget_.get(), &PreviewWidget::frameRendered);
    QTRY_VERIFY_WITH_TIMEOUT(!rendered.isEmpty() && rendered.last()[1].toInt() >= samples, 20000);
    // So many samples may be those of a coarse picture, and the first sample of a fine one may lie in a shadow.
    const auto isLit = [this](const Image& picture) {
      return picture.width == widget_->width() && picture.at(picture.width / 2, picture.height / 2).x > 0.02f;
    };
    // Once is enough: QTRY reads again after its loop, and a further sample may lie in a shadow.
    bool lit = false;
    QTRY_VERIFY_WITH_TIMEOUT(lit = lit || isLit(widget_->linearPicture()), 60000);
  }

  std::shared_ptr<const TabulatedBrdf> table_;
  std::unique_ptr<PreviewWidget> widget_;
};

GONIO_TEST(PreviewWidgetTest)
}  // namespace preview_widget_test

#include "preview_widget_test.moc"
