// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/inspector.h"

#include <QMenu>
#include <QSettings>
#include <QVBoxLayout>

#include "app/gonio/document/edit_steps.h"
#include "app/gonio/inspector/composition_choice.h"
#include "app/gonio/inspector/direction_order.h"
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

using editing::DifferentialEdit;

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
  auto* source = new QWidget;
  auto* sourceRows = new QVBoxLayout(source);
  sourceRows->setContentsMargins(0, 0, 0, 0);
  sourceRows->addWidget(m_source);
  sourceRows->addWidget(new DirectionOrder(document));
  addSection(tr("Source"), source);
  addSection(tr("Representation"), m_representation);
  m_sections[representationSection]->setExpanded(false);
  auto* model = new QWidget;
  auto* modelRows = new QVBoxLayout(model);
  modelRows->setContentsMargins(0, 0, 0, 0);
  modelRows->addWidget(m_model);
  modelRows->addWidget(new CompositionChoice(document));
  addSection(tr("Model"), model);
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
  connect(&m_document, &Document::selectionChanged, this, &Inspector::showModel);
  connect(&m_document, &Document::editChanged, this, &Inspector::showValues);
  connect(&m_tasks, &BackgroundTasks::changed, this, [this] {
    m_model->setBusy(m_controller.isFitting());
    if (!m_shownModel && m_noSliders != noSlidersText()) showModel();
  });
  connect(m_model, &widgets::ModelPanel::fitRequested, &m_controller, &DocumentController::fit);
  connect(m_model, &widgets::ModelPanel::modelChosen, this, [this](const models::Model* model) {
    if (m_document.material()) m_controller.chooseModel(*model);
    showModel();  // until the fit is there, the list shows the model in use
  });
}

void Inspector::connectParameters() {
  connect(m_parameters, &widgets::ParameterPanel::editingStarted, &m_document, &Document::beginInteraction);
  connect(m_parameters, &widgets::ParameterPanel::valueEdited, this,
          [this](int parameter, const Rgb& value) { setParameter(m_document, parameter, value); });
  connect(m_parameters, &widgets::ParameterPanel::editingFinished, &m_document, &Document::endInteraction);
  connect(m_parameters, &widgets::ParameterPanel::resetRequested, this,
          [this](int parameter) { resetParameter(m_document, parameter); });
}

void Inspector::showSource() {
  std::vector<widgets::Fact> facts;
  if (const LoadedMaterialPtr material = m_document.material())
    facts = sourceFacts(*material, m_tableError->snr(), !m_tableError->isSettled());
  m_source->setFacts(facts, tr("Nothing is open. Choose a material in the library or open a file (Ctrl+O)."));
  m_model->setEnabled(m_document.material() != nullptr);
}

void Inspector::showModel() {
  const auto* edit = m_document.active<DifferentialEdit>();
  const models::Model* model = edit ? edit->model : nullptr;
  const fitting::FitResult* fit = edit ? m_document.fitOf(*edit) : nullptr;
  m_model->setModel(model, fit ? fitSummary(*fit) : edit ? tr("Parameters from the document.") : QString());
  m_model->setEnabled(m_document.material() != nullptr);
  if (!model || model != m_shownModel) {
    m_noSliders = noSlidersText();
    m_parameters->setModel(model ? &model->spec() : nullptr, m_noSliders);
    m_shownModel = model;
  }
  showValues();
}

QString Inspector::noSlidersText() const {
  if (!m_document.material()) return tr("Open a material to edit it.");
  if (m_controller.isFitting()) return tr("Fitting... sliders will appear shortly.");
  return tr("No edit of a model. Choose a model above or add an edit to change its parameters.");
}

void Inspector::showValues() {
  if (const auto* edit = m_document.active<DifferentialEdit>()) m_parameters->setValues(edit->edited, edit->fitted);
  showEdits();
}

void Inspector::connectEdits() {
  using widgets::EditStack;
  connect(m_edits, &EditStack::selectionChosen, &m_document, &Document::select);
  connect(m_edits, &EditStack::editingStarted, &m_document, &Document::beginInteraction);
  connect(m_edits, &EditStack::editingFinished, &m_document, &Document::endInteraction);
  connect(m_edits, &EditStack::enabledChosen, this,
          [this](int edit, bool enabled) { setEditEnabled(m_document, edit, enabled); });
  connect(m_edits, &EditStack::strengthEdited, this,
          [this](int edit, double strength) { setEditStrength(m_document, edit, strength); });
  connect(m_edits, &EditStack::renamed, this,
          [this](int edit, const QString& name) { renameEdit(m_document, edit, name); });
  connect(m_edits, &EditStack::moveRequested, this, [this](int from, int to) { moveEdit(m_document, from, to); });
  connect(m_edits, &EditStack::duplicateRequested, this, [this](int edit) { duplicateEdit(m_document, edit); });
  connect(m_edits, &EditStack::deleteRequested, this, [this](int edit) { deleteEdit(m_document, edit); });
  QMenu& menu = m_edits->addMenu();
  menu.setToolTipsVisible(true);
  menu.addAction(tr("Model"), &m_controller, &DocumentController::addModelEdit)
      ->setToolTip(tr("Another edit of the model in use, from the same fit"));
  menu.addAction(tr("Factor curves"), this, &Inspector::factorEditWanted)
      ->setToolTip(tr("Another edit of the factor curves of the measurement"));
  for (QAction* action : menu.actions()) action->setEnabled(false);
}

void Inspector::showEdits() {
  const editing::EditList& edits = m_document.edits();
  std::vector<widgets::EditEntry> entries;
  for (int i = 0; i < int(edits.size()); ++i) {
    const editing::Edit& edit = edits[std::size_t(i)];
    const bool curves = std::holds_alternative<editing::FactorEdit>(edit.content);
    QString tip = curves ? tr("A change of the factor curves (Factor curves dock)")
                         : tr("A change of the parameters of %1 (sliders)")
                               .arg(widgets::fromView(std::get<DifferentialEdit>(edit.content).model->spec().name));
    if (edit.isIdentity() && edit.enabled && edit.strength > 0) tip += tr("\nIt changes nothing yet.");
    entries.push_back({editName(edits, i), tip, edit.strength, edit.enabled, QString::fromStdString(edit.name)});
  }
  for (QAction* action : m_edits->addMenu().actions()) action->setEnabled(m_document.material() != nullptr);
  m_edits->setEntries(
      entries, m_document.state().selected,
      m_document.material() ? tr("No edits: the material is shown as measured.") : tr("Open a material to edit it."));
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
