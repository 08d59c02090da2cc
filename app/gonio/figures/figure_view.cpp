// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_view.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/figures/figure_page.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

namespace {

constexpr int resizeDelayMilliseconds = 120, barSteps = 100;

std::optional<QRectF> squareOf(const std::optional<figures::FigureInset>& inset) {
  if (!inset) return std::nullopt;
  return QRectF(inset->x, inset->y, inset->size, inset->size);
}

}  // namespace

FigureView::FigureView(BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_tasks(tasks),
      m_controller(new FigureController(tasks, this)),
      m_page(new widgets::FigurePage),
      m_status(new QLabel),
      m_bar(new QProgressBar),
      m_measure(new QPushButton) {
  build();
  connectParts();
  refresh();
}

void FigureView::build() {
  auto* scroll = new QScrollArea;
  scroll->setWidget(m_page);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::StrongFocus);
  scroll->setAccessibleName(tr("Page"));
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // A scroll bar that appears and disappears would change the width, which determines the height of the page.
  scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  m_status->setWordWrap(true);
  m_status->setTextFormat(Qt::PlainText);
  m_status->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_status->setMinimumHeight(2 * fontMetrics().lineSpacing());
  m_bar->setRange(0, barSteps);
  m_bar->setFixedWidth(fontMetrics().averageCharWidth() * 18);
  m_measure->setAutoDefault(false);
  auto* whole = new QCheckBox(tr("W&hole page"));
  whole->setToolTip(tr("Scales the page to fit the view"));
  connect(whole, &QCheckBox::toggled, m_page, &widgets::FigurePage::setWhole);
  auto* row = new QHBoxLayout;
  row->addWidget(m_status, 1);
  row->addWidget(whole);
  row->addWidget(m_bar);
  row->addWidget(m_measure);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll, 1);
  layout->addLayout(row);
}

void FigureView::connectParts() {
  m_resized.setSingleShot(true);
  m_resized.setInterval(resizeDelayMilliseconds);
  connect(m_page, &widgets::FigurePage::resized, &m_resized, qOverload<>(&QTimer::start));
  connect(&m_resized, &QTimer::timeout, this, [this] { m_controller->setPageWidth(m_page->pageWidth()); });
  connect(m_page, &widgets::FigurePage::squareDrawn, this, [this](const QRectF& square) {
    // Three decimals: drawing by hand is no more exact.
    const auto rounded = [](double fraction) { return std::round(fraction * 1000) / 1000; };
    const double size = std::max(rounded(square.width()), figures::FigureInset::minSize), most = 1 - size;
    Q_EMIT insetDrawn(
        {.x = std::min(rounded(square.x()), most), .y = std::min(rounded(square.y()), most), .size = size});
  });
  connect(m_controller, &FigureController::drawn, this, &FigureView::showFigure);
  connect(m_controller, &FigureController::refused, this, [this](const QString& reason) {
    m_cells = m_missing = 0;
    m_page->setMessage(reason);
    refresh();
  });
  connect(m_controller, &FigureController::failed, this, [this](const QString& text) {
    m_failure = text;
    refresh();
  });
  connect(m_controller, &FigureController::progressed, this, &FigureView::refresh);
  connect(m_measure, &QPushButton::clicked, this, [this] {
    m_failure.clear();
    m_notice.clear();
    if (m_tasks.isWritingFiles())
      m_tasks.cancelTopmost();
    else
      m_controller->isMeasuring() ? m_controller->cancel() : m_controller->measure();
    refresh();
  });
}

void FigureView::setNotice(const QString& notice) {
  m_notice = notice;
  refresh();
}

void FigureView::setDescription(const figures::FigureDescription& description) {
  m_failure.clear();
  m_notice.clear();
  m_page->setSquare(squareOf(description.inset));
  m_controller->setDescription(description);
  if (const QString empty = emptyText(); !empty.isEmpty()) {
    m_cells = m_missing = 0;
    m_page->setMessage(empty);
  }
  refresh();
}

QString FigureView::emptyText() const {
  const figures::FigureDescription& figure = m_controller->description();
  if (figure.materials.empty()) return tr("Add materials, one for each row of the figure.");
  if (figure.representations.empty()) return tr("Add representations, one for each column of the figure.");
  return {};
}

void FigureView::showFigure(const DrawnFigure& figure) {
  m_cells = figure.cells;
  m_missing = figure.missing;
  m_errorMaximum = figure.errorMaximum;
  m_page->setMessage({});
  m_page->setPage(figure.page, figure.pictures);
  refresh();
}

QString FigureView::status() const { return m_status->text(); }
bool FigureView::isSettled() const {
  return !m_resized.isActive() && !m_controller->isDrawing() && !m_controller->isMeasuring();
}

QString FigureView::restText() const {
  if (!m_failure.isEmpty()) return tr("Cannot measure the cells of the figure: %1").arg(m_failure.section('\n', 0, 0));
  if (!m_notice.isEmpty()) return m_notice;
  if (m_missing > 0)
    return tr("%1 of %2 cells are not measured. Each takes about two seconds at the default size and number of "
              "samples.")
        .arg(m_missing)
        .arg(m_cells);
  if (m_cells == 0) return {};
  QString text = tr("Every cell is measured.");
  if (m_controller->description().errorMaps)
    text += ' ' + tr("Scale of the error maps: 0 to %1.").arg(widgets::formatNumber(m_errorMaximum));
  return text;
}

void FigureView::refresh() {
  const bool measuring = m_controller->isMeasuring(), writing = m_tasks.isWritingFiles(), busy = measuring || writing;
  const auto task = writing ? m_tasks.topmost() : std::nullopt;
  m_measure->setText(writing ? tr("Cancel") : measuring ? tr("Stop") : tr("&Measure"));
  m_measure->setToolTip(writing     ? tr("Cancels saving; no file is written")
                        : measuring ? tr("Stops the measurement; finished cells stay (Escape)")
                                    : tr("Encodes and renders the missing cells in the background"));
  m_measure->setEnabled(busy || m_missing > 0);
  m_bar->setVisible(busy);
  m_bar->setValue(int((task ? task->fraction : m_controller->progress().value_or(0)) * barSteps));
  m_status->setText(task ? tr("%1: %2 of %3 cells are measured.")
                               .arg(task->title, QString::number(m_cells - m_missing), QString::number(m_cells))
                    : measuring ? tr("Measuring: %1 of %2 cells are done.").arg(m_cells - m_missing).arg(m_cells)
                                : restText());
  m_status->setToolTip(m_failure);
}

}  // namespace gonio::app

#include "moc_figure_view.cpp"
