// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/development.h"

#include <QCheckBox>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QEvent>
#include <QFileInfo>
#include <QMetaEnum>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/acquisition/photograph_panel.h"
#include "app/gonio/factors/factor_curves_panel.h"
#include "app/gonio/figures/figure_file_buttons.h"
#include "app/gonio/figures/figure_view.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/inspector/representation_panel.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/library/thumbnail.h"
#include "app/gonio/plots/plots_panel.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/study/study_window.h"
#include "app/gonio/window/dock_layout.h"
#include "app/gonio/window/main_window.h"
#include "app/gonio/window/theme.h"
#include "widgets/curves/curve_editor.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {
namespace {

struct Option {
  const char *name, *value;  ///< value: null for a switch
};
constexpr Option options[]{
    {"thumbnails", "FOLDER"},        // renders the pictures of the library into this folder, and ends
    {"opening-times", nullptr},      // prints how long the files take to open, and ends
    {"event-times", nullptr},        // prints at the end how long events kept the window from answering
    {"screenshot", "OUT.png"},       // saves a picture of the window once everything in it is settled, and ends
    {"wait", "SECONDS"},             // at most, before the picture is taken; default 60
    {"size", "WxH"},                 // of the window; default: as it was last
    {"theme", "NAME"},               // default: as it was last
    {"figure", "DESCRIPTION.json"},  // measures this figure; its dialog is the picture
    // What the window shows once its material is open and what is needed has been computed:
    {"plot", "KIND"},             // a kind of plot
    {"compare", "MODE"},          // a comparison: off, split, flicker, difference, two-up
    {"models", nullptr},          // the ranking of the fits of all models
    {"factors", nullptr},         // the factor curves
    {"widen", "FACTOR"},          // these with F2 stretched
    {"take-f1", "FILE"},          // these with F1 of another file
    {"study", "LABEL"},           // the measured representations, and the one of this name in the preview
    {"interpolate", "A,B,..."},   // the blend of these materials
    {"encoded", "COUNT"},         // the code of so many coefficients
    {"acquire", "COUNT"},         // the acquisition of the material from so many samples
    {"acquisition-page", "0-3"},  // its page
    {"photographs", "FILE"},      // the reconstruction from these photographs
    {"scene", "NAME"},            // the material in this scene
    {"slots", "B,C,..."}};        // materials for the slots of the scene after the first

QStringList listOf(const QString& value) { return value.split(',', Qt::SkipEmptyParts); }

QSize sizeOf(const QString& value) {
  const QStringList numbers = value.split('x');
  return numbers.size() == 2 ? QSize(numbers[0].toInt(), numbers[1].toInt()) : QSize();
}

/// Renders the pictures of the library into a folder. @return the program's exit code.
int writeThumbnails(const QString& folder) {
  try {
    writeBundledThumbnails(folder);
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "gonio: %s\n", error.what());
    return 1;
  }
}

/// Saves a picture of a window once everything in it is settled, or after the maximum wait, and ends the program.
void takeScreenshot(QWidget& window, const std::function<bool()>& isSettled, const QString& path, double maxSeconds) {
  constexpr int checkMilliseconds = 200;
  constexpr int neededChecks = 4;  // one task may start the next
  QElapsedTimer elapsed;
  elapsed.start();
  auto* timer = new QTimer(&window);
  QObject::connect(timer, &QTimer::timeout, &window, [=, &window, checks = 0]() mutable {
    checks = isSettled() ? checks + 1 : 0;
    if (checks < neededChecks && double(elapsed.elapsed()) <= 1000 * maxSeconds) return;
    timer->stop();
    const int quality = path.endsWith(".jpg") ? 90 : -1;  // -1: that of the format
    const bool saved = window.grab().save(path, nullptr, quality);
    if (!saved) std::fprintf(stderr, "gonio: cannot write %s\n", qPrintable(path));
    QApplication::exit(saved ? 0 : 1);
  });
  timer->start(checkMilliseconds);
}

