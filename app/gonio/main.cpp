// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QApplication>
#include <QCheckBox>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTimer>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/factors/factor_curves_panel.h"
#include "app/gonio/inspector/representation_panel.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/library/thumbnail.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/study/fit_ranking_panel.h"
#include "app/gonio/study/study_panel.h"
#include "app/gonio/window/main_window.h"
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
  QString takeF1;
  QStringList blended;
  std::size_t encoded;
  QString thumbnails;
  QString scene;
  int acquired;
  int acquisitionPage;
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
  hidden("study", "LABEL");           // measures representations, and shows the one of this name
  hidden("widen", "FACTOR");          // stretches F2
  hidden("take-f1", "FILE");          // takes F1 of another material over
  hidden("interpolate", "A,B,...");   // shows the Interpolation dock with these materials
  hidden("encoded", "COUNT");         // shows the code of so many coefficients
  hidden("thumbnails", "FOLDER");     // draws the pictures of the library, for scripts/thumbnails.sh
  hidden("acquire", "COUNT");         // acquires the material from so many samples
  hidden("acquisition-page", "0-2");  // of the Acquisition dock
  hidden("scene", "NAME");            // shows the Scene dock with this scene
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
          parser.value("acquire").toInt(),
          parser.value("acquisition-page").toInt()};
}

QString asGiven(const QString& file) {
  return file.startsWith(QStringLiteral("library:")) ? file : QFileInfo(file).absoluteFilePath();
}

/// Edits the factor curves as soon as they are known.
void editFactors(MainWindow& window, const Options& options) {
  constexpr int checkMilliseconds = 100;
  auto* timer = new QTimer(&window);
  QObject::connect(timer, &QTimer::timeout, &window, [&window, timer, options] {
    if (window.factors().column(FactorAxis::deviation).editor().nodes().empty()) return;
    timer->stop();
    if (options.widen > 0) window.factors().widen(options.widen);
    if (!options.takeF1.isEmpty()) window.factors().takeOver(FactorAxis::theta, options.takeF1);
  });
  timer->start(checkMilliseconds);
}

/// Measures the representations of the material that is opened, and shows one of them.
void measureRepresentations(MainWindow& window, const QString& label) {
  window.showDock(QStringLiteral("study"));
  StudyPanel& study = window.study();
  QObject::connect(&window.document(), &Document::materialChanged, &study, &StudyPanel::measure, Qt::QueuedConnection);
  QObject::connect(&study.model(), &StudyModel::dataChanged, &study, [&study, label](const QModelIndex& index) {
    const int row = index.row();
    const bool isIt = study.model().representation(row).fullLabel() == label.toStdString();
    if (isIt && study.model().studied(row) && study.shownName() != label) study.show(row);
  });
}

/// Acquires the material that is opened, and shows a page of the panel then.
void acquire(MainWindow& window, int samples, int page) {
  window.showAcquisitionLayout();
  AcquisitionPanel& panel = window.acquisition();
  panel.controls().setSamples(samples);
  QObject::connect(&window.document(), &Document::materialChanged, &panel, &AcquisitionPanel::start,
                   Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
  QObject::connect(
      &panel.session(), &AcquisitionSession::resultChanged, &panel,
      [&panel, page] { panel.pages().setCurrentIndex(page); }, Qt::QueuedConnection);
}

/// Puts the window into the state that a picture is to show.
void prepare(MainWindow& window, const Options& options) {
  if (!options.plot.isEmpty()) window.plots().showKind(options.plot);
  const QStringList modes{"off", "split", "flicker", "difference", "two-up"};
  if (modes.contains(options.compare))
    window.comparison().setComparison({.mode = gonio::widgets::CompareMode(modes.indexOf(options.compare))});
  if (options.factors) window.showDock(QStringLiteral("factors"));
  if (!options.scene.isEmpty()) {
    window.showDock(QStringLiteral("scene"));
    window.scenePanel().open(options.scene);
  }
  if (options.encoded > 0) {
    window.inspector().unfoldRepresentation();
    window.inspector().representation()->setCoefficients(options.encoded);
    window.inspector().representation()->showEncoded().setChecked(true);
  }
  if (options.widen > 0 || !options.takeF1.isEmpty()) editFactors(window, options);
  if (!options.blended.isEmpty()) window.showDock(QStringLiteral("interpolation"));
  // Also when the material that is opened comes later than these.
  InterpolationPanel& interpolation = window.interpolation();
  if (!options.blended.isEmpty())
    QObject::connect(
        &window.document(), &Document::materialChanged, &window,
        [&interpolation] { interpolation.setShownInPreview(true); }, Qt::QueuedConnection);
  for (qsizetype i = 0; i < options.blended.size(); ++i) {
    if (i >= interpolation.ends().count()) interpolation.ends().addPlace();
    interpolation.ends().read(int(i), options.blended[i]);
  }
  if (options.acquired > 0) acquire(window, options.acquired, options.acquisitionPage);
  if (!options.study.isEmpty()) measureRepresentations(window, options.study);
  if (!options.models) return;
  window.showDock(QStringLiteral("models"));
  // Once, when the material and its first fit are there.
  QObject::connect(
      &window.document(), &Document::stateChanged, &window,
      [&window] {
        if (window.document().active<editing::DifferentialEdit>() && window.ranking().model().rowCount() == 0 && !window.ranking().isRunning())
          window.ranking().fitAll();
      },
      Qt::QueuedConnection);
}

}  // namespace

int main(int argc, char** argv) {
  QSurfaceFormat format;
  format.setVersion(4, 1);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setApplicationName(QStringLiteral("gonio"));
  QApplication::setOrganizationName(QStringLiteral("gonio"));
  QApplication::setApplicationDisplayName(QStringLiteral("Gonio"));
  QApplication::setApplicationVersion(QStringLiteral(GONIO_VERSION));
  QApplication application(argc, argv);
  const Options options = readOptions(application);
  if (!options.thumbnails.isEmpty()) return drawBundledThumbnails(options.thumbnails) ? 0 : 1;
  applyTheme(application, themeByName(options.theme.isEmpty() ? QSettings().value("theme").toString() : options.theme));

  auto* window = new MainWindow;
  if (options.size.isValid()) window->resize(options.size);
  window->show();
  prepare(*window, options);
  if (!options.screenshot.isEmpty())
    new Screenshot(*window, options.screenshot, options.waitSeconds);
  else
    window->offerRecovery();
  for (qsizetype i = 0; i < options.files.size(); ++i) {
    auto* target = i == 0 ? window : new MainWindow;
    target->show();
    target->open(asGiven(options.files[i]));
  }
  return QApplication::exec();
}
