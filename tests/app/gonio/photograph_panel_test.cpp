// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/photograph_panel.h"

#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/acquisition/photograph_controls.h"
#include "app/gonio/acquisition/photograph_views.h"
#include "app/gonio/matching/reference_view.h"
#include "core/io/image_io.h"
#include "core/rendering/environment.h"
#include "tests/app/gonio/acquisition_test_support.h"
#include "tests/support/test_program.h"
#include "tests/widgets/child.h"
#include "widgets/acquisition/residual_view.h"
#include "widgets/acquisition/uncertainty_curve.h"
#include "widgets/inputs/number_field.h"

namespace photograph_panel_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

constexpr int side = 64;
/// The camera looks at the sphere from above and from the right.
const char* const descriptionText = R"({"format": "gonio photographs", "version": 1, "exposure": "known", "images": [
  {"file": "front.exr", "width": 64, "height": 64, "camera": {"position": [1, 0.5, 3.8]}, "lights": [{"environment": "studio", "rotation": 30}]}]})";

/// The panel with photographs of a material of the training set.
struct Editor {
  SmallLibrary library;
  BackgroundTasks tasks;
  Document document;
  AcquisitionPanel acquisition{document, tasks};
  PhotographPanel panel{acquisition, tasks};
  PhotographSession& session = panel.session();
  QSignalSpy failed{&panel, &PhotographPanel::failed};

  Editor() {
    QObject::connect(&acquisition, &AcquisitionPanel::materialMade, &document, &Document::replaceMaterial);
    acquisition.controls().training().setTraining(library.training);
    constexpr std::size_t fewRegions = 250;
    session.setQuality(fewRegions, smallPicture());
    panel.resize(1200, 480);
    panel.show();
  }
  QString path(const QString& name) const { return library.folder.filePath(name); }
  void writeText(const QString& name, const QByteArray& text) const {
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
  }
  photograph::Photograph described() const {
    return photograph::parseDescription(descriptionText, {}, false).set.photographs.front();
  }
  Image rendered() const {
    const auto material = materials::readMaterial(library.training.ids[3].toStdString());
    return rendering::renderPicture(*material.brdf, photograph::sceneOf(described(), side, side),
                                    {.width = side, .height = side, .samples = 32, .density = {}});
  }
  void write(const QString& name, const Image& image) const { io::writeExr(image, path(name).toStdString()); }
  bool settle() {
    return QTest::qWaitFor([&] { return tasks.isIdle() && panel.isSettled(); }, patienceMilliseconds);
  }
  bool open(const QStringList& names) {
    QStringList paths;
    for (const QString& name : names) paths << path(name);
    session.open(paths);
    return settle();
  }
  /// A description of one photograph, opened.
  bool openDescription() {
    write("front.exr", rendered());
    writeText("photographs.json", descriptionText);
    return open({"photographs.json"});
  }
  bool reconstruct() {
    panel.startButton().click();
    return settle() && session.result();
  }
  widgets::NumberField& field(const QString& name) const {
    return *test::child<widgets::NumberField>(panel.controls(), name);
  }
  QComboBox& box(const QString& name) const { return *test::child<QComboBox>(panel.controls(), name); }
  QPushButton& button(const QString& name) const { return *test::child<QPushButton>(panel, name); }
  static void enter(widgets::NumberField& field, const char* text) {
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
  }
  static void choose(QComboBox& box, int index) {
    box.setCurrentIndex(index);
    Q_EMIT box.activated(index);
  }
  QString failure() { return failed.isEmpty() ? QString() : failed.takeLast()[1].toString(); }
};

/// Of an outline that is found in an image of this size, pixels.
constexpr double smallImageError = 1;

bool isNear(const matching::Disc& one, const matching::Disc& other, double pixels) {
  return std::abs(one.x - other.x) < pixels && std::abs(one.y - other.y) < pixels &&
         std::abs(one.radius - other.radius) < pixels;
}

class PhotographPanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void anEmptyPanelSaysWhatToDo() {
    Editor editor;
    QVERIFY(editor.button("Open Photographs...").isVisible());
    QVERIFY(!editor.panel.views().isVisible());
    for (const char* name : {"Reconstruct", "Remove", "Save Description", "Find"})
      QVERIFY2(!editor.button(name).isEnabled(), name);
    QCOMPARE(editor.panel.status(), "Open photographs to begin.");
  }

  void aDescriptionIsShown() {
    Editor editor;
    QVERIFY(editor.openDescription());
    QVERIFY2(editor.failed.isEmpty(), qPrintable(editor.failure()));
    QVERIFY(editor.panel.views().isVisible());
    const photograph::Photograph expected = editor.described();
    const PhotographItem& item = editor.session.inputs()[0];
    QCOMPARE(item.path(), editor.path("front.exr"));
    QVERIFY(isNear(item.disc(), photograph::discOf(expected.camera, side, side), 1e-9));
    QVERIFY(std::abs(editor.field("Camera distance").value() - expected.camera.distance) < 1e-9);
    QVERIFY(std::abs(editor.field("Camera azimuth").value() - expected.camera.yaw) < 1e-9);
    QVERIFY(std::abs(editor.field("Camera elevation").value() - expected.camera.pitch) < 1e-9);
    QCOMPARE(editor.box("Environment").currentText(), "Studio");
    QVERIFY(std::abs(editor.field("Rotation").value() - radians(30)) < 1e-9);
    QVERIFY(editor.button("Reconstruct").isEnabled());
  }

  /// An image without a description: its sphere is found, and the light is that of the image before.
  void theOutlineOfAnImageIsFound() {
    Editor editor;
    QVERIFY(editor.openDescription());
    editor.write("second.exr", editor.rendered());
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(editor.path("second.exr"))});
    QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&editor.panel, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&editor.panel, &drop);
    QVERIFY(editor.settle());
    QVERIFY2(editor.session.inputs().size() == 2, qPrintable(editor.failure()));
    const PhotographItem &first = editor.session.inputs()[0], &second = editor.session.inputs()[1];
    QVERIFY(isNear(second.disc(), first.disc(), smallImageError));
    QVERIFY(second.light() == first.light() && second.camera() == first.camera());
    auto& strip = *editor.panel.findChild<QListWidget*>();
    QVERIFY(strip.isVisible());
    QCOMPARE(strip.count(), 2);
    strip.setCurrentRow(1);
    QCOMPARE(editor.panel.views().current(), 1);
    editor.button("Remove").click();
    QCOMPARE(editor.session.inputs().size(), std::size_t(1));
    QVERIFY(!strip.isVisible());
    QCOMPARE(editor.panel.views().current(), 0);
  }

  /// The inside of the circle moves it, its rim resizes it; the numbers follow, and set it too.
  void theOutlineIsCorrected() {
    Editor editor;
    QVERIFY(editor.openDescription());
    const auto disc = [&] { return editor.session.inputs()[0].disc(); };
    ReferenceView& view = editor.panel.views().outline();
    const auto drag = [&](const QPointF& from, const QPointF& to) {
      QTest::mousePress(&view, Qt::LeftButton, {}, view.toWidget(from).toPoint());
      QTest::mouseMove(&view, view.toWidget(to).toPoint());
      QTest::mouseRelease(&view, Qt::LeftButton, {}, view.toWidget(to).toPoint());
    };
    const matching::Disc before = disc();
    drag({before.x, before.y}, {before.x + 5, before.y - 3});
    constexpr double pixel = 0.3;  // of the widget
    QVERIFY(isNear(disc(), {before.x + 5, before.y - 3, before.radius}, pixel));
    const matching::Disc moved = disc();
    drag({moved.x + moved.radius, moved.y}, {moved.x + moved.radius - 4, moved.y});
    QVERIFY(isNear(disc(), {moved.x, moved.y, moved.radius - 4}, pixel));
    QCOMPARE(editor.field("Radius").value(), disc().radius);
    Editor::enter(editor.field("Centre x"), "30.5");
    QCOMPARE(disc().x, 30.5);
    QVERIFY(isNear({view.toWidget({30.5, disc().y}).x(), 0, 0}, {view.width() / 2.0, 0, 0}, 1e-6));
    editor.button("Find").click();
    QVERIFY(editor.settle());
    QVERIFY2(isNear(disc(), before, smallImageError), qPrintable(editor.failure()));
  }

  void reconstructsAndOpens() {
    Editor editor;
    QVERIFY(editor.openDescription());
    QVERIFY2(editor.reconstruct(), qPrintable(editor.failure()));
    const PhotographResult& result = *editor.session.result();
    QVERIFY2(result.fit.residualSnr[0] > 25, QByteArray::number(result.fit.residualSnr[0]));
    QVERIFY(!editor.panel.views().residual().map().isNull());
    QVERIFY(!result.spheres[0].isNull() && !editor.session.otherSphere().isNull());
    QCOMPARE(result.lights[0], "Studio");
    const auto& points = editor.panel.findChild<widgets::UncertaintyCurve*>()->points();
    QVERIFY(points.size() > 10);
    for (const auto& point : points) QVERIFY(point.low <= point.median && point.median <= point.high && point.low >= 0);
    QVERIFY(editor.panel.findChild<QLabel*>("checks")->text().contains("outline x"));
    editor.button("Open as Material").click();
    QVERIFY(editor.settle());
    QVERIFY(editor.document.name().startsWith("front from one photograph"));
    QVERIFY(editor.document.history().canUndo());
    // The inputs and the result stay; a change of the input is stated.
    QVERIFY(editor.session.isResultCurrent());
    Editor::enter(editor.field("Radius"), "20");
    QCOMPARE(editor.panel.status(), "The input has changed. Press Reconstruct again.");
    QVERIFY(editor.session.result());
  }

  /// Shapes without an outline: the image, its residual and the reconstruction are shown, and only what applies is
  /// asked.
  void otherShapesHaveNoOutline() {
    Editor editor;
    const QByteArray text =
        QByteArray(descriptionText)
            .replace("\"camera\"", "\"shape\": {\"flat\": {\"normal\": [0.4, 0.2, 1], \"radius\": 0.9}}, \"camera\"");
    const auto material = materials::readMaterial(editor.library.training.ids[3].toStdString());
    const auto set = photograph::parseDescription(text.toStdString(), {}, false).set;
    editor.write("front.exr",
                 rendering::renderPicture(*material.brdf, photograph::sceneOf(set.photographs[0], side, side),
                                          {.width = side, .height = side, .samples = 32, .density = {}}));
    editor.writeText("photographs.json", text);
    QVERIFY(editor.open({"photographs.json"}));
    QVERIFY2(editor.failed.isEmpty(), qPrintable(editor.failure()));
    QVERIFY(!editor.field("Centre x").isVisible() && !editor.field("Radius").isVisible() &&
            !editor.button("Find").isVisible());
    QCOMPARE(editor.panel.status(), "Check camera and light of each photograph, then press Reconstruct.");
    // The mouse moves nothing.
    ReferenceView& view = editor.panel.views().outline();
    const std::string before = editor.session.inputs().description();
    QTest::mousePress(&view, Qt::LeftButton, {}, view.rect().center());
    QTest::mouseMove(&view, view.rect().center() + QPoint(9, 5));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, view.rect().center() + QPoint(9, 5));
    QCOMPARE(editor.session.inputs().description(), before);
    QVERIFY2(editor.reconstruct(), qPrintable(editor.failure()));
    const PhotographResult& result = *editor.session.result();
    QVERIFY2(result.fit.residualSnr[0] > 25, QByteArray::number(result.fit.residualSnr[0]));
    QVERIFY(!editor.panel.findChild<QLabel*>("checks")->text().contains("outline"));
    // The map covers the image: the disc in its middle, nothing in its corners.
    const QImage& map = editor.panel.views().residual().map();
    QVERIFY(map.pixelColor(map.width() / 2, map.height() / 2).alpha() > 0);
    QCOMPARE(map.pixelColor(2, 2).alpha(), 0);
    // A further image is one of the same shape; a sphere shows the outline again.
    editor.write("second.exr", editor.rendered());
    QVERIFY(editor.open({"second.exr"}));
    QVERIFY2(editor.session.inputs().size() == 2, qPrintable(editor.failure()));
    QVERIFY(!editor.session.inputs()[1].hasOutline() && editor.session.inputs()[1].isOutlineFound);
    QVERIFY(editor.openDescription());
    QVERIFY(editor.field("Radius").isVisible());
  }

  /// Where the photograph is brighter than the reconstruction, the map is orange: red above blue.
  void theResidualHasASign() {
    Editor editor;
    Image image = editor.rendered();
    const matching::Disc disc = photograph::discOf(editor.described().camera, side, side);
    constexpr int left = -10, top = 8, size = 7;  // from the centre
    for (int y = top; y < top + size; ++y)
      for (int x = left; x < left + size; ++x) image.at(int(disc.x) + x, int(disc.y) + y) *= 2.5f;
    editor.write("front.exr", image);
    editor.writeText("photographs.json", descriptionText);
    QVERIFY(editor.open({"photographs.json"}) && editor.reconstruct());
    const QImage& map = editor.panel.views().residual().map();
    const auto at = [&](double x, double y) {
      const double extent = widgets::ResidualView::mapExtent * disc.radius;
      return map.pixelColor(int((x / extent + 1) * map.width() / 2), int((y / extent + 1) * map.height() / 2));
    };
    const QColor bright = at(left + 0.5 * size, top + 0.5 * size);
    QVERIFY2(bright.red() > bright.blue() + 50, qPrintable(bright.name()));
    QCOMPARE(at(1.02 * disc.radius, 0).alpha(), 0);
    QVERIFY(editor.panel.views().residual().range() >= 0.2);
  }

  void canBeCancelled() {
    Editor editor;
    QVERIFY(editor.openDescription());
    editor.panel.startButton().click();
    QCOMPARE(editor.panel.startButton().text(), "Cancel");
    editor.panel.startButton().click();
    QVERIFY(editor.settle());
    QVERIFY(!editor.session.result() && editor.session.inputs().size() == 1);
    QVERIFY(editor.failed.isEmpty());
    QVERIFY(editor.reconstruct());
  }

  /// Errors name the file, what was found and what was expected; what was open stays.
  void wrongFilesAreRefused() {
    Editor editor;
    QVERIFY(editor.openDescription());
    QImage(16, 16, QImage::Format_RGB32).save(editor.path("photo.png"));
    editor.writeText("broken.json", "{\"format\": ");
    editor.writeText("scene.json", R"({"format": "other", "version": 1, "images": []})");
    editor.writeText("missing.json", QByteArray(descriptionText).replace("front.exr", "nowhere.exr"));
    const std::pair<const char*, QStringList> wrong[] = {{"photo.png", {"photo.png", "found", "expected"}},
                                                         {"nowhere.exr", {"nowhere.exr"}},
                                                         {"broken.json", {"broken.json"}},
                                                         {"scene.json", {"scene.json", "found", "expected"}},
                                                         {"missing.json", {"nowhere.exr"}}};
    for (const auto& [name, stated] : wrong) {
      QVERIFY(editor.open({name}));
      const QString failure = editor.failure();
      for (const QString& one : stated) QVERIFY2(failure.contains(one), qPrintable(QString(name) + ": " + failure));
      QCOMPARE(editor.session.inputs().size(), std::size_t(1));
    }
    // An environment that cannot be read changes nothing.
    PhotographLight light = editor.session.inputs()[0].light();
    light.environment = editor.path("nowhere.hdr");
    editor.session.setLight(0, light);
    QVERIFY(editor.settle());
    QVERIFY(editor.failure().contains("nowhere.hdr"));
    QCOMPARE(editor.session.inputs()[0].light().environment, "studio");
  }

  /// A saved description has what the panel shows, and the program reads it.
  void theDescriptionIsSaved() {
    Editor editor;
    QVERIFY(editor.openDescription());
    Editor::choose(editor.box("Light"), int(PhotographLight::Kind::distant));
    Editor::enter(editor.field("Light azimuth"), "90");
    Editor::enter(editor.field("Light elevation"), "30");
    Editor::enter(editor.field("Irradiance"), "2");
    Editor::choose(editor.box("Exposure"), 1);
    editor.session.setDisc(0, {31, 33, 25});
    QSignalSpy exported(&editor.panel, &PhotographPanel::exported);
    const QString path = editor.path("saved.json");
    editor.session.saveDescription(path);
    QCOMPARE(exported.count(), 1);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly) && file.readAll().contains("\"file\": \"front.exr\""));
    const photograph::PhotographSet set = photograph::readDescription(path.toStdString()).set;
    QVERIFY(!set.exposureKnown);
    QVERIFY(set.photographs[0].disc == matching::Disc(31, 33, 25));
    QVERIFY(!set.photographs[0].light.environment);
    const auto& light = set.photographs[0].light.directional.at(0);
    const Direction expected{std::cos(radians(30)), std::sin(radians(30)), 0};
    QVERIFY(glm::length(light.toLight - expected) < 1e-9);
    QCOMPARE(light.irradiance, Rgb(2));
    const std::string before = editor.session.inputs().description();
    QVERIFY(editor.open({"saved.json"}));
    QCOMPARE(editor.session.inputs().description(), before);
    editor.session.saveDescription("/nowhere/photographs.json");
    QVERIFY(editor.failure().contains("/nowhere/photographs.json"));
  }

  /// Lights that the panel cannot edit stay, and come back after another choice.
  void describedLightsStay() {
    Editor editor;
    editor.write("front.exr", editor.rendered());
    const QByteArray two = R"([{"environment": "sky"}, {"position": [0, 4, 0], "intensity": [1, 2, 3]}])";
    editor.writeText("photographs.json",
                     QByteArray(descriptionText).replace(R"([{"environment": "studio", "rotation": 30}])", two));
    QVERIFY(editor.open({"photographs.json"}));
    QVERIFY2(editor.failed.isEmpty(), qPrintable(editor.failure()));
    const std::string before = editor.session.inputs().description();
    QCOMPARE(editor.box("Light").currentText(), "As described");
    Editor::choose(editor.box("Light"), int(PhotographLight::Kind::environment));
    QVERIFY(editor.settle());
    QCOMPARE(editor.box("Environment").currentText(), "Studio");
    Editor::choose(editor.box("Light"), int(PhotographLight::Kind::other));
    QCOMPARE(editor.session.inputs().description(), before);
  }
};

GONIO_TEST(PhotographPanelTest)
}  // namespace photograph_panel_test

#include "photograph_panel_test.moc"
