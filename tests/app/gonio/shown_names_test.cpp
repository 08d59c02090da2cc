// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/support/hostile_names.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QToolTip>

#include "app/gonio/comparison/reference_dialog.h"
#include "app/gonio/document/edit_steps.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/export/batch_dialog.h"
#include "app/gonio/export/export_dialog.h"
#include "app/gonio/export/image_dialog.h"
#include "app/gonio/figures/figure_dialog.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/study/study_window.h"
#include "app/gonio/window/dock_layout.h"
#include "app/gonio/window/main_window.h"
#include "app/gonio/window/preferences.h"
#include "app/gonio/window/theme.h"
#include "core/models/model.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/support/test_program.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/library/library_view.h"
#include "widgets/panels/message_bar.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/preview_widget.h"

namespace shown_names_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::documents;
using namespace gonio::app;

/// Whether HTML shows an image other than one that it contains itself, or a heading.
bool isForeign(const QString& html) {
  QTextDocument document;
  document.setHtml(html);
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() > 0) return true;
    for (auto part = block.begin(); !part.atEnd(); ++part) {
      const QTextCharFormat format = part.fragment().charFormat();
      if (format.isAnchor()) return true;
      if (format.isImageFormat() && !format.toImageFormat().name().startsWith("data:image/png;base64,")) return true;
    }
  }
  return false;
}

QString described(const QWidget& widget, const QString& text) {
  QStringList place;
  for (const QWidget* one = &widget; one && place.size() < 4; one = one->parentWidget())
    place.prepend(one->metaObject()->className());
  return place.join(" > ") + ": " + text.left(200);
}

/// What a window, or a part of it, takes for HTML although it may contain words of files.
QStringList interpreted(const QWidget& window) {
  QStringList found;
  QList<QWidget*> parts = window.findChildren<QWidget*>();
  parts << const_cast<QWidget*>(&window);
  for (QWidget* part : parts) {
    part->ensurePolished();
    if (const auto* label = qobject_cast<const QLabel*>(part))
      if (label->textFormat() == Qt::AutoText || (label->textFormat() == Qt::RichText && isForeign(label->text())))
        found << described(*label, label->text());
    const auto* view = qobject_cast<const QAbstractItemView*>(part);
    if (!view || !view->model()) continue;
    for (int row = 0; row < view->model()->rowCount(); ++row)
      for (int column = 0; column < view->model()->columnCount(); ++column) {
        const QString html = view->model()->index(row, column).data(widgets::richToolTipRole).toString();
        if (isForeign(html)) found << described(*view, html);
      }
  }
  return found;
}

/// Parts that a long name makes wider than the screen.
QStringList tooWide(const QWidget& window) {
  constexpr int screen = 1600;
  QStringList found;
  if (window.minimumSizeHint().width() <= screen && window.width() <= screen) return found;
  found << QStringLiteral("%1 of width %2, at least %3")
               .arg(window.metaObject()->className())
               .arg(window.width())
               .arg(window.minimumSizeHint().width());
  for (const QWidget* part : window.findChildren<QWidget*>())
    if (part->isVisible() && part->minimumSizeHint().width() > screen && part->minimumWidth() == 0)
      found << described(*part, part->property("text").toString().left(40));
  return found;
}

#define VERIFY_FITS(window)                                         \
  do {                                                              \
    const QStringList found = tooWide(window);                      \
    QVERIFY2(found.isEmpty(), qPrintable('\n' + found.join('\n'))); \
  } while (false)

#define VERIFY_PLAIN(window)                                        \
  do {                                                              \
    const QStringList found = interpreted(window);                  \
    QVERIFY2(found.isEmpty(), qPrintable('\n' + found.join('\n'))); \
  } while (false)

/// A label with exactly this text that is shown as it is; null: none.
const QLabel* plainLabel(const QWidget& part, const QString& text) {
  for (const QLabel* label : part.findChildren<QLabel*>())
    if (label->text() == text && label->textFormat() == Qt::PlainText) return label;
  return nullptr;
}

class ShownNamesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    if (QGuiApplication::platformName() == "offscreen") qunsetenv("DISPLAY");  // no picture is needed
    applyTheme(*qApp, Theme::dark);
    m_window = new MainWindow;
    m_window->resize(1600, 1000);
    m_window->show();
    for (const char* dock : {"history", "scene"}) m_window->docks().show(dock);  // the others would measure
    m_parts = &m_window->parts();
    m_material = test_support::glossyMaterial(0.3, HalfDifferenceGrid{4, 4, 4});
  }
  void cleanupTestCase() { delete m_window; }

  void names_data() {
    QTest::addColumn<QString>("name");
    for (const test::HostileName& name : test::hostileNames())
      QTest::newRow(name.id) << QString::fromStdString(name.text);
  }

  /// A material, its edits, a scene and messages with this name.
  void names() {
    QFETCH(QString, name);
    openMaterial(name);
    QCOMPARE(m_window->windowTitle(),
             widgets::titleText(widgets::spacedName(m_parts->document.name())) + "[*] - Gonio");
    showScene(name);
    QCOMPARE(QString::fromStdString(m_parts->preview.content().scene().description), name);
    if (!name.isEmpty())
      QVERIFY(plainLabel(m_parts->scene, name) && plainLabel(m_parts->scene, name)->toolTip() == name);
    m_parts->preview.overlay()->setBanner("Showing " + name, "Hide");
    Q_EMIT m_parts->controller.saved(name);
    QVERIFY(plainLabel(*m_window->statusBar(), "Saved " + name));
    Q_EMIT m_parts->controller.warned("Warning: " + name);
    QVERIFY(plainLabel(*m_window->findChild<widgets::MessageBar*>(), "Warning: " + name));
    m_parts->comparison.setPair({{{{}, name}, {{}, name}}});
    showTask(name);
    VERIFY_PLAIN(*m_window);
    VERIFY_FITS(*m_window);
    m_window->findChild<widgets::MessageBar*>()->hide();
  }

  /// Tasks name materials without underscores, and files as they are called.
  void tasksNameMaterials() {
    QCOMPARE(shortName("library:rgl/acrylic_felt_pink"), QString("acrylic felt pink"));
    QCOMPARE(shortName("/data/acrylic_felt.binary"), QString("acrylic_felt.binary"));
    const auto isRunning = [this](const QString& title) {
      for (const BackgroundTasks::Info& task : m_parts->tasks.shown())
        if (task.title == title) return true;
      return false;
    };
    m_parts->interpolation.materials().read(0, "library:rgl/no_such_felt");
    QVERIFY(isRunning("Opening no such felt for the blend"));
    m_parts->scene.otherSlots().read(0, "library:rgl/no_such_felt");
    QVERIFY(isRunning("Opening no such felt for the scene"));
    m_parts->tasks.stopAll();
  }

  void libraryAndMenus_data() { names_data(); }
  void libraryAndMenus() {
    QFETCH(QString, name);
    const QString id = "/nowhere/" + name;
    m_parts->library.model().setItems({{.id = id, .name = name, .toolTip = name}});
    m_parts->library.model().setFailure(id, name);
    m_parts->library.model().setNotes({{id, {.rating = 1, .tags = {name}}}});
    m_parts->libraryView.setTitle(name);
    m_parts->libraryView.setChipsShown(true);
    const QModelIndex index = m_parts->library.model().index(0);
    QCOMPARE(index.data().toString(), widgets::spacedName(name));
    QTextDocument toolTip;
    toolTip.setHtml(index.data(widgets::richToolTipRole).toString());
    QVERIFY(toolTip.toPlainText().simplified().contains(shownInHtml(name)));
    m_parts->libraryView.list()->setCurrentIndex(m_parts->libraryView.list()->model()->index(0, 0));
    QTest::keyClick(m_parts->libraryView.list(), Qt::Key_Space);
    VERIFY_PLAIN(*m_window);
    VERIFY_FITS(*m_window);
    QTest::keyClick(m_parts->libraryView.list(), Qt::Key_Escape);
    m_parts->recentFiles.clear();
    m_parts->recentFiles.add("library:sgd/" + name);
    QVERIFY(menuShows(widgets::oneLine(("/" + name).section('/', -1))));
  }

  void dialogs_data() { names_data(); }
  void dialogs() {
    QFETCH(QString, name);
    openMaterial(name);
    showScene(name);
    const QString id = "/nowhere/" + name;
    m_parts->library.model().setItems({{.id = id, .name = name, .toolTip = name}});
    const PreferencesDialog preferences({}, "Renderer", m_window);
    const BatchDialog batch(m_parts->exporter, m_parts->settings, {id}, m_window);
    const ExportDialog exporting(m_parts->exporter, m_parts->settings, m_parts->preview.content().scene(), m_window);
    const ReferenceDialog reference(m_parts->library.model(), m_window);
    StudyWindow& study = m_parts->study;
    study.present(StudyWindow::ResultsPage);
    for (QComboBox* box : study.findChildren<QComboBox*>())
      if (box->itemText(0).startsWith("Open material")) Q_EMIT box->activated(0);  // not those of the row before
    QCOMPARE(study.windowTitle(), "Study: " + widgets::titleText(m_parts->document.name()));
    study.setMaterials({id, id});
    const FigureDialog figure(m_parts->figureParts(), m_window);
    const ImageDialog image(
        {m_parts->document, m_parts->exports, m_parts->tasks, m_parts->comparison, m_parts->preview, m_parts->settings},
        name, m_window);
    for (const QDialog* dialog :
         std::initializer_list<const QDialog*>{&preferences, &batch, &exporting, &reference, &study, &figure, &image}) {
      const_cast<QDialog*>(dialog)->show();
      VERIFY_PLAIN(*dialog);
      VERIFY_FITS(*dialog);
    }
  }

  void messages_data() { names_data(); }
  void messages() {
    QFETCH(QString, name);
    Q_EMIT m_parts->exports.failed("Cannot write " + name, name);
    const auto boxes = m_window->findChildren<QMessageBox*>();
    QCOMPARE(boxes.size(), 1);
    QVERIFY(plainLabel(*boxes[0], "Cannot write " + name));
    VERIFY_PLAIN(*boxes[0]);
    QVERIFY(boxes[0]->width() <= 1600);
    delete boxes[0];
  }

  /// As they are shown, on every widget.
  void toolTips() {
    const QString name = QString::fromStdString(test::hostileNames()[1].text);
    openMaterial(name);
    showScene(name);
    m_parts->preview.overlay()->setBanner(name, "Hide");
    m_parts->inspector.unfoldRepresentation();  // and Details, with the models
    int plain = 0, rich = 0;
    for (QWidget* part : m_window->findChildren<QWidget*>()) {
      if (part->toolTip().isEmpty() || !part->isVisible()) continue;
      QHelpEvent event(QEvent::ToolTip, QPoint(1, 1), part->mapToGlobal(QPoint(1, 1)));
      QApplication::sendEvent(part, &event);
      for (const QWidget* window : QApplication::topLevelWidgets()) {
        const auto* tip = window->inherits("QTipLabel") ? qobject_cast<const QLabel*>(window) : nullptr;
        if (!tip || !tip->isVisible()) continue;
        const bool isPlain = tip->textFormat() == Qt::PlainText;
        (isPlain ? plain : rich)++;
        QVERIFY2(isPlain || (tip->textFormat() == Qt::RichText && !tip->text().contains(name)),
                 qPrintable(tip->text()));
      }
    }
    QVERIFY2(plain > 20 && rich > 0, qPrintable(QString("%1 plain, %2 rich").arg(plain).arg(rich)));
    QToolTip::hideText();
  }

 private:
  void openMaterial(const QString& name) {
    auto material = std::make_shared<LoadedMaterial>(*m_material);
    material->material.name = name.toStdString();
    material->material.source.format = name.toStdString();
    material->material.source.path = "/nowhere/" + name.toStdString();
    m_parts->document.setMaterial(material);
    fitting::FitResult fit;
    fit.model = &defaultModel();
    fit.parameters = models::defaultParameters(fit.model->spec());
    m_parts->document.adoptFit(fit);
    renameEdit(m_parts->document, 0, name);
    setEditStrength(m_parts->document, 0, 0.5);
    if (const QString shown = editName(m_parts->document.edits(), 0); !shown.trimmed().isEmpty())
      QVERIFY(menuShows("Undo " + widgets::oneLine("Set strength of " + shown + " to 50 %")));
  }

  void showScene(const QString& name) {
    Scene scene = m_parts->preview.content().scene();
    scene.name = scene.description = name.toStdString();
    scene.source = "/nowhere/" + scene.name;
    m_parts->preview.content().showScene(scene);
  }

  /// In the status line, while it is running.
  void showTask(const QString& name) {
    m_parts->tasks.run<int>(
        {name, "hostile"},
        [](const TaskControl& control) {
          while (!control.stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
          return 0;
        },
        [](int) {});
    if (!name.isEmpty()) QVERIFY(plainLabel(*m_window->statusBar(), name));
    m_parts->tasks.drop("hostile");
  }

  /// Whether an entry of a menu shows this text.
  bool menuShows(const QString& text) const {
    const auto shows = [&](const QMenu& menu) {
      for (const QAction* action : menu.actions())
        if (widgets::withoutKeyMarks(action->text()) == text) return true;
      return false;
    };
    for (QMenu* menu : m_window->findChildren<QMenu*>()) {
      Q_EMIT menu->aboutToShow();
      if (shows(*menu)) return true;
    }
    return false;
  }

  /// HTML collapses spaces and has no control characters.
  static QString shownInHtml(const QString& name) {
    QTextDocument document;
    document.setHtml(name.toHtmlEscaped());
    return document.toPlainText().simplified();
  }

  MainWindow* m_window = nullptr;
  EditorParts* m_parts = nullptr;
  LoadedMaterialPtr m_material;
};

GONIO_TEST(ShownNamesTest)
}  // namespace shown_names_test

#include "shown_names_test.moc"
