// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "app/gonio/document/edit_steps.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/window/main_window.h"
#include "app/gonio/window/theme.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_context.h"

/// Each way to leave a document with unsaved changes: no change is lost without a question that names the document.
namespace leaving_documents_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;
using Button = QMessageBox::StandardButton;

/// Presses one button in every message box, or Cancel where a box has no such button, and keeps what the boxes said.
class Answers {
 public:
  explicit Answers(Button button) {
    QObject::connect(&timer_, &QTimer::timeout, [this, button] {
      for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* box = qobject_cast<QMessageBox*>(widget);
        if (!box || !box->isVisible()) continue;
        QAbstractButton* pressed = box->button(box->button(button) ? button : QMessageBox::Cancel);
        if (!pressed) continue;
        texts_ << box->text() + '\n' + box->informativeText();
        formats_ << box->textFormat();
        pressed->click();
      }
    });
    timer_.start(10);
  }
  const QStringList& texts() const { return texts_; }
  const QList<Qt::TextFormat>& formats() const { return formats_; }

 private:
  QTimer timer_;
  QStringList texts_;
  QList<Qt::TextFormat> formats_;
};

class LeavingDocumentsTest : public QObject {
  Q_OBJECT

  const QTemporaryDir folder_;
  const QString other_ = QStringLiteral("library:sgd/brass");

  static Document& documentOf(MainWindow& window) { return window.parts().document; }

  static double diffuse(MainWindow& window) { return modelEdit(documentOf(window))->edited.values[0].x; }

  /// A window whose document has a file and one unsaved change.
  MainWindow* editedWindow(const QString& name) const {
    const QString path = folder_.filePath(name);
    documents::EditDocument stored;
    stored.sourcePath = "library:sgd/chrome";
    stored.sourceSha256 = materials::readMaterial(stored.sourcePath).source.sha256;
    stored.edits = {{editing::DifferentialEdit{&models::findModel("lambert"), {{Rgb(0.2)}}, {{Rgb(0.2)}}}}};
    documents::writeDocument(stored, path.toStdString());
    auto* window = new MainWindow;
    window->files().open(path);
    if (!QTest::qWaitFor([&] { return modelEdit(documentOf(*window)) != nullptr; }, patienceMilliseconds))
      return nullptr;
    setParameter(documentOf(*window), 0, Rgb(0.3));
    return window;
  }

  bool isSaved(const QString& name) const {
    const auto stored = documents::readDocument(folder_.filePath(name).toStdString());
    return std::get<editing::DifferentialEdit>(stored.edits[0].content).edited.values[0] == Rgb(0.3);
  }

