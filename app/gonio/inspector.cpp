// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector.h"

#include <QSettings>
#include <QVBoxLayout>

#include "app/gonio/plausibility_monitor.h"
#include "app/gonio/source_facts.h"
#include "widgets/panels/collapsible_section.h"
#include "widgets/panels/fact_list.h"
#include "widgets/panels/model_panel.h"
#include "widgets/panels/plausibility_badges.h"
#include "widgets/parameters/parameter_panel.h"

namespace gonio::app {

namespace {
const QString sectionKeys[] = {QStringLiteral("inspector/source"), QStringLiteral("inspector/model"),
                               QStringLiteral("inspector/plausibility"), QStringLiteral("inspector/parameters")};
constexpr int preferredEms = 28;
}  // namespace

Inspector::Inspector(Document& document, DocumentController& controller, BackgroundTasks& tasks, QWidget* parent)
    : QScrollArea(parent),
      m_document(document),
      m_controller(controller),
      m_tasks(tasks),
      m_source(new widgets::FactList),
      m_model(new widgets::ModelPanel),
      m_plausibility(new widgets::PlausibilityBadges),
      m_monitor(new PlausibilityMonitor(document, tasks, *m_plausibility, this)),
      m_parameters(new widgets::ParameterPanel) {
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
  addSection(tr("Model"), m_model);
  addSection(tr("Plausibility"), m_plausibility);
  addSection(tr("Parameters"), m_parameters);
  layout->addStretch();
  setWidget(content);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connectDocument();
  connectParameters();
  showSource();
  showModel();
}

QSize Inspector::sizeHint() const { return {fontMetrics().height() * preferredEms, fontMetrics().height() * 40}; }

bool Inspector::isSettled() const { return m_monitor->isCurrent(); }

void Inspector::connectDocument() {
  connect(&m_document, &Document::materialChanged, this, &Inspector::showSource);
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
  m_source->setFacts(m_document.material() ? sourceFacts(*m_document.material()) : std::vector<widgets::Fact>(),
                     tr("Nothing is open. Choose a material in the library or open a file (Ctrl+O)."));
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
}

void Inspector::saveState(QSettings& settings) const {
  for (int i = 0; i < m_sections.size(); ++i) settings.setValue(sectionKeys[i], m_sections[i]->isExpanded());
}

void Inspector::restoreState(const QSettings& settings) {
  for (int i = 0; i < m_sections.size(); ++i) m_sections[i]->setExpanded(settings.value(sectionKeys[i], true).toBool());
}

}  // namespace gonio::app

#include "moc_inspector.cpp"
