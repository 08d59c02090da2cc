// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/monitors.h"

#include <utility>

#include "core/editing/edit_plausibility.h"
#include "core/fitting/fit_parameters.h"
#include "core/rendering/render_picture.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/panels/plausibility_badges.h"

namespace gonio::app {

namespace {
const QString plausibilityKey = QStringLiteral("plausibility");
/// After the last change: a slider that moves is not slowed down by checks of every step.
constexpr int checkDelayMilliseconds = 120;

struct Findings {
  std::vector<metrics::PlausibilityCheck> checks;
  std::vector<editing::Energy> energies;
};
}  // namespace

PlausibilityMonitor::PlausibilityMonitor(Document& document, BackgroundTasks& tasks,
                                         widgets::PlausibilityBadges& badges, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks), m_badges(badges) {
  m_delay.setSingleShot(true);
  m_delay.setInterval(checkDelayMilliseconds);
  connect(&m_delay, &QTimer::timeout, this, &PlausibilityMonitor::check);
  for (const auto signal : {&Document::materialChanged, &Document::stateChanged, &Document::editChanged})
    connect(&document, signal, this, &PlausibilityMonitor::changed);
}

void PlausibilityMonitor::changed() {
  m_tasks.drop(plausibilityKey);
  m_current = !m_document.material();
  if (!std::exchange(m_energies, {}).empty()) Q_EMIT energiesChanged();
  if (m_current) {
    m_delay.stop();
    return m_badges.clear();
  }
  m_badges.setPending();
  m_delay.start();
}

void PlausibilityMonitor::check() {
  const std::vector<editing::Edit> edits = m_document.edits();
  m_tasks.run<Findings>(
      {tr("Checking"), plausibilityKey, false, true},
      [base = m_document.base(), edits](const TaskControl& control) {
        return Findings{editing::checkEditPlausibility(base, edits, control),
                        editing::energiesThrough(base, edits, control)};
      },
      [this, edits](const Findings& findings) {
        m_current = true;
        m_badges.setChecks(findings.checks, editing::isIdentity(edits));
        m_energies = findings.energies;
        Q_EMIT energiesChanged();
      });
}

namespace {
const QString tableErrorKey = QStringLiteral("table error");
}  // namespace

TableErrorMonitor::TableErrorMonitor(Document& document, BackgroundTasks& tasks, QObject* parent,
                                     const rendering::RenderOptions& picture)
    : QObject(parent), m_document(document), m_tasks(tasks), m_picture(picture) {
  connect(&document, &Document::materialChanged, this, &TableErrorMonitor::measure);
}

void TableErrorMonitor::measure() {
  m_tasks.drop(tableErrorKey);
  m_snr.reset();
  const LoadedMaterialPtr material = m_document.material();
  m_measuring = material && (material->isSampled() || !material->isTable());
  if (!m_measuring) return;
  m_tasks.run<double>(
      {tr("Measuring table accuracy of %1").arg(widgets::spacedName(m_document.name())), tableErrorKey, true},
      [material, picture = m_picture](const TaskControl& control) {
        const rendering::RenderedComparison comparison(*material->material.brdf, picture, control.between(0, 0.5));
        return comparison.signalToNoiseRatio(comparison.render(*material->table(control), control.between(0.5, 1)));
      },
      [this](double snr) { finish(snr); }, [this](const QString&) { finish({}); }, [this] { finish({}); });
}

void TableErrorMonitor::finish(std::optional<double> snr) {
  m_snr = snr;
  m_measuring = false;
  Q_EMIT measured();
}

namespace {
const QString costKey = QStringLiteral("costs");
/// Longer than for checks: frames take all cores.
constexpr int costDelayMilliseconds = 700;
}  // namespace

CostMonitor::CostMonitor(Document& document, BackgroundTasks& tasks, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks) {
  m_delay.setSingleShot(true);
  m_delay.setInterval(costDelayMilliseconds);
  connect(&m_delay, &QTimer::timeout, this, &CostMonitor::measure);
  connect(&document, &Document::materialChanged, this, &CostMonitor::materialChanged);
  connect(&document, &Document::selectionChanged, this, &CostMonitor::selectionChanged);
  for (const auto signal : {&Document::stateChanged, &Document::editChanged})
    connect(&document, signal, this, &CostMonitor::editsChanged);
}

void CostMonitor::materialChanged() {
  m_costs = {};
  m_fitted.reset();
  m_fittedModel = nullptr;
  editsChanged();
}

void CostMonitor::editsChanged() {
  adoptFit();
  m_costs.edited.reset();
  restart();
}

/// Of the numbers, those of the fit alone depend on the selection.
void CostMonitor::selectionChanged() {
  if (adoptFit()) restart();
}

bool CostMonitor::adoptFit() {
  const auto* edit = m_document.active<editing::DifferentialEdit>();
  const models::Model* model = edit ? edit->model : nullptr;
  const auto fitted = edit ? std::optional(edit->fitted) : std::nullopt;
  if (model == m_fittedModel && fitted == m_fitted) return false;
  m_fittedModel = model;
  m_fitted = fitted;
  m_costs.fitSnr.reset();
  const auto symmetry = m_document.material() && !m_document.base()->isIsotropic() ? fitting::DataSymmetry::anisotropic
                                                                                   : fitting::DataSymmetry::isotropic;
  m_costs.fitBytes = model ? fitting::fittedParameterCount(model->spec(), symmetry) * sizeof(float) : 0;
  return true;
}

void CostMonitor::restart() {
  m_tasks.drop(costKey);
  if (m_document.material())
    m_delay.start();
  else
    m_delay.stop();
  Q_EMIT changed();
}

void CostMonitor::measure() {
  std::shared_ptr<const Brdf> fit;
  if (m_fitted && !m_costs.fitSnr) fit = m_fittedModel->instantiate(*m_fitted);
  m_tasks.run<Costs>(
      {tr("Measuring times"), costKey, false, true},
      [base = m_document.base(), edits = m_document.edits(), fit, costs = m_costs](const TaskControl& control) mutable {
        if (fit) {
          const rendering::RenderedComparison comparison(*base, rendering::smallComparisonPicture(), control);
          costs.fitSnr = comparison.signalToNoiseRatio(comparison.render(*fit, control));
        }
        if (!costs.measured) costs.measured = study::measureUse(*base, control);
        if (costs.edited) return costs;
        const auto edited = editing::applyEdits(base, edits);
        costs.edited = edited == base ? costs.measured : study::measureUse(*edited, control);
        return costs;
      },
      [this](const Costs& costs) {
        m_costs = costs;
        Q_EMIT changed();
      });
}

}  // namespace gonio::app

#include "moc_monitors.cpp"
