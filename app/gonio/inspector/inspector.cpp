// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/inspector.h"

#include <QSettings>
#include <QVBoxLayout>

#include "app/gonio/inspector/plausibility_monitor.h"
#include "app/gonio/inspector/representation_panel.h"
#include "app/gonio/inspector/source_facts.h"
#include "app/gonio/inspector/table_error_monitor.h"
#include "widgets/inputs/collapsible_section.h"
#include "widgets/panels/edit_stack.h"
#include "widgets/panels/fact_list.h"
#include "widgets/panels/model_panel.h"
#include "widgets/panels/plausibility_badges.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {
const QString sectionKeys[] = {QStringLiteral("inspector/source"), QStringLiteral("inspector/representation"),
                               QStringLiteral("inspector/model"),  QStringLiteral("inspector/plausibility"),
                               QStringLiteral("inspector/edits"),  QStringLiteral("inspector/parameters")};
constexpr int representationSection = 1;  ///< folded at first: it computes while it is seen
constexpr int preferredEms = 28;
}  // namespace

Inspector::Inspector(Document& document, DocumentController& controller, BackgroundTasks& tasks, QWidget* parent)
    : QScrollArea(parent),
      m_document(document),
      m_controller(controller),
      m_tasks(tasks),
      m_source(new widgets::FactList),
      m_tableError(new TableErrorMonitor(document, tasks, this)),
      m_representation(new RepresentationPanel(document, tasks)),
      m_model(new widgets::ModelPanel),
      m_plausibility(new widgets::PlausibilityBadges),
      m_monitor(new PlausibilityMonitor(document, tasks, *m_plausibility, this)),
      m_parameters(new widgets::ParameterPanel),
      m_edits(new widgets::EditStack) {
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(fontMetrics().height() / 2);
  const auto addSection = [&](const QString& title, QWidget* widget) {
    auto* padded = new QWidget;
    auto* inner = new QVBoxLayout(padded);
    inner->setContentsMargins(6, 4, 2, 6);
    inner->addWidget(widget);
    m_sections << new widgets::CollapsibleSection(title, padded);
    layout->addWidget(m_sections.back());
  };
  addSection(tr("Source"), m_source);
  addSection(tr("Representation"), m_representation);
  m_sections[representationSection]->setExpanded(false);
  addSection(tr("Model"), m_model);
  addSection(tr("Plausibility"), m_plausibility);
  addSection(tr("Edits"), m_edits);
  addSection(tr("Parameters"), m_parameters);
  layout->addStretch();
  setWidget(content);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connectDocument();
  connectParameters();
  connectEdits();
  showSource();
  showModel();
}

QSize Inspector::sizeHint() const { return {fontMetrics().height() * preferredEms, fontMetrics().height() * 40}; }

bool Inspector::isSettled() const {
  return m_monitor->isCurrent() && m_tableError->isSettled() && m_representation->isSettled();
}

void Inspector::connectDocument() {
  connect(&m_document, &Document::materialChanged, this, &Inspector::showSource);
  connect(m_tableError, &TableErrorMonitor::measured, this, &Inspector::showSource);
  connect(&m_document, &Document::stateChanged, this, &Inspector::showModel);
  connect(&m_document, &Document::editChanged, this, &Inspector::showValues);
  connect(&m_tasks, &BackgroundTasks::changed, this, [this] { m_model->setBusy(m_controller.isFitting()); });
  connect(m_model, &widgets::ModelPanel::fitRequested, &m_controller, &DocumentController::fit);
  connect(m_model, &widgets::ModelPanel::modelChosen, this, [this](const models::Model* model) {
    if (m_document.material()) m_controller.chooseModel(*model);
    showModel();  // until the fit is there, the list shows the model in use
  });
}

void Inspector::connectParameters() {
  connect(m_parameters, &widgets::ParameterPanel::editingStarted, &m_document, &Document::beginInteraction);
  connect(m_parameters, &widgets::ParameterPanel::valueEdited, &m_document, &Document::setParameter);
  connect(m_parameters, &widgets::ParameterPanel::editingFinished, &m_document, &Document::endInteraction);
  connect(m_parameters, &widgets::ParameterPanel::resetRequested, &m_document, &Document::resetParameter);
}