  static bool settles(MainWindow& window) {
    return QTest::qWaitFor([&] { return window.parts().controller.opening().isEmpty(); }, patienceMilliseconds);
  }

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    applyTheme(*qApp, Theme::system);
    const test::OffscreenContext context;
    if (!context.isValid()) QSKIP("needs an OpenGL 4.1 context");
  }

  void openingAnotherFile() {
    QPointer<MainWindow> window;
    for (const Button button : {QMessageBox::Cancel, QMessageBox::Save, QMessageBox::Discard}) {
      if (!window) window = editedWindow("a.gonio");
      QVERIFY(window);
      const Answers answers(button);
      window->files().open(other_);
      QVERIFY(settles(*window));
      QCOMPARE(answers.texts().size(), 1);
      QVERIFY(answers.texts()[0].contains("Save changes to a?"));
      QCOMPARE(documentOf(*window).name(), QString(button == QMessageBox::Cancel ? "a" : "brass"));
      QCOMPARE(isSaved("a.gonio"), button == QMessageBox::Save);
      if (button != QMessageBox::Cancel) delete window;
    }
  }

  /// The question before opening knew of no change; those made while the file opens get one of their own.
  void editingWhileAFileOpens() {
    QPointer<MainWindow> window;
    for (const Button button : {QMessageBox::Cancel, QMessageBox::Save, QMessageBox::Discard}) {
      if (!window) window = editedWindow("a.gonio");
      QVERIFY(window);
      setParameter(documentOf(*window), 0, Rgb(0.3));
      QVERIFY(window->files().save());
      const Answers answers(button);
      window->files().open(other_);
      setParameter(documentOf(*window), 0, Rgb(0.4));
      QVERIFY(settles(*window));
      QTRY_COMPARE(answers.texts().size(), 1);
      QVERIFY(answers.texts()[0].contains("Save changes to a?") && answers.texts()[0].contains("brass"));
      QTRY_COMPARE(documentOf(*window).name(), QString(button == QMessageBox::Cancel ? "a" : "brass"));
      if (button == QMessageBox::Cancel) QCOMPARE(diffuse(*window), 0.4);
      const auto stored = documents::readDocument(folder_.filePath("a.gonio").toStdString());
      const Rgb expected(button == QMessageBox::Save ? 0.4 : 0.3);
      QVERIFY(std::get<editing::DifferentialEdit>(stored.edits[0].content).edited.values[0] == expected);
      if (button != QMessageBox::Cancel) delete window;
    }
  }

  void openingABlendAsMaterial() {
    QPointer<MainWindow> window;
    for (const Button button : {QMessageBox::Cancel, QMessageBox::Save, QMessageBox::Discard}) {
      if (!window) window = editedWindow("a.gonio");
      QVERIFY(window);
      auto blend = std::make_shared<LoadedMaterial>(*documentOf(*window).material());
      blend->material.name = "blend";
      const Answers answers(button);
      Q_EMIT window->parts().interpolation.materialMade(blend, "Open blend");
      QTRY_COMPARE(answers.texts().size(), 1);
      QTRY_COMPARE(documentOf(*window).name(), QString(button == QMessageBox::Cancel ? "a" : "blend"));
      QCOMPARE(isSaved("a.gonio"), button == QMessageBox::Save);
      if (button != QMessageBox::Cancel) delete window;
    }
  }

  void closingTheWindow() {
    QPointer<MainWindow> window;
    for (const Button button : {QMessageBox::Cancel, QMessageBox::Save, QMessageBox::Discard}) {
      if (!window) window = editedWindow("a.gonio");
      QVERIFY(window);
      window->show();
      {
        const Answers answers(button);
        QCOMPARE(window->close(), button != QMessageBox::Cancel);
        QCOMPARE(answers.texts().size(), 1);
      }
      QCOMPARE(isSaved("a.gonio"), button == QMessageBox::Save);
      if (button != QMessageBox::Cancel) delete window;
    }
  }

  /// One question with the names of all; Cancel leaves every window open, also those without changes.
  void quitting() {
    for (const Button button : {QMessageBox::Cancel, QMessageBox::SaveAll, QMessageBox::Discard}) {
      QList<QPointer<MainWindow>> windows{editedWindow("a.gonio"), new MainWindow, editedWindow("b.gonio")};
      for (const auto& window : windows) {
        QVERIFY(window);
        window->show();
      }
      {
        const Answers answers(button);
        MainWindow::quit();
        QCOMPARE(answers.texts().size(), 1);
        QVERIFY(answers.texts()[0].contains(folder_.filePath("a.gonio")));
        QVERIFY(answers.texts()[0].contains(folder_.filePath("b.gonio")));
        QVERIFY(answers.texts()[0].contains("these 2 documents"));
      }
      QTest::qWait(1);  // closed windows go
      for (const QString& name : {QStringLiteral("a.gonio"), QStringLiteral("b.gonio")})
        QCOMPARE(isSaved(name), button == QMessageBox::SaveAll);
      for (const auto& window : windows) {
        QCOMPARE(window && window->isVisible(), button == QMessageBox::Cancel);
        if (!window) continue;
        delete window;
      }
    }
  }

  /// A document that cannot be saved keeps everything open.
  void quittingWithoutAPlaceToSave() {
    const QPointer<MainWindow> window = editedWindow("a.gonio");
    QVERIFY(window);
    window->show();
    documentOf(*window).markSaved("/nowhere/a.gonio");
    setParameter(documentOf(*window), 0, Rgb(0.5));
    const Answers answers(QMessageBox::SaveAll);
    MainWindow::quit();
    QVERIFY(window && window->isVisible());
    QCOMPARE(diffuse(*window), 0.5);
    delete window;
  }

  /// What a document is called in a question is text, whatever it looks like.
  void questionsArePlainText() {
    const QString name = QStringLiteral("<h1>big</h1><img src=pipe>.gonio");
    const QPointer<MainWindow> window = editedWindow("a.gonio");
    QVERIFY(window);
    documentOf(*window).markSaved(folder_.filePath(name));
    setParameter(documentOf(*window), 0, Rgb(0.5));
    const Answers answers(QMessageBox::Cancel);
    window->files().open(other_);
    MainWindow::quit();
    QCOMPARE(answers.texts().size(), 2);
    for (const Qt::TextFormat format : answers.formats()) QCOMPARE(format, Qt::PlainText);
    delete window;
  }
};

GONIO_TEST(LeavingDocumentsTest)
}  // namespace leaving_documents_test

#include "leaving_documents_test.moc"