/// Opens the dialog of a figure with a description (a file), and measures the figure. The dialog reports a description
/// that it cannot read. @param isMeasured set to a function that returns whether every cell is measured.
FigureDialog& measureFigure(MainWindow& window, const QString& description, std::function<bool()>& isMeasured) {
  auto* dialog = new FigureDialog(window.parts().figureParts(), &window);
  FigureView& view = dialog->view();
  QObject::connect(&dialog->files(), &FigureFileButtons::opened, dialog, [&view] { view.controller().measure(); });
  dialog->show();
  dialog->files().open(description);
  isMeasured = [&view] {
    const figures::FigureMeasurement& known = view.controller().known();
    return view.isSettled() && !known.rows.empty() && known.missingCells() == 0;
  };
  return *dialog;
}

constexpr int pauseMilliseconds = 1000;

/// Opens materials one after the other, prints the times until each is read and until its first picture is displayed
/// (up to one frame too long), and ends the program. The first material is opened after one second, so that the start
/// of the program is not included, but the compilation of shaders is.
class OpeningTimes : public QObject {
 public:
  OpeningTimes(EditorParts& parts, const QStringList& paths, QObject* parent);

 private:
  void openNext();
  void adoptPicture();

  EditorParts& m_parts;
  QStringList m_paths;
  QElapsedTimer m_elapsed;
  qint64 m_read = -1;  ///< ms; -1: not read yet
  int m_before = 0;    ///< the preview's last request for the previous material
};

OpeningTimes::OpeningTimes(EditorParts& parts, const QStringList& paths, QObject* parent)
    : QObject(parent), m_parts(parts), m_paths(paths) {
  connect(&parts.document, &Document::materialChanged, this, [this] {
    if (m_elapsed.isValid()) m_read = m_elapsed.elapsed();
  });
  connect(&parts.preview, &widgets::PreviewWidget::frameRendered, this, &OpeningTimes::adoptPicture);
  connect(&parts.controller, &DocumentController::failed, this, [](const QString&, const QString& text) {
    std::fprintf(stderr, "gonio: %s\n", qPrintable(text));
    QCoreApplication::exit(1);
  });
  QTimer::singleShot(pauseMilliseconds, this, &OpeningTimes::openNext);
}

void OpeningTimes::openNext() {
  if (m_paths.isEmpty()) return QCoreApplication::exit(0);
  m_read = -1;
  m_before = m_parts.preview.lastRequest();
  m_elapsed.start();
  m_parts.controller.open(m_paths.front());
}

void OpeningTimes::adoptPicture() {
  if (m_read < 0 || m_parts.preview.shownRequest() <= m_before) return;
  std::printf("%s: read after %lld ms, first image after %lld ms\n", qPrintable(m_paths.takeFirst()),
              static_cast<long long>(m_read), static_cast<long long>(m_elapsed.elapsed()));
  std::fflush(stdout);
  m_read = -1;
  m_elapsed.invalidate();
  // The automatic fit of this material shall not slow the next one down.
  auto* wait = new QTimer(this);
  connect(wait, &QTimer::timeout, this, [this, wait] {
    if (!m_parts.tasks.isIdle()) return;
    wait->deleteLater();
    QTimer::singleShot(pauseMilliseconds, this, &OpeningTimes::openNext);
  });
  wait->start(pauseMilliseconds);
}

/// Edits the factor curves as soon as they are known.
void editFactors(FactorCurvesPanel& factors, double widening, const QString& withF1Of) {
  constexpr int checkMilliseconds = 100;
  auto* timer = new QTimer(&factors);
  QObject::connect(timer, &QTimer::timeout, &factors, [&factors, timer, widening, withF1Of] {
    if (factors.column(FactorAxis::deviation).editor().nodes().empty()) return;
    timer->stop();
    if (widening > 0) factors.widen(widening);
    if (!withF1Of.isEmpty()) factors.replaceCurve(FactorAxis::theta, withF1Of);
  });
  timer->start(checkMilliseconds);
}