void Inspector::showSource() {
  std::vector<widgets::Fact> facts;
  if (const LoadedMaterialPtr material = m_document.material())
    facts = sourceFacts(*material, m_tableError->snr(), !m_tableError->isSettled());
  m_source->setFacts(facts, tr("Nothing is open. Choose a material in the library or open a file (Ctrl+O)."));
  m_model->setEnabled(m_document.material() != nullptr);
}

void Inspector::showModel() {
  const auto& edit = m_document.edit();
  const models::Model* model = edit ? edit->model : nullptr;
  const auto& fit = m_document.state().fit;
  m_model->setModel(model, fit ? fitSummary(*fit) : edit ? tr("Parameters from the document.") : QString());
  m_model->setEnabled(m_document.material() != nullptr);
  if (!model || model != m_shownModel) {
    m_parameters->setModel(model ? &model->spec() : nullptr, m_document.material()
                                                                 ? tr("The sliders appear when the fit is done.")
                                                                 : tr("Open a material to edit it."));
    m_shownModel = model;
  }
  showValues();
}

void Inspector::showValues() {
  if (const auto& edit = m_document.edit()) m_parameters->setValues(edit->edited, edit->fitted);
  showEdits();
}

void Inspector::connectEdits() {
  using widgets::EditStack;
  const auto onFactors = [this](int entry) { return entry == 0 && m_document.factors(); };
  connect(m_edits, &EditStack::editingStarted, &m_document, &Document::beginInteraction);
  connect(m_edits, &EditStack::editingFinished, &m_document, &Document::endInteraction);
  connect(m_edits, &EditStack::enabledChosen, this, [this, onFactors](int entry, bool enabled) {
    if (!onFactors(entry)) return m_document.setEditEnabled(enabled);
    editing::FactorEdit factors = *m_document.factors();
    factors.enabled = enabled;
    m_document.setFactors(factors, enabled ? tr("Show the factor curves' edit") : tr("Hide the factor curves' edit"));
  });
  connect(m_edits, &EditStack::strengthEdited, this, [this, onFactors](int entry, double strength) {
    if (!onFactors(entry)) return m_document.setEditStrength(strength);
    editing::FactorEdit factors = *m_document.factors();
    factors.strength = strength;
    m_document.setFactors(factors, tr("Strength of the factor curves %1 %").arg(100 * strength, 0, 'f', 0));
  });
  connect(m_edits, &EditStack::deleteRequested, this, [this, onFactors](int entry) {
    if (onFactors(entry))
      m_document.setFactors({}, tr("Delete the factor curves' edit"));
    else
      m_document.deleteEdit();
  });
}

void Inspector::showEdits() {
  std::vector<widgets::EditEntry> entries;
  if (const auto& factors = m_document.factors())
    entries.push_back({tr("Factor curves"), tr("What the Factor curves dock changes, next to the measurement"),
                       factors->strength, factors->enabled});
  const auto& edit = m_document.edit();
  if (edit && (edit->edited != edit->fitted || edit->strength != 1 || !edit->enabled))
    entries.push_back({widgets::fromView(edit->model->spec().name),
                       tr("What the sliders change: added to what lies above it"), edit->strength, edit->enabled});
  m_edits->setEntries(entries, tr("None yet: the sliders below and the factor curves make them."));
}

void Inspector::unfoldRepresentation() { m_sections[representationSection]->setExpanded(true); }

void Inspector::saveState(QSettings& settings) const {
  for (int i = 0; i < m_sections.size(); ++i) settings.setValue(sectionKeys[i], m_sections[i]->isExpanded());
}

void Inspector::restoreState(const QSettings& settings) {
  for (int i = 0; i < m_sections.size(); ++i)
    m_sections[i]->setExpanded(settings.value(sectionKeys[i], i != representationSection).toBool());
}

}  // namespace gonio::app

#include "moc_inspector.cpp"
