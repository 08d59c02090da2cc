// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_controller.h"

#include <QPointer>

#include "core/figures/draw_figure.h"
#include "core/figures/figure_formats.h"

namespace gonio::app {

namespace {

using namespace figures;

constexpr double millimetresPerInch = 25.4;

QImage pageImage(const Raster& raster) {
  return QImage(raster.rgba.data(), raster.width, raster.height, 4 * raster.width, QImage::Format_RGBA8888).copy();
}

/// Not for the GUI thread.
DrawnFigure drawnFigure(const FigureDescription& description, const FigureMeasurement& known, int pageWidth) {
  checkFigure(description);
  const FigureMeasurement part = knownPart(description, known);
  const TextWidth width = cairoTextWidth(description.font);
  const FigureLayout layout = figureLayout(description, part, width);
  const double dotsPerInch = pageWidth / layout.width * millimetresPerInch;
  DrawnFigure drawn{.page = pageImage(figureRaster(drawFigure(description, part, width), dotsPerInch)),
                    .cells = description.materials.size() * description.representations.size(),
                    .missing = part.missingCells(),
                    .errorMaximum = errorMaximum(description, part)};
  for (const auto& row : layout.cells)
    for (const CellLayout& cell : row)
      drawn.pictures.emplace_back(cell.picture.x / layout.width, cell.picture.y / layout.height,
                                  cell.picture.width / layout.width, cell.picture.height / layout.height);
  return drawn;
}

}  // namespace

FigureController::FigureController(BackgroundTasks& tasks, QObject* parent)
    : QObject(parent),
      m_tasks(tasks),
      m_drawKey(QStringLiteral("figure page %1").arg(quintptr(this))),
      m_measureKey(QStringLiteral("figure %1").arg(quintptr(this))) {
  connect(&m_tasks, &BackgroundTasks::changed, this, &FigureController::progressed);
}

FigureController::~FigureController() {
  for (const QString& key : {m_drawKey, m_measureKey}) m_tasks.drop(key);
}

void FigureController::setDescription(const FigureDescription& description) {
  // The results of the running measurement would not be used.
  if (!rendersTheSame(m_description.pictures, description.pictures)) cancel();
  m_description = description;
  draw();
}

void FigureController::setPageWidth(int pixels) {
  if (std::exchange(m_pageWidth, pixels) != pixels) draw();
}

void FigureController::draw() {
  m_tasks.drop(m_drawKey);
  if (m_pageWidth <= 0 || m_description.materials.empty() || m_description.representations.empty()) return;
  m_tasks.run<DrawnFigure>(
      {.title = tr("Drawing the figure"), .key = m_drawKey, .live = true},
      [description = m_description, known = m_known, width = m_pageWidth](const TaskControl&) {
        return drawnFigure(description, known, width);
      },
      [this](const DrawnFigure& figure) { Q_EMIT drawn(figure); },
      [this](const QString& error) { Q_EMIT refused(error); });
}

bool FigureController::isDrawing() const { return m_tasks.isRunning(m_drawKey); }
bool FigureController::isMeasuring() const { return m_tasks.isRunning(m_measureKey); }
std::optional<double> FigureController::progress() const { return m_tasks.progress(m_measureKey); }
void FigureController::cancel() { m_tasks.cancel(m_measureKey); }

std::function<void(const FigureMeasurement&)> FigureController::collector() {
  // Through the thread of the tasks; the figure may be deleted by then.
  return [controller = QPointer(this), tasks = &m_tasks](const FigureMeasurement& measurement) {
    QMetaObject::invokeMethod(
        tasks,
        [controller, measurement] {
          if (!controller) return;
          controller->m_known = measurement;
          controller->draw();
        },
        Qt::QueuedConnection);
  };
}

void FigureController::measure() {
  if (isMeasuring()) return;
  m_tasks.run<bool>(
      {.title = tr("Measuring the cells of the figure"), .key = m_measureKey, .isLong = true},
      [description = m_description, known = m_known, collect = collector()](const TaskControl& control) {
        measureFigure(description, control, {.known = known, .measured = collect});
        return true;
      },
      [](bool) {}, [this](const QString& error) { Q_EMIT failed(error); });
}

}  // namespace gonio::app

#include "moc_figure_controller.cpp"
