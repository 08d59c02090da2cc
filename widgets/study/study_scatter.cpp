// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/study/study_scatter.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/charts/custom_plot_style.h"

namespace gonio::widgets {

namespace {

constexpr double fitMarkerSize = 8, fitRingSize = 17, currentSize = 13;
/// How near the pointer has to be, px.
constexpr double reach = 12;

/// The shape of the exported plot.
QCPScatterStyle scatterStyle(plots::Marker marker, const QColor& colour, const QBrush& fill) {
  constexpr double penWidth = 1.5, pathSize = 6;  // QCustomPlot scales paths of this size and their pen
  const auto corners = plots::markerOutline(marker, pathSize / 2);
  if (corners.empty()) return QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(colour, penWidth), fill, fitMarkerSize);
  QPolygonF polygon;
  for (const glm::dvec2& corner : corners) polygon << QPointF(corner.x, corner.y);
  QPainterPath path;
  path.addPolygon(polygon);
  path.closeSubpath();
  return QCPScatterStyle(path, QPen(colour, penWidth * pathSize / fitMarkerSize), fill, fitMarkerSize);
}

/// That of the exported plot, legible on the background.
QColor colourOn(const PlotStyle& style, std::string_view css) {
  const QColor colour(QString::fromUtf8(css.data(), qsizetype(css.size())));
  if (colour == QColor(Qt::black)) return style.text;
  return style.dark ? colour.lighter(145) : colour;
}

/// Of an axis that runs from 0 to 1: whole markers and their names fit in.
constexpr double lowEnd = -0.03, highEnd = 1.07;

void setTicks(QCPAxis& axis, const study::StudyAxis& of, const std::string& title) {
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (const auto& [position, text] : of.ticks()) ticker->addTick(position, QString::fromStdString(text));
  axis.setTicker(ticker);
  axis.setSubTicks(false);
  axis.setRange(lowEnd, highEnd);
  axis.setLabel(QString::fromStdString(title));
}

}  // namespace

StudyScatter::StudyScatter(QWidget* parent)
    : QWidget(parent), m_chart(new QCustomPlot(this)), m_hint(new QLabel(m_chart)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_chart);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Accuracy vs. cost"));
  setAccessibleDescription(
      tr("One point for each representation; the left and right arrow keys step through them by cost."));
  m_chart->setObjectName(QStringLiteral("chart"));
  m_chart->setFocusProxy(this);
  m_chart->setMouseTracking(true);
  m_chart->installEventFilter(this);
  m_chart->legend->setVisible(true);
  m_chart->axisRect()->setupFullAxesBox(true);
  // Beside the axes: wherever it lay inside, it would cover points.
  auto* beside = new QCPLayoutGrid;
  m_chart->plotLayout()->addElement(0, 1, beside);
  beside->addElement(0, 0, m_chart->legend);
  beside->addElement(1, 0, new QCPLayoutElement);
  beside->setMargins(QMargins(4, 8, 4, 4));
  m_chart->legend->setFillOrder(QCPLegend::foRowsFirst);
  m_chart->plotLayout()->setColumnStretchFactor(1, 0.001);
  beside->setRowStretchFactor(0, 0.001);
  m_hint->setAlignment(Qt::AlignCenter);
  m_hint->setWordWrap(true);
  m_hint->setForegroundRole(QPalette::PlaceholderText);
  m_hint->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* over = new QVBoxLayout(m_chart);
  over->addWidget(m_hint);
  refresh();
}

QSize StudyScatter::sizeHint() const { return QSize(34, 20) * fontMetrics().height(); }
QSize StudyScatter::minimumSizeHint() const { return QSize(20, 9) * fontMetrics().height(); }

void StudyScatter::setRecords(std::vector<study::StudyRecord> records, const study::StudyAxes& axes) {
  m_records = std::move(records);
  m_axes = axes;
  m_geometry = study::studyGeometry(m_records, axes);
  const int last = int(m_records.size()) - 1;
  m_shown = std::min(m_shown, last);
  m_best = std::min(m_best, last);
  m_current = std::min(m_current, last);
  refresh();
}

void StudyScatter::setMarks(int shown, int best) {
  m_shown = shown;
  m_best = best;
  refresh();
}

void StudyScatter::setCurrent(int record) {
  if (record == m_current) return;
  m_current = record;
  refresh();
}

void StudyScatter::setHint(const QString& hint) { m_hint->setText(hint); }

std::optional<QPointF> StudyScatter::fraction(int record) const {
  if (record < 0 || record >= int(m_records.size()) || !m_geometry.places[std::size_t(record)]) return std::nullopt;
  const glm::dvec2 at = *m_geometry.places[std::size_t(record)];
  return QPointF(at.x, at.y);
}

std::optional<QPointF> StudyScatter::place(int record) const {
  const auto at = fraction(record);
  if (!at) return std::nullopt;
  return QPointF(m_chart->xAxis->coordToPixel(at->x()), m_chart->yAxis->coordToPixel(at->y()));
}

void StudyScatter::refresh() {
  const PlotStyle style = PlotStyle::of(palette());
  m_chart->clearPlottables();
  m_chart->clearItems();
  addAxes(style);
  addFront(style);
  addSeries(style);
  if (hasFocus()) addMark(m_current, {}, QPen(style.accent, 2, Qt::DotLine), currentSize, false);
  addMark(m_shown, tr("shown"), QPen(style.accent, 2), fitRingSize, false);
  addMark(m_best, tr("best"), QPen(style.text, 1.5, Qt::DashLine), fitRingSize + 4, true);
  const bool hasPoints = std::ranges::any_of(m_geometry.places, [](const auto& place) { return place.has_value(); });
  m_hint->setVisible(!hasPoints);
  m_chart->legend->setVisible(hasPoints);
  for (QCPAxis* axis : m_chart->axisRect()->axes()) axis->setVisible(hasPoints);
  m_chart->replot(QCustomPlot::rpQueuedReplot);
}

