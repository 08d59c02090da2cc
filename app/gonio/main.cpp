// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QApplication>
#include <QCheckBox>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/factors/factor_curves_panel.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/inspector/representation_panel.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/library/bundled_thumbnails.h"
#include "app/gonio/plots/plots_panel.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/study/fit_ranking_panel.h"
#include "app/gonio/study/study_panel.h"
#include "app/gonio/window/dock_layout.h"
#include "app/gonio/window/event_times.h"
#include "app/gonio/window/figure_screenshot.h"
#include "app/gonio/window/main_window.h"
#include "app/gonio/window/memory_arenas.h"
#include "app/gonio/window/opening_times.h"
#include "app/gonio/window/screenshot.h"
#include "app/gonio/window/theme.h"
#include "widgets/curves/curve_editor.h"

namespace {

using namespace gonio::app;

struct Options {
  QStringList files;
  QString screenshot;
  QSize size;
  double waitSeconds;
  QString theme;
  QString plot;
  QString compare;
  bool models, factors;
  QString study;
  double widen;
  QString withF1Of;
  QStringList blended;
  std::size_t encoded;
  QString thumbnails;
  QString scene;
  QStringList otherSlots;
  QString figure;
  int acquired;
  int acquisitionPage;
  bool openingTimes, eventTimes;
};

Options readOptions(const QApplication& application) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QObject::tr("An editor for measured materials (BRDFs)."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(
      "file",
      QObject::tr("Materials (%1) or documents (*%2) to open.").arg(materialFilePatterns().join(' '), documentSuffix()),
      "[FILE ...]");
  const auto hidden = [&parser](const char* name, const char* value) {
    QCommandLineOption option(name, {}, value);
    option.setFlags(QCommandLineOption::HiddenFromHelp);
    parser.addOption(option);
  };
  // For scripts/screenshots.sh.
  hidden("screenshot", "OUT.png");
  hidden("size", "WxH");
  hidden("wait", "SECONDS");
  hidden("theme", "NAME");
  hidden("plot", "KIND");
  hidden("compare", "MODE");
  QCommandLineOption models("models");  // ranks the fits of all models
  models.setFlags(QCommandLineOption::HiddenFromHelp);
  parser.addOption(models);
  QCommandLineOption factors("factors");  // shows the factor curves
  factors.setFlags(QCommandLineOption::HiddenFromHelp);
  parser.addOption(factors);
  hidden("study", "LABEL");                          // measures representations, and shows the one of this name
  hidden("widen", "FACTOR");                         // stretches F2
  hidden("take-f1", "FILE");                         // takes F1 of another material over
  hidden("interpolate", "A,B,...");                  // shows the Interpolation dock with these materials
  hidden("encoded", "COUNT");                        // shows the code of so many coefficients
  hidden("thumbnails", "FOLDER");                    // renders the pictures of the library, for scripts/thumbnails.sh
  hidden("acquire", "COUNT");                        // acquires the material from so many samples
  hidden("acquisition-page", "0-3");                 // of the Acquisition dock
  hidden("scene", "NAME");                           // shows the Scene dock with this scene
  hidden("slots", "B,C,...");                        // fills the material slots of the scene after the first
  hidden("figure", "DESCRIPTION.json");              // measures this figure; its dialog is the picture
  QCommandLineOption openingTimes("opening-times");  // prints how long the files take to open, and exits
  openingTimes.setFlags(QCommandLineOption::HiddenFromHelp);
  parser.addOption(openingTimes);
  QCommandLineOption eventTimes("event-times");  // prints at the end how long events kept the window from answering
  eventTimes.setFlags(QCommandLineOption::HiddenFromHelp);
  parser.addOption(eventTimes);
  parser.process(application);
  const QStringList size = parser.value("size").split('x');
  return {parser.positionalArguments(),
          parser.value("screenshot"),
          size.size() == 2 ? QSize(size[0].toInt(), size[1].toInt()) : QSize(),
          parser.isSet("wait") ? parser.value("wait").toDouble() : 60,
          parser.value("theme"),
          parser.value("plot"),
          parser.value("compare"),
          parser.isSet(models),
          parser.isSet(factors),
          parser.value("study"),
          parser.value("widen").toDouble(),
          parser.value("take-f1"),
          parser.value("interpolate").split(',', Qt::SkipEmptyParts),
          parser.value("encoded").toULongLong(),
          parser.value("thumbnails"),
          parser.value("scene"),
          parser.value("slots").split(',', Qt::SkipEmptyParts),
          parser.value("figure"),
          parser.value("acquire").toInt(),
          parser.value("acquisition-page").toInt(),
          parser.isSet(openingTimes),
          parser.isSet(eventTimes)};
}

QString asGiven(const QString& file) {
  return file.startsWith(QStringLiteral("library:")) ? file : QFileInfo(file).absoluteFilePath();
}

/// Edits the factor curves as soon as they are known.
void editFactors(FactorCurvesPanel& factors, const Options& options) {
  constexpr int checkMilliseconds = 100;
  auto* timer = new QTimer(&factors);
  QObject::connect(timer, &QTimer::timeout, &factors, [&factors, timer, options] {
    if (factors.column(FactorAxis::deviation).editor().nodes().empty()) return;
    timer->stop();
    if (options.widen > 0) factors.widen(options.widen);
    if (!options.withF1Of.isEmpty()) factors.replaceCurve(FactorAxis::theta, options.withF1Of);
  });
  timer->start(checkMilliseconds);
}

/// Measures the representations of the material that is opened, and shows one of them.
void measureRepresentations(const EditorParts& parts, const QString& label) {
  StudyPanel& study = parts.study;
  QObject::connect(&parts.document, &Document::materialChanged, &study, &StudyPanel::measure, Qt::QueuedConnection);
  QObject::connect(&study.model(), &StudyModel::dataChanged, &study, [&study, label](const QModelIndex& index) {
    const int row = index.row();
    const bool isIt = study.model().representation(row).fullLabel() == label.toStdString();
    if (isIt && study.model().studied(row) && study.shownName() != label) study.show(row);
  });
}

/// Acquires the material that is opened, and shows a page of the panel then.
void acquire(const EditorParts& parts, int samples, int page) {
  AcquisitionPanel& panel = parts.acquisition;
  panel.controls().directions().setSamples(samples);
  QObject::connect(&parts.document, &Document::materialChanged, &panel, &AcquisitionPanel::start,
                   Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
  QObject::connect(
      &panel.session(), &AcquisitionSession::resultChanged, &panel,
      [&panel, page] { panel.pages().setCurrentIndex(page); }, Qt::QueuedConnection);
}

/// Shows the Interpolation dock's blend of materials, also when the material that is opened comes later than these.
void interpolate(const EditorParts& parts, const QStringList& blended) {
  InterpolationPanel& interpolation = parts.interpolation;
  QObject::connect(
      &parts.document, &Document::materialChanged, &interpolation,
      [&interpolation] { interpolation.setShownInPreview(true); }, Qt::QueuedConnection);
  for (qsizetype i = 0; i < blended.size(); ++i) {
    if (i >= interpolation.materials().count()) interpolation.materials().addSlot();
    interpolation.materials().read(int(i), blended[i]);
  }
}

/// Ranks the fits of the material that is opened, once it and its first fit are there.
void rankFits(const EditorParts& parts) {
  QObject::connect(
      &parts.document, &Document::stateChanged, &parts.ranking,
      [&document = parts.document, &ranking = parts.ranking] {
        if (document.active<gonio::editing::DifferentialEdit>() && ranking.model().rowCount() == 0 &&
            !ranking.isRunning())
          ranking.fitAll();
      },
      Qt::QueuedConnection);
}

/// Brings an editor into the state that a picture is to show.
void prepare(EditorParts& parts, DockLayout& docks, const Options& options) {
  if (!options.plot.isEmpty()) parts.plots.showKind(options.plot);
  const QStringList modes{"off", "split", "flicker", "difference", "two-up"};
  if (modes.contains(options.compare))
    parts.comparison.setComparison({.mode = gonio::widgets::CompareMode(modes.indexOf(options.compare))});
  if (options.factors) docks.show(QStringLiteral("factors"));
  if (!options.scene.isEmpty()) {
    docks.show(QStringLiteral("scene"));
    parts.scene.open(options.scene);
    for (int slot = 0; slot < std::min(int(options.otherSlots.size()), SceneMaterialSlots::count); ++slot)
      parts.scene.otherSlots().read(slot, options.otherSlots[slot]);
  }
  if (options.encoded > 0) {
    parts.inspector.unfoldRepresentation();
    parts.inspector.representation()->setCoefficients(options.encoded);
    parts.inspector.representation()->showEncoded().setChecked(true);
  }
  if (options.widen > 0 || !options.withF1Of.isEmpty()) editFactors(parts.factors, options);
  if (!options.blended.isEmpty()) {
    docks.show(QStringLiteral("interpolation"));
    interpolate(parts, options.blended);
  }
  if (options.acquired > 0) {
    docks.showWorkspace(DockLayout::Workspace::acquire);
    acquire(parts, options.acquired, options.acquisitionPage);
  }
  if (!options.study.isEmpty()) {
    docks.show(QStringLiteral("study"));
    measureRepresentations(parts, options.study);
  }
  if (options.models) {
    docks.show(QStringLiteral("models"));
    rankFits(parts);
  }
}

/// Saves a picture of the window, or of the dialog of the figure, and ends the program.
void takeScreenshot(MainWindow& window, const Options& options) {
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
  limitMemoryArenas();
  printWithoutDisplay(argc, argv);
  QApplication::setApplicationName(QStringLiteral("gonio"));
  QApplication::setOrganizationName(QStringLiteral("gonio"));
  QApplication::setApplicationDisplayName(QStringLiteral("Gonio"));
  QApplication::setApplicationVersion(QStringLiteral(GONIO_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("gonio"));
  TimedApplication application(argc, argv);
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/gonio.svg")));
  const Options options = readOptions(application);
  if (!options.thumbnails.isEmpty()) return writeThumbnails(options.thumbnails);
  applyTheme(application, themeByName(options.theme.isEmpty() ? QSettings().value("theme").toString() : options.theme));

  auto* window = new MainWindow;
  if (options.size.isValid()) window->resize(options.size);
  window->show();
  prepare(window->parts(), window->docks(), options);
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
