// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/image_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QImage>
#include <QLineEdit>
#include <QRadioButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "app/gonio/comparison/comparison_controller.h"
#include "core/io/image_io.h"
#include "core/models/registry.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/support/test_program.h"
#include "widgets/preview/comparison_bar.h"
#include "widgets/preview/preview_widget.h"

namespace image_dialog_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

struct Editor {
  QTemporaryDir folder;
  QSettings settings{folder.filePath("settings.ini"), QSettings::IniFormat};
  BackgroundTasks tasks;
  Document document;
  widgets::PreviewWidget preview;
  widgets::ComparisonBar bar;
  ComparisonController comparison{document, tasks, preview, bar};
  FileExports exports{document, tasks};
  QSignalSpy exported{&exports, &FileExports::exported}, failed{&exports, &FileExports::failed};

  Editor() {
    document.setMaterial(glossyMaterial(0.4, HalfDifferenceGrid{20, 20, 20}));
    preview.resize(320, 200);
  }
  std::unique_ptr<ImageDialog> dialog() {
    auto made = std::make_unique<ImageDialog>(
        ImageDialog::Parts{document, exports, tasks, comparison, preview, settings}, "glossy", nullptr);
    made->path().setText(folder.filePath("glossy.png"));
    return made;
  }
  QString path(const QString& name) const { return folder.filePath(name); }
};

bool wait(const std::function<bool()>& done) { return QTest::qWaitFor(done, patienceMilliseconds); }

void choose(QWidget& dialog, const QString& text) {
  for (QComboBox* box : dialog.findChildren<QComboBox*>())
    if (const int index = box->findText(text, Qt::MatchStartsWith); index >= 0) {
      box->setCurrentIndex(index);
      Q_EMIT box->activated(index);
      return;
    }
  QFAIL(qPrintable(text));
}

QSpinBox& field(QWidget& dialog, const QString& name) {
  for (QSpinBox* box : dialog.findChildren<QSpinBox*>())
    if (box->accessibleName().startsWith(name)) return *box;
  return *dialog.findChildren<QSpinBox*>().back();
}

class ImageDialogTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Size and file are those that were asked for; the cost is stated before.
  void rendersAPng() {
    Editor editor;
    const auto dialog = editor.dialog();
    QVERIFY(dialog->rendersPicture());
    choose(*dialog, "Transparent");
    field(*dialog, "Width").setValue(48);
    field(*dialog, "Height").setValue(32);
    QVERIFY(wait([&] { return dialog->estimate().has_value(); }));
    QVERIFY(dialog->estimate()->secondsPerSample > 0 && dialog->estimate()->noisePerSample > 0);
    dialog->accept();
    QVERIFY(wait([&] { return editor.exported.count() == 1; }));
    const QImage picture(editor.path("glossy.png"));
    QCOMPARE(picture.size(), QSize(48, 32));
    QCOMPARE(qAlpha(picture.pixel(0, 0)), 0);
    QCOMPARE(qAlpha(picture.pixel(24, 16)), 255);
  }

  /// The format changes the file's suffix; an EXR has the radiance, here over a colour, without alpha.
  void rendersAnExrOverAColour() {
    Editor editor;
    const auto dialog = editor.dialog();
    choose(*dialog, "OpenEXR");
    choose(*dialog, "Colour");
    QCOMPARE(dialog->path().text(), editor.path("glossy.exr"));
    field(*dialog, "Width").setValue(40);
    field(*dialog, "Height").setValue(40);
    PictureExport picture = dialog->request();
    QVERIFY(picture.isExr() && picture.background == PictureBackground::colour);
    picture.colour = QColor(255, 0, 128);
    picture.limits.samples = 4;
    editor.exports.renderPicture(picture);
    QVERIFY(wait([&] { return editor.exported.count() == 1; }));
    const Image image = io::readImage(editor.path("glossy.exr").toStdString());
    QVERIFY(image.alpha.empty() && image.width == 40);
    QVERIFY(std::abs(image.at(0, 0).x - 1) < 1e-5 && image.at(0, 0).y == 0);
    QVERIFY(std::abs(image.at(0, 0).z - float(fromSrgb(128 / 255.0))) < 1e-5);
  }

  /// An opaque pixel stays, a transparent one is the colour, a half one the mean in linear light.
  void coloursMixInLinearLight() {
    std::vector<std::uint8_t> bytes{10, 20, 30, 255, 10, 20, 30, 0, 255, 255, 255, 128};
    composeOver(QColor(0, 0, 0), std::span(bytes).subspan(8));
    composeOver(QColor(200, 100, 50), std::span(bytes).first(8));
    const std::vector<std::uint8_t> expected{10, 20, 30, 255, 200, 100, 50, 255, 188, 188, 188, 255};
    QCOMPARE(bytes, expected);
  }

  /// What was chosen stands there the next time; "As the preview" is its size.
  void remembersTheChoices() {
    Editor editor;
    {
      const auto dialog = editor.dialog();
      choose(*dialog, "As in preview");
      QCOMPARE(dialog->request().width, 320);
      QCOMPARE(dialog->request().height, 200);
      choose(*dialog, QString::fromUtf8("1920 \u00d7 1080"));
      QCOMPARE(dialog->request().height, 1080);
      field(*dialog, "Width").setValue(50);
      field(*dialog, "Height").setValue(20);
      QVERIFY(dialog->findChildren<QComboBox*>()[0]->currentText() == "Other");
      for (QSpinBox* box : dialog->findChildren<QSpinBox*>())
        if (box->suffix().contains("pixel")) box->setValue(3);
      dialog->findChildren<QCheckBox*>().back()->setChecked(true);
      field(*dialog, "Max. time").setValue(7);
      choose(*dialog, "OpenEXR");
      dialog->accept();
      QVERIFY(wait([&] { return editor.exported.count() == 1; }));
    }
    const PictureExport again = editor.dialog()->request();
    QCOMPARE(again.width, 50);
    QCOMPARE(again.height, 20);
    QCOMPARE(again.limits.samples, 3);
    QCOMPARE(again.limits.seconds, 7.0);
  }

  /// The measured file is never the output, and the dialog stays open.
  void theSourceIsRefused() {
    Editor editor;
    const QString source = editor.path("measured.png");
    QVERIFY(QFile(source).open(QIODevice::WriteOnly));
    auto material = std::make_shared<LoadedMaterial>(*editor.document.material());
    material->material.source.path = source.toStdString();
    editor.document.setMaterial(material);
    const auto dialog = editor.dialog();
    dialog->show();
    dialog->path().setText(source);
    dialog->accept();
    QCOMPARE(editor.failed.count(), 1);
    QVERIFY(dialog->isVisible() && editor.tasks.isIdle());
  }

  /// The numbers of a comparison stand below the picture.
  void aComparisonHasItsNumbers() {
    Editor editor;
    const models::Model& model = models::findModel("ggx");
    editing::DifferentialEdit edit{&model, models::defaultParameters(model.spec()),
                                   models::defaultParameters(model.spec())};
    edit.edited.values[*model.spec().find("roughness")] = Rgb(0.5);
    editor.document.replaceEdits({{edit}}, "edit");
    const FileExports::Caption caption = comparisonCaption(editor.comparison, "glossy");
    const QString text = caption({});
    QVERIFY2(
        text.startsWith("glossy, ") && text.contains("BRDF SNR") && text.contains(" dB") && !text.contains("undefined"),
        qPrintable(text));
    QImage picture(300, 100, QImage::Format_RGB32);
    picture.fill(Qt::gray);
    editor.exports.writePng(editor.path("x.png"), picture, caption);
    QVERIFY(wait([&] { return editor.exported.count() == 1; }));
    const QImage written(editor.path("x.png"));
    QVERIFY(written.width() == 300 && written.height() > 110);
    QCOMPARE(written.pixelColor(150, 50), QColor(Qt::gray));
  }
};

GONIO_TEST(ImageDialogTest)

}  // namespace image_dialog_test

#include "image_dialog_test.moc"