void StudyScatter::addAxes(const PlotStyle& style) {
  styleChart(*m_chart, style, font());
  m_chart->legend->setIconSize(3 * fontMetrics().height() / 2, fontMetrics().height());
  setTicks(*m_chart->xAxis, m_geometry.costs, study::axisTitle(m_axes.cost));
  setTicks(*m_chart->yAxis, m_geometry.qualities, study::axisTitle(m_axes.quality));
  for (QCPAxis* axis : {m_chart->xAxis2, m_chart->yAxis2}) {
    axis->setTicks(false);
    axis->setRange(lowEnd, highEnd);
  }
}

void StudyScatter::addSeries(const PlotStyle& style) {
  for (const study::StudySeries& series : m_geometry.series) {
    const study::RepresentationKind& kind = *series.kind;
    const std::string_view name = kind.legendName();
    auto* curve = new QCPCurve(m_chart->xAxis, m_chart->yAxis);
    const QColor colour = colourOn(style, kind.family->colour);
    curve->setName(QString::fromUtf8(name.data(), qsizetype(name.size())));
    curve->setPen(QPen(colour, 1));
    if (!series.isLine) curve->setLineStyle(QCPCurve::lsNone);
    curve->setScatterStyle(scatterStyle(kind.style.marker, colour, kind.style.hollow ? style.background : colour));
    int t = 0;
    for (const std::size_t i : series.records)
      if (const auto at = fraction(int(i))) curve->addData(t++, at->x(), at->y());
  }
}

void StudyScatter::addFront(const PlotStyle& style) {
  if (m_records.empty()) return;
  auto* front = new QCPCurve(m_chart->xAxis, m_chart->yAxis);
  front->setName(tr("Pareto front"));
  QColor colour = style.text;
  colour.setAlphaF(0.5f);
  front->setPen(QPen(colour, 2, Qt::DashLine));
  int t = 0;
  for (const glm::dvec2& corner : m_geometry.frontSteps) front->addData(t++, corner.x, corner.y);
}

void StudyScatter::addMark(int record, const QString& word, const QPen& pen, double size, bool square) {
  const auto at = fraction(record);
  if (!at) return;
  auto* ring = new QCPCurve(m_chart->xAxis, m_chart->yAxis);
  ring->removeFromLegend();
  ring->setScatterStyle(
      QCPScatterStyle(square ? QCPScatterStyle::ssSquare : QCPScatterStyle::ssCircle, pen, QBrush(Qt::NoBrush), size));
  ring->addData(0, at->x(), at->y());
  if (word.isEmpty()) return;
  auto* text = new QCPItemText(m_chart);
  text->setText(word);
  text->setFont(font());
  text->setColor(pen.color());
  text->position->setCoords(at->x(), at->y());
  text->setPadding(QMargins(14, 0, 14, 0));
  text->setPositionAlignment(Qt::AlignVCenter | (square ? Qt::AlignLeft : Qt::AlignRight));
  text->setClipToAxisRect(false);
}

int StudyScatter::nearest(const QPointF& position) const {
  int found = -1;
  double least = reach;
  for (int i = 0; i < int(m_records.size()); ++i) {
    const auto at = place(i);
    if (!at) continue;
    const double distance = std::hypot(at->x() - position.x(), at->y() - position.y());
    if (distance < least) {
      least = distance;
      found = i;
    }
  }
  return found;
}

void StudyScatter::step(int by) {
  std::vector<std::pair<double, int>> order;
  for (int i = 0; i < int(m_records.size()); ++i)
    if (const auto at = fraction(i)) order.emplace_back(at->x(), i);
  if (order.empty()) return;
  std::ranges::sort(order);
  const auto found = std::ranges::find(order, m_current, &std::pair<double, int>::second);
  const auto last = std::ptrdiff_t(order.size()) - 1;
  const std::ptrdiff_t next =
      found == order.end() ? (by > 0 ? 0 : last) : std::clamp<std::ptrdiff_t>(found - order.begin() + by, 0, last);
  setCurrent(order[std::size_t(next)].second);
  Q_EMIT currentChanged(m_current);
}

void StudyScatter::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
      return step(-1);
    case Qt::Key_Right:
    case Qt::Key_Up:
      return step(1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (m_current >= 0) Q_EMIT activated(m_current);
      return;
    case Qt::Key_Space:
      if (m_current >= 0) Q_EMIT chosen(m_current);
      return;
    case Qt::Key_Escape:
      Q_EMIT dismissed();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void StudyScatter::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) refresh();
}

void StudyScatter::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  refresh();
}

void StudyScatter::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  refresh();
}

bool StudyScatter::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_chart) return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::Leave) Q_EMIT hovered(-1, {});
  const auto* mouse = dynamic_cast<QMouseEvent*>(event);
  if (!mouse) return false;
  const int record = nearest(mouse->position());
  if (event->type() == QEvent::MouseMove) {
    m_chart->setCursor(record >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    Q_EMIT hovered(record, mouse->globalPosition().toPoint());
  }
  if (event->type() == QEvent::MouseButtonDblClick && record >= 0) Q_EMIT activated(record);
  if (event->type() == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton) {
    setFocus(Qt::MouseFocusReason);
    if (record < 0) return false;
    setCurrent(record);
    Q_EMIT currentChanged(record);
    Q_EMIT chosen(record);
  }
  return false;
}

}  // namespace gonio::widgets

#include "moc_study_scatter.cpp"