/// Measures the representations of the material that is opened, and shows one of them.
void measureRepresentations(const EditorParts& parts, const QString& label) {
  StudyWindow& study = parts.study;
  QObject::connect(&parts.document, &Document::materialChanged, &study, &StudyWindow::measureOpen,
                   Qt::QueuedConnection);
  QObject::connect(&study.model(), &StudyModel::dataChanged, &study, [&study, label](const QModelIndex& index) {
    const int row = index.row();
    const bool isIt = study.model().representation(row).shortLabel() == label.toStdString();
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

/// Opens photographs and reconstructs their material.
void reconstruct(const EditorParts& parts, const QString& description) {
  PhotographSession& session = parts.photographs.session();
  QObject::connect(&session, &PhotographSession::inputsChanged, &session, &PhotographSession::reconstruct,
                   Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
  session.open({description});
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
      &parts.document, &Document::stateChanged, &parts.study,
      [&document = parts.document, &study = parts.study] {
        if (document.active<editing::DifferentialEdit>() && study.model().isEmpty() && !study.run().isRunning())
          study.fitAll();
      },
      Qt::QueuedConnection);
}

/// What the window shows at once; options that are not set change nothing.
void prepare(MainWindow& window, const QCommandLineParser& parser) {
  EditorParts& parts = window.parts();
  DockLayout& docks = window.docks();
  if (parser.isSet("plot")) parts.plots.showKind(parser.value("plot"));
  const QStringList modes{"off", "split", "flicker", "difference", "two-up"};
  if (const qsizetype mode = modes.indexOf(parser.value("compare")); mode >= 0)
    parts.comparison.setComparison({.mode = widgets::CompareMode(mode)});
  if (parser.isSet("factors")) docks.show(QStringLiteral("factors"));
  if (parser.isSet("scene")) {
    docks.show(QStringLiteral("scene"));
    parts.scene.open(parser.value("scene"));
    const QStringList others = listOf(parser.value("slots"));
    for (int slot = 0; slot < std::min(int(others.size()), SceneMaterialSlots::count); ++slot)
      parts.scene.otherSlots().read(slot, others[slot]);
  }
  if (const qulonglong coefficients = parser.value("encoded").toULongLong(); coefficients > 0) {
    parts.inspector.unfoldRepresentation();
    parts.inspector.representation()->setCoefficients(coefficients);
    parts.inspector.representation()->showEncoded().setChecked(true);
  }
  if (parser.isSet("widen") || parser.isSet("take-f1"))
    editFactors(parts.factors, parser.value("widen").toDouble(), parser.value("take-f1"));
  if (parser.isSet("interpolate")) {
    docks.show(QStringLiteral("interpolation"));
    interpolate(parts, listOf(parser.value("interpolate")));
  }
  if (const int samples = parser.value("acquire").toInt(); samples > 0) {
    docks.showWorkspace(DockLayout::Workspace::acquire);
    acquire(parts, samples, parser.value("acquisition-page").toInt());
  }
  if (parser.isSet("photographs")) {
    docks.showWorkspace(DockLayout::Workspace::acquire);
    docks.show(QStringLiteral("photographs"));
    reconstruct(parts, parser.value("photographs"));
  }
  if (parser.isSet("study")) {
    parts.study.present(StudyWindow::ChartPage);
    measureRepresentations(parts, parser.value("study"));
  }
  if (parser.isSet("models")) {
    parts.study.present(StudyWindow::ResultsPage);
    rankFits(parts);
  }
}

constexpr qint64 longNanoseconds = 50'000'000;

QString described(const QObject* receiver, QEvent::Type type) {
  const char* name = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
  const QString owner = receiver->objectName().isEmpty() && receiver->parent()
                            ? QStringLiteral("child of ") + receiver->parent()->metaObject()->className()
                            : receiver->objectName();
  return QStringLiteral("%1 (%2) %3")
      .arg(receiver->metaObject()->className(), owner, name ? QString(name) : QString::number(type));
}

}  // namespace

void DevelopmentApplication::addOptions(QCommandLineParser& parser) {
  for (const Option& one : options) {
    QCommandLineOption option(one.name);
    if (one.value) option.setValueName(one.value);
    option.setFlags(QCommandLineOption::HiddenFromHelp);
    parser.addOption(option);
  }
}

std::optional<int> DevelopmentApplication::run(const QCommandLineParser& parser,
                                               const std::function<void(MainWindow& first)>& openFiles) {
  if (std::ranges::none_of(options, [&](const Option& one) { return parser.isSet(one.name); })) return std::nullopt;
  if (parser.isSet("thumbnails")) return writeThumbnails(parser.value("thumbnails"));
  if (parser.isSet("theme")) applyTheme(*this, themeByName(parser.value("theme")));
  auto* window = new MainWindow;
  if (const QSize size = sizeOf(parser.value("size")); size.isValid()) window->resize(size);
  window->show();
  prepare(*window, parser);
  if (parser.isSet("opening-times")) {
    new OpeningTimes(window->parts(), parser.positionalArguments(), window);
    return exec();
  }
  if (parser.isSet("screenshot")) {
    std::function<bool()> isSettled = [window] { return window->parts().isSettled(); };
    QWidget* shown =
        parser.isSet("study") || parser.isSet("models") ? static_cast<QWidget*>(&window->parts().study) : window;
    if (parser.isSet("figure")) shown = &measureFigure(*window, parser.value("figure"), isSettled);
    takeScreenshot(*shown, isSettled, parser.value("screenshot"),
                   parser.isSet("wait") ? parser.value("wait").toDouble() : 60);
  }
  openFiles(*window);
  m_timing = parser.isSet("event-times");
  const int result = exec();
  if (m_timing) std::fputs(qPrintable(eventTimes()), stdout);
  return result;
}

bool DevelopmentApplication::notify(QObject* receiver, QEvent* event) {
  return m_timing && receiver->thread() == thread() ? timed(receiver, event) : QApplication::notify(receiver, event);
}

bool DevelopmentApplication::timed(QObject* receiver, QEvent* event) {
  const int level = thread()->loopLevel();
  if (!m_stack.empty()) {
    if (m_stack.back().loopLevel == level) return QApplication::notify(receiver, event);
    m_stack.back().hasNestedLoop = true;
  }
  // The receiver may be gone when it has handled the event.
  const QEvent::Type type = event->type();
  const QString what = described(receiver, type);
  m_stack.push_back({level, false});
  QElapsedTimer elapsed;
  elapsed.start();
  const bool result = QApplication::notify(receiver, event);
  const qint64 nanoseconds = elapsed.nsecsElapsed();
  if (!m_stack.back().hasNestedLoop) {
    ++m_events;
    if (nanoseconds > longNanoseconds) m_long.push_back({what, nanoseconds});
  }
  m_stack.pop_back();
  return result;
}

QString DevelopmentApplication::eventTimes() const {
  struct Kind {
    int count = 0;
    qint64 longest = 0;
  };
  std::map<QString, Kind> kinds;
  for (const Long& event : m_long) {
    Kind& kind = kinds[event.what];
    ++kind.count;
    kind.longest = std::max(kind.longest, event.nanoseconds);
  }
  std::vector<std::pair<QString, Kind>> sorted(kinds.begin(), kinds.end());
  std::ranges::sort(sorted, std::greater{}, [](const auto& entry) { return entry.second.longest; });
  QString text = QStringLiteral("%1 events, %2 longer than 50 ms\n").arg(m_events).arg(m_long.size());
  for (const auto& [what, kind] : sorted)
    text += QStringLiteral("%1 ms at most, %2 times: %3\n")
                .arg(double(kind.longest) * 1e-6, 0, 'f', 0)
                .arg(kind.count)
                .arg(what);
  return text;
}

}  // namespace gonio::app
