// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QSettings>
#include <optional>
#include <utility>

#include "app/gonio/document/material_files.h"
#include "app/gonio/window/main_window.h"
#include "app/gonio/window/theme.h"
#include "core/support/system.h"
#ifdef GONIO_DEVELOPMENT
#include "app/gonio/development.h"
#endif

namespace {

using namespace gonio::app;

#ifdef GONIO_DEVELOPMENT
using Application = DevelopmentApplication;
#else
/// Without the tools of development.h.
class Application : public QApplication {
 public:
  using QApplication::QApplication;
  static void addOptions(QCommandLineParser&) {}
  template <class OpenFiles>
  static std::optional<int> run(const QCommandLineParser&, const OpenFiles&) {
    return std::nullopt;
  }
};
#endif

QString asGiven(const QString& file) {
  return file.startsWith(QStringLiteral("library:")) ? file : QFileInfo(file).absoluteFilePath();
}

/// Help and version need no display; Qt would end the program where there is none.
void printWithoutDisplay([[maybe_unused]] int argc, [[maybe_unused]] char** argv) {
#ifdef Q_OS_LINUX
  for (int i = 1; i < argc; ++i)
    for (const char* text : {"-h", "--help", "--help-all", "-v", "--version"})
      if (qstrcmp(argv[i], text) == 0) qputenv("QT_QPA_PLATFORM", "offscreen");
#endif
}

/// Ends the program after help, the version or an error, with a message.
void readCommandLine(QCommandLineParser& parser, const QApplication& application) {
  parser.setApplicationDescription(QObject::tr("An editor for measured materials (BRDFs)."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(
      "file",
      QObject::tr("Materials (%1) or documents (*%2) to open.").arg(materialFilePatterns().join(' '), documentSuffix()),
      "[FILE ...]");
  Application::addOptions(parser);
  parser.process(application);
}

/// Opens recovered work and the given files, each in a window of its own. A file whose unsaved work is recovered is not
/// opened again.
void openFiles(MainWindow& first, const QStringList& files, const QList<RecoverableWork>& recovered) {
  MainWindow* unused = &first;
  const auto nextWindow = [&unused]() -> DocumentFiles& {
    auto* window = unused ? std::exchange(unused, nullptr) : new MainWindow;
    window->show();
    return window->files();
  };
  QStringList open;
  for (const RecoverableWork& work : recovered) {
    nextWindow().recover(work);
    open << work.originalPath;
  }
  for (const QString& file : files)
    if (const QString path = asGiven(file); !open.contains(path)) nextWindow().open(path);
}

}  // namespace

int main(int argc, char** argv) {
  gonio::system::reportTooLargeFiles();
  printWithoutDisplay(argc, argv);
  QApplication::setApplicationName(QStringLiteral("gonio"));
  QApplication::setOrganizationName(QStringLiteral("gonio"));
  QApplication::setApplicationDisplayName(QStringLiteral("Gonio"));
  QApplication::setApplicationVersion(QStringLiteral(GONIO_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("gonio"));
  Application application(argc, argv);
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/gonio.svg")));
  QCommandLineParser parser;
  readCommandLine(parser, application);
  const QStringList files = parser.positionalArguments();
  applyTheme(application, themeByName(QSettings().value("theme").toString()));
  if (const auto result = application.run(parser, [&](MainWindow& first) { openFiles(first, files, {}); }))
    return *result;
  auto* window = new MainWindow;
  window->show();
  openFiles(*window, files, window->files().askForRecovery());
  return QApplication::exec();
}
