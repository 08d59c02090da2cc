// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/slice_plot.h"

#include <QMouseEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/coordinates/coordinate_systems.h"
#include "core/plots/plotted_values.h"
#include "core/rendering/error_maps.h"
#include "widgets/charts/custom_plot_style.h"
#include "widgets/inputs/number_field.h"
#include "widgets/plots/plot_series.h"

namespace gonio::widgets {

namespace {

/// The colour map of core/rendering/error_maps.h for QCustomPlot; cells with NaN stay transparent.
QCPColorGradient viridisGradient() {
  constexpr int stops = 32;
  QCPColorGradient gradient;
  gradient.clearColorStops();
  for (int i = 0; i <= stops; ++i) {
    const rendering::DisplayColour colour = rendering::viridis(double(i) / stops);
    gradient.setColorStopAt(double(i) / stops, QColor(colour[0], colour[1], colour[2]));
  }
  gradient.setNanHandling(QCPColorGradient::nhTransparent);
  return gradient;
}

/// One colour for all numbers.
QCPColorGradient plainGradient(const QColor& colour) {
  QCPColorGradient gradient;
  gradient.setColorStops({{0, colour}, {1, colour}});
  gradient.setNanHandling(QCPColorGradient::nhTransparent);
  return gradient;
}

bool isAngle(const plots::SliceAxes& axes) { return coordinateSystemNamed(axes.system).columns[axes.across].isAngle; }

/// A value of the horizontal axis as a fraction of it.
double acrossFraction(const plots::Slice& slice, double across) {
  return plots::thetaHFraction(slice.spacing, halfPi * across / plots::axesOf(slice.coordinates).acrossEnd);
}

/// Labels on the horizontal axis, in degrees where it is an angle; its keys are fractions.
QSharedPointer<QCPAxisTicker> acrossTicker(const plots::Slice& slice) {
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  const bool linear = slice.spacing == plots::ThetaHSpacing::linear, angle = isAngle(plots::axesOf(slice.coordinates));
  const QList<double> marks =
      angle    ? linear ? QList<double>{0, 15, 30, 45, 60, 75, 90} : QList<double>{0, 1, 5, 10, 20, 30, 45, 60, 90}
         : linear ? QList<double>{0, 0.5, 1, 1.5, 2}
               : QList<double>{0, 0.02, 0.1, 0.25, 0.5, 1, 1.5, 2};
  for (const double mark : marks)
    ticker->addTick(acrossFraction(slice, angle ? radians(mark) : mark), QString::number(mark));
  return ticker;
}

QSharedPointer<QCPAxisTicker> upTicker() {
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (int mark = 0; mark <= 90; mark += 15) ticker->addTick(mark, QString::number(mark));
  return ticker;
}

/// Of a logarithmic colour scale: a few cells near 0 must not take the contrast from all others.
constexpr int maxDecades = 5;
/// Where the scale ends: the grazing peak of a few cells would leave the rest dark.
constexpr double shownFraction = 0.99;

double largestOf(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}
}  // namespace

SlicePlot::SlicePlot(QWidget* parent)
    : Plot(tr("Slice"), parent), m_chart(new QCustomPlot(this)), m_margins(new QCPMarginGroup(m_chart)) {
  setAccessibleDescription(tr("BRDF values over two coordinates, in false colour."));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_chart);
  m_chart->setFocusProxy(this);
  m_chart->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  m_chart->setMouseTracking(true);
  m_chart->installEventFilter(this);
  m_chart->plotLayout()->clear();
  m_bar = new QCPColorScale(m_chart);
  m_bar->setGradient(viridisGradient());
  m_bar->setRangeDrag(false);
  m_bar->setRangeZoom(false);
  m_bar->setMarginGroup(QCP::msTop | QCP::msBottom, m_margins);
  m_chart->plotLayout()->addElement(1, 0, m_bar);
}

SlicePlot::~SlicePlot() = default;

void SlicePlot::setSeries(PlotSeriesList<plots::Slice> series) {
  const bool otherPanels = series.size() != m_panels.size();
  m_series = std::move(series);
  m_chart->setVisible(!isEmpty());
  if (otherPanels) buildPanels();
  showEmptiness();
  refresh();
}

