// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/plots/plots_panel.h"

#include <QDockWidget>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "widgets/plots/curve_chart.h"
#include "widgets/plots/lobe_plot.h"
#include "widgets/plots/polar_plot.h"
#include "widgets/plots/slice_plot.h"

namespace gonio::app {

namespace {
const QString taskKey = QStringLiteral("plots");
constexpr int restMilliseconds = 250;
}  // namespace

PlotsPanel::PlotsPanel(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_tasks(tasks),
      m_controls(new PlotControls),
      m_stack(new QStackedWidget),
      m_polar(new widgets::PolarPlot),
      m_cartesian(new widgets::CartesianPlot),
      m_slice(new widgets::SlicePlot),
      m_albedo(new widgets::AlbedoPlot),
      m_lobe(new widgets::LobePlot),
      m_plots{m_polar, m_cartesian, m_slice, m_albedo, m_lobe} {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_controls);
  layout->addWidget(m_stack, 1);
  addPlots();
  m_rest.setSingleShot(true);
  m_rest.setInterval(restMilliseconds);
  connect(&m_rest, &QTimer::timeout, this, &PlotsPanel::request);
  connect(m_controls, &PlotControls::changed, this, &PlotsPanel::choicesChanged);
  connect(m_controls, &PlotControls::pickingToggled, this, &PlotsPanel::pickingToggled);
  connect(m_controls, &PlotControls::exportRequested, this,
          [this](const QString& suffix, const QSize& size) { currentPlot().exportAs(suffix, size); });
  connect(&m_document, &Document::materialChanged, this, [this] {
    clear();
    documentChanged();
  });
  connect(&m_document, &Document::stateChanged, this, &PlotsPanel::documentChanged);
  connect(&m_document, &Document::editChanged, this, &PlotsPanel::documentChanged);
  connect(&m_document, &Document::selectionChanged, this, &PlotsPanel::documentChanged);
  clear();
  choicesChanged();
}

QSize PlotsPanel::sizeHint() const { return QSize(60, 24) * fontMetrics().height(); }

void PlotsPanel::addPlots() {
  for (widgets::Plot* plot : m_plots) {
    m_stack->addWidget(plot);
    connect(plot, &widgets::Plot::thetaIEdited, m_controls, &PlotControls::setThetaI);
    connect(plot, &widgets::Plot::exported, this, &PlotsPanel::exported);
    connect(plot, &widgets::Plot::failed, this, &PlotsPanel::failed);
  }
}

widgets::Plot& PlotsPanel::currentPlot() const { return *m_plots[int(m_controls->choices().kind)]; }

void PlotsPanel::showAt(PlotKind kind, double thetaI) {
  if (auto* dock = qobject_cast<QDockWidget*>(parentWidget())) {
    dock->show();
    dock->raise();
  }
  PlotChoices choices = m_controls->choices();
  choices.kind = kind;
  m_controls->setChoices(choices);
  setThetaI(thetaI);
}

void PlotsPanel::showKind(const QString& name) {
  static const QStringList names{"polar", "cartesian", "slice", "albedo", "lobe"};
  if (names.contains(name)) showAt(PlotKind(names.indexOf(name)), m_controls->choices().settings.thetaI);
}

void PlotsPanel::setOtherFits(const std::vector<PlottedFit>& fits) {
  m_otherFits = fits;
  request();
}

bool PlotsPanel::isSettled() const { return !isVisible() || (!m_running && !m_again && !m_rest.isActive()); }

void PlotsPanel::clear() {
  m_polar->setSeries({});
  m_cartesian->setSeries({});
  m_slice->setSeries({});
  m_albedo->setSeries({});
  m_lobe->setSeries({});
  m_known.reset();
  m_controls->setExportEnabled(false);
  const LoadedMaterialPtr& material = m_document.material();
  for (widgets::Plot* plot : m_plots) {
    plot->setSource(material ? QString::fromStdString(material->material.name) : QString());
    plot->setHint(material ? tr("Computing the plot...")
                           : tr("Open a material to plot its measured, fitted and edited values."));
  }
}

void PlotsPanel::choicesChanged() {
  m_stack->setCurrentWidget(&currentPlot());
  for (const PlotKind kind : allPlotKinds)
    m_plots[std::size_t(kind)]->setSettings(m_controls->choices().settingsOf(kind));
  request();
}

void PlotsPanel::documentChanged() {
  if (m_controls->choices().kind == PlotKind::albedo) m_rest.start();
  request();
}

void PlotsPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  request();
}

void PlotsPanel::request() {
  if (!isVisible() || !m_document.material()) return;
  if (m_running)
    m_again = true;
  else
    start();
}

void PlotsPanel::start() {
  const PlotChoices& choices = m_controls->choices();
  PlotRequest request{choices.kind,    m_document.material(), m_document.edits(), {},     choices.section(),
                      choices.spacing, choices.coordinates,   m_rest.isActive(),  m_known};
  if (const auto* edit = m_document.active<editing::DifferentialEdit>()) request.fit = *edit;
  request.base = m_document.base();
  request.otherFits = m_otherFits;
  m_running = true;
  m_again = false;
  m_tasks.run<PlotData>(
      {.title = tr("Plotting"), .key = taskKey, .live = true},
      [request](const TaskControl& control) { return computePlot(request, control); },
      [this, request](const PlotData& plotted) { finished(request, plotted); },
      [this](const QString& error) {
        m_running = false;
        Q_EMIT failed(tr("Cannot plot"), error);
      },
      [this] { m_running = false; });
}

void PlotsPanel::finished(const PlotRequest& request, const PlotData& plotted) {
  m_running = false;
  if (request.material == m_document.material() && request.base == m_document.base()) {
    m_known = plotted.known;
    if (request.kind == PlotKind::polar) m_polar->setSeries(plotted.curves);
    if (request.kind == PlotKind::cartesian) m_cartesian->setSection(request.section, plotted.curves);
    if (request.kind == PlotKind::slice) m_slice->setSeries(plotted.slices);
    if (request.kind == PlotKind::albedo) m_albedo->setSeries(plotted.curves);
    if (request.kind == PlotKind::lobe) m_lobe->setSeries(plotted.lobes);
    m_controls->setExportEnabled(!currentPlot().isEmpty());
  }
  if (m_again) this->request();
}

}  // namespace gonio::app

#include "moc_plots_panel.cpp"
