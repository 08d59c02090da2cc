// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <cstdio>

#include "app/gonio/window/main_window.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_context.h"

/// An editor in a process of its own that is killed while it starts, recovers, edits and saves.
namespace recovery_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

constexpr char childVariable[] = "GONIO_RECOVERY_CHILD";
const QString material = QStringLiteral("library:sgd/chrome");
QString documentPath() { return QDir::current().absoluteFilePath("mine.gonio"); }

/// The steps of the edits are counted in the name of the only edit.
editing::EditList editsOfStep(int step) {
  const models::Model& lambert = models::findModel("lambert");
  return {{editing::DifferentialEdit{&lambert, {{Rgb(0.2)}}, {{Rgb(0.2 + 1e-6 * step)}}}, std::to_string(step)}};
}
int stepOf(const editing::EditList& edits) { return edits.empty() ? 0 : QString::fromStdString(edits[0].name).toInt(); }
/// -1 if there is no such file. @throws Error for a damaged file.
int stepOfFile(const QString& path) {
  return QFile::exists(path) ? stepOf(documents::readDocument(path.toStdString()).edits) : -1;
}
/// The copies that the next start offers, in its order.
std::vector<int> stepsOfCopies() {
  std::vector<int> steps;
  for (const RecoverableWork& work : Autosave::recoverable(Autosave::defaultDataFolder()))
    steps.push_back(stepOfFile(work.autosavePath));
  return steps;
}

/// Recovers the newest work, and then edits, saves and copies at random until it is killed.
class Child {
 public:
  void run() {
    const std::vector<int> copies = stepsOfCopies();
    const auto newest = std::ranges::max_element(copies);
    if (newest != copies.end() && *newest > stepOfFile(documentPath())) wanted_ = int(newest - copies.begin());
    QTimer answers;
    QObject::connect(&answers, &QTimer::timeout, [this] { answer(); });
    answers.start(10);
    auto* window = new MainWindow;
    window->show();
    const QList<RecoverableWork> works = window->files().askForRecovery();
    if (!works.isEmpty())
      window->files().recover(works[0]);
    else
      window->files().open(QFile::exists(documentPath()) ? documentPath() : material);
    const Document& document = window->parts().document;
    (void)QTest::qWaitFor([&] { return document.material() != nullptr; }, patienceMilliseconds);
    const int step = stepOf(document.edits());
    report("opened", step);
    edit(*window, step);
  }

 private:
  static void report(const char* what, int step) {
    std::printf("%s %d\n", what, step);
    std::fflush(stdout);
  }

  /// Yes to the newest work, Discard to older copies.
  void answer() {
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
      box->button(asked_++ == wanted_ ? QMessageBox::Yes : QMessageBox::Discard)->click();
  }

  static void edit(MainWindow& window, int step) {
    EditorParts& parts = window.parts();
    QRandomGenerator& random = *QRandomGenerator::global();
    for (;;) {
      parts.document.replaceEdits(editsOfStep(++step), QStringLiteral("Step"));
      QTest::qWait(random.bounded(8));
      if (random.bounded(6) == 0 && parts.controller.save(documentPath(), {})) report("saved", step);
      if (random.bounded(6) == 0) {
        window.files().copyUnsavedWork();
        report("copied", step);
      }
    }
  }

  int wanted_ = -1, asked_ = 0;
};

/// GONIO_RECOVERY_KILLS in the environment asks for more kills than `./check` has time for.
class RecoveryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    const test::OffscreenContext context;
    if (!context.isValid()) QSKIP("needs an OpenGL 4.1 context");
    if (!qEnvironmentVariableIsSet(childVariable)) return;
    Child().run();
  }

  /// Whatever was saved, or copied as unsaved work, is there after the kill and opened by the next start.
  void aKilledEditorLosesNothingSavedOrCopied() {
    const QTemporaryDir folder;
    QVERIFY(QDir::setCurrent(folder.path()));
    for (const char* place : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
      qputenv(place, folder.path().toUtf8());
    const int kills = std::max(4, qEnvironmentVariableIntValue("GONIO_RECOVERY_KILLS"));
    QRandomGenerator random(7);
    int kept = 0, opened = 0, recovered = 0;
    for (int k = 0; k < kills; ++k) {
      const bool isOffered = kept > stepOfFile(documentPath());
      const QList<QByteArray> reports = reportsOfKilledChild(random);
      for (const QByteArray& line : reports) {
        const int step = line.mid(line.indexOf(' ')).toInt();
        if (line.startsWith("opened")) {
          QCOMPARE(step, kept);
          ++opened;
          recovered += isOffered;
        }
        kept = std::max(kept, step);
      }
      const std::vector<int> copies = stepsOfCopies();
      int found = std::max(0, stepOfFile(documentPath()));
      for (const int step : copies) found = std::max(found, step);
      QVERIFY2(found >= kept, qPrintable(QString("step %1 was kept, found is %2").arg(kept).arg(found)));
      kept = found;
    }
    std::printf("%d kills, %d after the document was open, %d of them recovered; %d steps\n", kills, opened, recovered,
                kept);
    QVERIFY(opened > 0);
  }

 private:
  /// What a child printed until it was killed, at a random time after its start.
  static QList<QByteArray> reportsOfKilledChild(QRandomGenerator& random) {
    constexpr int longestLife = 4000;
    QProcess child;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(childVariable, "1");
    child.setProcessEnvironment(environment);
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    child.start(QCoreApplication::applicationFilePath(), {"recovery", "-nocrashhandler"});
    child.waitForFinished(int(random.bounded(longestLife)));
    child.kill();
    child.waitForFinished();
    QList<QByteArray> lines;
    for (const QByteArray& line : child.readAllStandardOutput().split('\n'))
      if (line.startsWith("opened ") || line.startsWith("saved ") || line.startsWith("copied "))
        lines << line.trimmed();
    return lines;
  }
};

GONIO_TEST(RecoveryTest)
}  // namespace recovery_test

#include "recovery_test.moc"