void SlicePlot::buildPanels() {
  m_chart->plotLayout()->take(m_bar);
  m_chart->clearPlottables();
  m_chart->clearItems();
  m_panels.clear();
  m_chart->plotLayout()->clear();
  for (int column = 0; column < int(m_series.size()); ++column) addPanel(column);
  m_chart->plotLayout()->addElement(1, int(m_series.size()), m_bar);
  m_chart->plotLayout()->setColumnStretchFactor(int(m_series.size()), 0.01);
  m_chart->plotLayout()->setRowSpacing(0);
}

void SlicePlot::addPanel(int column) {
  Panel panel{};
  panel.title = new QCPTextElement(m_chart);
  panel.rect = new QCPAxisRect(m_chart);
  m_chart->plotLayout()->addElement(0, column, panel.title);
  m_chart->plotLayout()->addElement(1, column, panel.rect);
  panel.rect->setMarginGroup(QCP::msTop | QCP::msBottom, m_margins);
  QCPAxis *across = panel.rect->axis(QCPAxis::atBottom), *up = panel.rect->axis(QCPAxis::atLeft);
  for (QCPAxis* axis : panel.rect->axes()) {
    axis->setLayer(QStringLiteral("axes"));
    axis->grid()->setVisible(false);
  }
  panel.values = new QCPColorMap(across, up);
  panel.notMeasured = new QCPColorMap(across, up);
  for (QCPColorMap* map : {panel.values, panel.notMeasured}) {
    map->setInterpolate(false);
    map->setTightBoundary(false);
  }
  panel.line = new QCPItemStraightLine(m_chart);
  for (QCPItemPosition* point : {panel.line->point1, panel.line->point2}) {
    point->setAxisRect(panel.rect);
    point->setAxes(across, up);
  }
  panel.line->setClipAxisRect(panel.rect);
  // All slices move together.
  if (!m_panels.empty()) {
    QCPAxisRect* first = m_panels.front().rect;
    for (const auto type : {QCPAxis::atBottom, QCPAxis::atLeft}) {
      QCPAxis *leader = first->axis(type), *follower = panel.rect->axis(type);
      const auto set = qOverload<const QCPRange&>(&QCPAxis::setRange);
      connect(leader, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), follower, set);
      connect(follower, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), leader, set);
    }
  }
  m_panels.push_back(panel);
}

