// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/matching/reference_panel.h"

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <cmath>
#include <memory>

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/document/document_controller.h"
#include "app/gonio/document/edit_steps.h"
#include "app/gonio/matching/match_controller.h"
#include "app/gonio/matching/reference_view.h"
#include "core/rendering/render_picture.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/support/test_program.h"
#include "widgets/preview/comparison_bar.h"
#include "widgets/preview/preview_widget.h"

namespace reference_panel_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;
using editing::ArtistControl;

struct Editor {
  Document document;
  BackgroundTasks tasks;
  DocumentController controller{document, tasks};
  widgets::PreviewWidget preview;
  widgets::ComparisonBar bar;
  ComparisonController comparison{document, tasks, preview, bar};
  MatchController match{document, controller, tasks, comparison, preview};
  ReferencePanel panel{match, document, preview};

  Editor() {
    preview.resize(400, 300);
    preview.content().setViewport({400, 300});  // as when it is shown
    preview.content().showScene(rendering::comparisonScene());
  }
  /// A glossy material with an edit of its own model.
  void openMaterial() {
    document.setMaterial(glossyMaterial(0.25, {30, 30, 30}));
    fitting::FitResult fit;
    fit.model = &models::findModel("ggx");
    fit.parameters = models::defaultParameters(fit.model->spec());
    fit.parameters.values[*fit.model->spec().find("roughness")] = Rgb(0.25);
    fit.parameters.values[*fit.model->spec().find("specular")] = Rgb(0.9, 0.6, 0.3);
    document.adoptFit(fit);
  }
  double value(ArtistControl control) const { return modelEdit(document)->controls.values[std::size_t(control)].x; }
  QPushButton* button(const QString& text) const {
    for (QPushButton* one : panel.findChildren<QPushButton*>())
      if (one->text() == text && !one->isHidden()) return one;
    return nullptr;
  }
  QString text() const {
    QStringList texts;
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (!label->isHidden()) texts << label->text();
    return texts.join('\n');
  }
};

class ReferencePanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() { editor_ = std::make_unique<Editor>(); }
  void cleanup() { editor_.reset(); }

  void itIsHiddenWithoutAnImage() {
    QVERIFY(editor_->panel.isHidden());
    open(write("plain.png", roughSphere(1)));
    QVERIFY(!editor_->panel.isHidden());
    QVERIFY(editor_->text().contains("plain.png"));
    QVERIFY(editor_->text().contains("Open a material"));
    QVERIFY(!editor_->button("Match")->isEnabled());
    editor_->match.remove();
    QVERIFY(editor_->panel.isHidden());
  }

  /// The sphere has the size of the ball in the preview, in its middle.
  void theSphereHasTheSizeOfTheBall() {
    open(write("plain.png", roughSphere(1)));
    const auto& disc = *editor_->match.image()->found;
    const QPointF centre = editor_->panel.view().toWidget({disc.x, disc.y});
    const QPointF rim = editor_->panel.view().toWidget({disc.x + disc.radius, disc.y});
    QCOMPARE(centre, QPointF(editor_->panel.view().width(), editor_->panel.view().height()) / 2);
    // Half the height of the picture times the ball's outline relative to it.
    const double expected = 150 / std::sqrt(15.0) / std::tan(0.55 / 2);
    QVERIFY(std::abs(rim.x() - centre.x() - expected) < 1e-6);
  }

  void takingIsOneStep() {
    editor_->openMaterial();
    const int steps = editor_->document.history().count();
    open(write("rough.png", roughSphere(2)));
    proposeMatch();
    QCOMPARE(editor_->document.history().count(), steps);
    QCOMPARE(editor_->value(ArtistControl::roughness), 1.0);
    QVERIFY(editor_->comparison.standIn() == StandIn::match);
    QVERIFY(editor_->text().contains("dB"));
    editor_->button("Take")->click();
    QVERIFY(!editor_->comparison.standIn());
    QCOMPARE(editor_->document.history().count(), steps + 1);
    QCOMPARE(editor_->document.history().undoText(), QStringLiteral("Match reference image"));
    QVERIFY(std::abs(editor_->value(ArtistControl::roughness) - 2) < 0.1);
    editor_->document.history().undo();
    QCOMPARE(editor_->value(ArtistControl::roughness), 1.0);
  }

  void leavingChangesNothing() {
    editor_->openMaterial();
    setControl(editor_->document, ArtistControl::contrast, Rgb(1.5));
    const editing::EditList before = editor_->document.edits();
    const int steps = editor_->document.history().count();
    open(write("rough.png", roughSphere(2)));
    proposeMatch();
    editor_->comparison.dismissStandIn();  // as Escape does
    editor_->match.leave();
    QVERIFY(!editor_->match.proposal() && !editor_->comparison.standIn());
    QVERIFY(editor_->document.edits() == before);
    QCOMPARE(editor_->document.history().count(), steps);
    QVERIFY(editor_->button("Match")->isEnabled());
  }

  /// Changes of the document end a proposal and a running match.
  void changesOfTheDocumentLeaveIt() {
    editor_->openMaterial();
    open(write("rough.png", roughSphere(2)));
    proposeMatch();
    setControl(editor_->document, ArtistControl::roughness, Rgb(1.2));
    QVERIFY(!editor_->match.proposal() && !editor_->comparison.standIn());
    editor_->match.match();
    QVERIFY(editor_->match.isMatching());
    setControl(editor_->document, ArtistControl::roughness, Rgb(1.3));
    QVERIFY(!editor_->match.isMatching());
    QVERIFY(QTest::qWaitFor([this] { return editor_->tasks.isIdle(); }, patienceMilliseconds));
    QVERIFY(!editor_->match.proposal());
  }

  void itCanBeCancelled() {
    editor_->openMaterial();
    open(write("rough.png", roughSphere(2)));
    editor_->button("Match")->click();
    editor_->button("Cancel")->click();
    QVERIFY(!editor_->match.isMatching());
    QVERIFY(editor_->button("Match"));
    QVERIFY(QTest::qWaitFor([this] { return editor_->tasks.isIdle(); }, patienceMilliseconds));
    QVERIFY(!editor_->match.proposal());
  }

  /// Without an edit, the default model is fitted first.
  void aModelIsFittedFirst() {
    editor_->document.setMaterial(glossyMaterial(0.25, {30, 30, 30}));
    open(write("rough.png", roughSphere(2)));
    QVERIFY(editor_->text().contains("Match fits a model first"));
    proposeMatch();
    editor_->match.take();
    QVERIFY(editor_->value(ArtistControl::roughness) > 1.5);
  }

  /// The circle is dragged by its outline and by its inside.
  void theCircleCanBeDragged() {
    open(write("plain.png", roughSphere(1)));
    ReferenceView& view = editor_->panel.view();
    view.resize(300, 300);
    const matching::Disc before = editor_->match.image()->disc;
    const double scale = (view.toWidget({1, 0}) - view.toWidget({0, 0})).x();
    const QPoint centre = view.toWidget({before.x, before.y}).toPoint();
    const QPoint rim = centre + QPoint(int(std::lround(scale * before.radius)), 0);
    drag(centre, centre + QPoint(10, 5));
    QVERIFY(std::abs(editor_->match.image()->disc.x - before.x - 10 / scale) < 1e-6);
    QCOMPARE(editor_->match.image()->disc.radius, before.radius);
    // The sphere is in the middle again.
    drag(rim, rim - QPoint(20, 0));
    QVERIFY(std::abs(editor_->match.image()->disc.radius - (before.radius - 20 / scale)) < 1.5 / scale);
  }

  void whatCannotBeReadIsReported() {
    QSignalSpy failed(&editor_->match, &MatchController::failed);
    QFile file(folder_.filePath("no.png"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("not an image");
    file.close();
    editor_->match.open(file.fileName());
    QVERIFY(QTest::qWaitFor([&] { return failed.count() == 1; }, patienceMilliseconds));
    QVERIFY(editor_->panel.isHidden());
    QImage plain(64, 64, QImage::Format_RGB32);
    plain.fill(Qt::gray);
    open(write("grey.png", plain));
    QVERIFY(!editor_->match.image()->found);
    editor_->openMaterial();
    QVERIFY(editor_->text().contains("No sphere was found"));
  }

 private:
  /// The material of openMaterial() with another roughness, as goniotool writes it.
  static QImage roughSphere(double factor) {
    Editor other;
    other.openMaterial();
    setControl(other.document, ArtistControl::roughness, Rgb(factor));
    const auto brdf = editing::applyEdits(other.document.base(), other.document.edits());
    const Image image = rendering::renderPicture(
        *brdf, rendering::comparisonScene(), {.width = 128, .height = 128, .samples = 64, .seed = 3, .density = {}});
    const auto bytes = rendering::toDisplayBytes(image, 0, rendering::ToneMap::clamp);
    return QImage(bytes.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
  }
  QString write(const QString& name, const QImage& image) {
    const QString path = folder_.filePath(name);
    image.save(path);
    return path;
  }
  void open(const QString& path) {
    editor_->match.open(path);
    QVERIFY(QTest::qWaitFor([&] { return editor_->match.image() && editor_->match.image()->path == path; },
                            patienceMilliseconds));
  }
  void proposeMatch() {
    editor_->button("Match")->click();
    QVERIFY(QTest::qWaitFor([this] { return editor_->match.proposal().has_value(); }, patienceMilliseconds));
  }
  void drag(const QPoint& from, const QPoint& to) {
    ReferenceView& view = editor_->panel.view();
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    QTest::mouseMove(&view, to);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  }

  QTemporaryDir folder_;
  std::unique_ptr<Editor> editor_;
};

GONIO_TEST(ReferencePanelTest)
}  // namespace reference_panel_test

#include "reference_panel_test.moc"
