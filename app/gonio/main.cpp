// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QApplication>
#include <QFileInfo>
#include <QSettings>
#include <csignal>
#include <utility>

#include "app/gonio/library/thumbnail.h"
#include "app/gonio/window/event_times.h"
#include "app/gonio/window/figure_screenshot.h"
#include "app/gonio/window/main_window.h"
#include "app/gonio/window/opening_times.h"
#include "app/gonio/window/screenshot.h"
#include "app/gonio/window/start_options.h"
#include "app/gonio/window/theme.h"

namespace {

using namespace gonio::app;

QString asGiven(const QString& file) {
  return file.startsWith(QStringLiteral("library:")) ? file : QFileInfo(file).absoluteFilePath();
}

/// Saves a picture of the window, or of the dialog of the figure, and ends the program.
void takeScreenshot(MainWindow& window, const StartOptions& options) {
  if (options.figure.isEmpty())
    new Screenshot(
        window, [&window] { return window.parts().isSettled(); }, options.screenshot, options.waitSeconds);
  else
    takeFigureScreenshot(window.parts().figureParts(), window, options.figure, options.screenshot, options.waitSeconds);
}

/// Renders the pictures of the library into a folder. @return the program's exit code.
int writeThumbnails(const QString& folder) {
  try {
    writeBundledThumbnails(folder);
    return 0;
  } catch (const gonio::Error& error) {
    std::fprintf(stderr, "gonio: %s\n", error.what());
    return 1;
  }
}

/// Help and version need no display; Qt would end the program where there is none.
void printWithoutDisplay([[maybe_unused]] int argc, [[maybe_unused]] char** argv) {
#ifdef Q_OS_LINUX
  for (int i = 1; i < argc; ++i)
    for (const char* text : {"-h", "--help", "--help-all", "-v", "--version"})
      if (qstrcmp(argv[i], text) == 0) qputenv("QT_QPA_PLATFORM", "offscreen");
#endif
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
  // A file that grows beyond `ulimit -f` is an error of writing, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  printWithoutDisplay(argc, argv);
  QApplication::setApplicationName(QStringLiteral("gonio"));
  QApplication::setOrganizationName(QStringLiteral("gonio"));
  QApplication::setApplicationDisplayName(QStringLiteral("Gonio"));
  QApplication::setApplicationVersion(QStringLiteral(GONIO_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("gonio"));
  TimedApplication application(argc, argv);
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/gonio.svg")));
  const StartOptions options = readOptions(application);
  if (!options.thumbnails.isEmpty()) return writeThumbnails(options.thumbnails);
  applyTheme(application, themeByName(options.theme.isEmpty() ? QSettings().value("theme").toString() : options.theme));

  auto* window = new MainWindow;
  if (options.size.isValid()) window->resize(options.size);
  window->show();
  prepare(window->parts(), window->docks(), options.view);
  if (options.openingTimes) {
    new OpeningTimes(window->parts(), options.files, window);
    return QApplication::exec();
  }
  if (!options.screenshot.isEmpty()) takeScreenshot(*window, options);
  openFiles(*window, options.files,
            options.screenshot.isEmpty() ? window->files().askForRecovery() : QList<RecoverableWork>());
  if (!options.eventTimes) return QApplication::exec();
  application.startTiming();
  const int result = QApplication::exec();
  std::fputs(qPrintable(application.eventTimes()), stdout);
  return result;
}