void SlicePlot::refresh() {
  std::vector<double> values;
  for (const auto& series : m_series)
    for (std::size_t i = 0; i < series.data.cells.values.size(); ++i)
      values.push_back(series.data.cells.at(i, settings().channel));
  m_scale = plots::scaleFor(values, settings().logarithmic, maxDecades, shownFraction);
  m_largest = largestOf(values);
  m_bar->setDataScaleType(settings().logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
  m_bar->setDataRange(QCPRange(m_scale.min, m_scale.max));
  for (std::size_t i = 0; i < m_panels.size(); ++i) fillPanel(m_panels[i], m_series[i].data);
  apply(style());
  setRanges();
  m_chart->replot(QCustomPlot::rpQueuedReplot);
}

void SlicePlot::fillPanel(const Panel& panel, const plots::Slice& slice) {
  // Keys are fractions of the horizontal axis, values degrees of the vertical one, both at the middle of cells.
  const QCPRange across(0.5 / slice.width, 1 - 0.5 / slice.width);
  const QCPRange up(45.0 / slice.height, 90 - 45.0 / slice.height);
  for (QCPColorMap* map : {panel.values, panel.notMeasured}) {
    map->data()->setSize(slice.width, slice.height);
    map->data()->setRange(across, up);
  }
  for (int row = 0; row < slice.height; ++row)
    for (int column = 0; column < slice.width; ++column) {
      const std::size_t i = slice.index(column, row);
      const double value = slice.cells.at(i, settings().channel);
      panel.values->data()->setCell(column, row, std::isnan(value) ? value : std::max(value, m_scale.min));
      panel.notMeasured->data()->setCell(column, row,
                                         slice.cells.states[i] == plots::PointState::notMeasured ? 1 : std::nan(""));
    }
  panel.values->setGradient(viridisGradient());
  panel.values->setDataScaleType(m_bar->dataScaleType());
  panel.values->setDataRange(m_bar->dataRange());
}

void SlicePlot::apply(const PlotStyle& style) {
  styleChart(*m_chart, style, font());
  styleAxis(*m_bar->axis(), style, font());
  setLogarithmic(*m_bar->axis(), settings().logarithmic);
  m_bar->axis()->setLabel(m_largest > m_scale.max
                              ? tr("%1\ndata maximum: %2").arg(valueTitle(settings()), formatNumber(m_largest))
                              : valueTitle(settings()));
  for (std::size_t i = 0; i < m_panels.size(); ++i) {
    const Panel& panel = m_panels[i];
    const plots::Slice& slice = m_series[i].data;
    panel.title->setText(m_series[i].name);
    panel.title->setFont(font());
    panel.title->setTextColor(style.text);
    panel.rect->setBackground(QBrush(style.grid, Qt::BDiagPattern));
    panel.notMeasured->setGradient(plainGradient(style.grid));
    panel.notMeasured->setDataRange(QCPRange(0, 2));
    const plots::SliceAxes& axes = plots::axesOf(slice.coordinates);
    const QString unit = isAngle(axes) ? QStringLiteral(" [°]") : QString();
    panel.rect->axis(QCPAxis::atBottom)->setTicker(acrossTicker(slice));
    panel.rect->axis(QCPAxis::atBottom)
        ->setLabel(QStringLiteral("%1%2, %3 = %4")
                       .arg(QString::fromUtf8(axes.acrossSymbol), unit, QString::fromUtf8(axes.azimuthSymbol),
                            degreesText(slice.azimuth)));
    panel.rect->axis(QCPAxis::atLeft)->setTicker(upTicker());
    panel.rect->axis(QCPAxis::atLeft)->setLabel(QString::fromUtf8(axes.upSymbol) + QStringLiteral(" [°]"));
    panel.line->setPen(QPen(style.accent, 1.5, Qt::DashLine));
    panel.line->point1->setCoords(0, degrees(settings().thetaI));
    panel.line->point2->setCoords(1, degrees(settings().thetaI));
  }
}

void SlicePlot::setRanges() {
  if (m_viewChanged) return;
  for (const Panel& panel : m_panels) {
    panel.rect->axis(QCPAxis::atBottom)->setRange(0, 1);
    panel.rect->axis(QCPAxis::atLeft)->setRange(0, 90);
  }
}

void SlicePlot::resetView() {
  m_viewChanged = false;
  refresh();
}

void SlicePlot::drawOn(QPaintDevice& device, const QSize& size, const PlotStyle& paper) {
  // Pictures cannot be cut as lines can: the whole slices are drawn, however far the view is zoomed.
  if (m_panels.empty()) return;
  const QCPAxisRect* first = m_panels.front().rect;
  const QCPRange across = first->axis(QCPAxis::atBottom)->range(), up = first->axis(QCPAxis::atLeft)->range();
  const bool changed = std::exchange(m_viewChanged, false);
  setRanges();
  apply(paper);
  paintChart(*m_chart, device, size);
  m_viewChanged = changed;
  first->axis(QCPAxis::atBottom)->setRange(across);
  first->axis(QCPAxis::atLeft)->setRange(up);
  apply(style());
  m_chart->replot(QCustomPlot::rpQueuedReplot);
}

io::CsvTable SlicePlot::table() const {
  io::CsvTable table{commentsOfTable(), {}};
  table.comments.push_back("values: " + valueForCsv(settings()) + "; empty: below the horizon or not measured");
  if (m_series.empty()) return table;
  const plots::Slice& first = m_series.front().data;
  const plots::SliceAxes& axes = plots::axesOf(first.coordinates);
  const std::vector<CoordinateColumn>& columns = coordinateSystemNamed(axes.system).columns;
  const auto title = [&](std::size_t column) {
    return std::string(columns[column].name) + (columns[column].isAngle ? " [degrees]" : "");
  };
  const double unit = isAngle(axes) ? degrees(1) : 1;
  table.comments.push_back(angleForCsv(std::string(columns[axes.azimuth].name), first.azimuth));
  table.columns = {{title(axes.across), {}}, {title(axes.up), {}}};
  for (int row = 0; row < first.height; ++row)
    for (int column = 0; column < first.width; ++column) {
      table.columns[0].values.push_back(unit * first.across(column));
      table.columns[1].values.push_back(degrees(first.up(row)));
    }
  for (const auto& series : m_series) {
    io::CsvColumn column{series.name.toStdString() + " [1/sr]", {}};
    for (std::size_t i = 0; i < series.data.cells.values.size(); ++i)
      column.values.push_back(series.data.cells.at(i, settings().channel));
    table.columns.push_back(std::move(column));
  }
  return table;
}

QPointF SlicePlot::position(std::size_t slice, double across, double up) const {
  const Panel& panel = m_panels[slice];
  return {panel.rect->axis(QCPAxis::atBottom)->coordToPixel(acrossFraction(m_series[slice].data, across)),
          panel.rect->axis(QCPAxis::atLeft)->coordToPixel(degrees(up))};
}

std::optional<std::size_t> SlicePlot::panelAt(const QPointF& position) const {
  for (std::size_t i = 0; i < m_panels.size(); ++i)
    if (m_panels[i].rect->rect().contains(position.toPoint())) return i;
  return std::nullopt;
}

double SlicePlot::upAt(const Panel& panel, const QPointF& position) const {
  return radians(panel.rect->axis(QCPAxis::atLeft)->pixelToCoord(position.y()));
}

bool SlicePlot::isOnLine(const QPointF& at) const {
  return panelAt(at) &&
         std::abs(at.y() - position(*panelAt(at), 0, settings().thetaI).y()) < fontMetrics().height() * 0.4;
}

void SlicePlot::pointerMoved(const QPointF& at) {
  m_chart->setCursor(isOnLine(at) ? Qt::SplitVCursor : Qt::CrossCursor);
  const auto under = panelAt(at);
  if (!under) return showReadout({});
  const Panel& panel = m_panels[*under];
  const plots::Slice& slice = m_series[*under].data;
  const double fraction = panel.rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x()), up = upAt(panel, at);
  const int column = int(fraction * slice.width), row = int(up / halfPi * slice.height);
  if (fraction < 0 || up < 0 || column >= slice.width || row >= slice.height) return showReadout({});
  const plots::SliceAxes& axes = plots::axesOf(slice.coordinates);
  const double across = slice.across(column);
  QStringList lines{QStringLiteral("%1 = %2, %3 = %4")
                        .arg(QString::fromUtf8(axes.acrossSymbol),
                             isAngle(axes) ? degreesText(across) : formatNumber(across),
                             QString::fromUtf8(axes.upSymbol), degreesText(slice.up(row)))};
  for (const auto& series : m_series) {
    const std::size_t i = series.data.index(column, row);
    lines << QStringLiteral("%1: %2").arg(
        series.name, valueText(series.data.cells.at(i, settings().channel), series.data.cells.states[i]));
  }
  showReadout(lines.join('\n'), at);
}

bool SlicePlot::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_chart) return Plot::eventFilter(watched, event);
  auto* mouse = dynamic_cast<QMouseEvent*>(event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      setFocus(Qt::MouseFocusReason);
      m_draggingLine = mouse->button() == Qt::LeftButton && isOnLine(mouse->position());
      return m_draggingLine;
    case QEvent::MouseMove:
      if (m_draggingLine) editThetaI(upAt(m_panels.front(), mouse->position()));
      if (!m_draggingLine && mouse->buttons() & Qt::LeftButton) m_viewChanged = true;
      pointerMoved(mouse->position());
      return m_draggingLine;
    case QEvent::MouseButtonRelease:
      m_draggingLine = false;
      return false;
    case QEvent::MouseButtonDblClick:
      resetView();
      return true;
    case QEvent::Wheel:
      m_viewChanged = true;
      return false;
    default:
      return false;
  }
}

}  // namespace gonio::widgets

#include "moc_slice_plot.cpp"
