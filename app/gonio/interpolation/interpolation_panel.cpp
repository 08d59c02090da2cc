// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/interpolation/interpolation_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/interpolation/blend_overview.h"
#include "app/gonio/interpolation/blend_slots.h"
#include "widgets/interpolation/blend_pad.h"
#include "widgets/interpolation/blend_strip.h"
#include "widgets/interpolation/material_slot_widget.h"
#include "widgets/panels/model_panel.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {
constexpr int choiceEms = 17;
const QString openKey = QStringLiteral("open-blend"), blendCostKey = QStringLiteral("blend-cost");
constexpr int blendRestMilliseconds = 400;
using Space = interpolation::InterpolationSpace;
}  // namespace

InterpolationPanel::InterpolationPanel(Document& document, BackgroundTasks& tasks, QWidget* parent,
                                       const StripPictures& pictures)
    : QWidget(parent),
      m_document(document),
      m_tasks(tasks),
      m_materials(document, tasks),
      m_spaces(tasks, nullptr, pictures),
      m_position(widgets::centrePosition(widgets::minBlended)),
      m_slots(new BlendSlots(document, m_materials)),
      m_positionEditor(new BlendPositionEditor),
      m_overview(new BlendOverview(m_spaces)),
      m_spaceBox(new QComboBox),
      m_modelLabel(new QLabel(tr("Mode&l"))),
      m_modelBox(new widgets::ModelBox),
      m_preserveDetail(new QCheckBox(tr("Preserve measured deta&il"))),
      m_show(new QCheckBox(tr("Show in the &preview"))),
      m_open(new QPushButton(tr("Open as Ma&terial"))) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(fontMetrics().height());
  layout->addWidget(m_slots);
  layout->addWidget(buildChoice());
  layout->addWidget(m_overview, 1);
  m_rest.setSingleShot(true);
  m_rest.setInterval(blendRestMilliseconds);
  connectParts();
  setSpace(m_space);
  blendMaterialsChanged();
}

QSize InterpolationPanel::sizeHint() const { return QSize(80, 22) * fontMetrics().height(); }

QWidget* InterpolationPanel::buildChoice() {
  for (const Space space : m_spaces.spaces()) {
    m_spaceBox->addItem(widgets::spaceName(space), int(space));
    m_spaceBox->setItemData(m_spaceBox->count() - 1, widgets::spaceExplanation(space), Qt::ToolTipRole);
  }
  m_spaceBox->setAccessibleName(tr("Method of blending"));
  m_preserveDetail->setToolTip(tr(
      "On: adds the detail of each material that its fit, factors or code misses, by the weight of the material: the "
      "blend begins and ends at the materials.\nOff: blends the fits, factors or codes alone, as published; the image "
      "jumps where a weight reaches 100 %.\nThe other spaces always contain the detail."));
  m_preserveDetail->setChecked(m_spaces.preservesDetail());
  m_show->setToolTip(
      tr("Shows the blend in the preview and updates it with every change; if off, the preview shows the open "
         "material"));
  m_show->setChecked(true);
  m_open->setToolTip(
      tr("Opens the blend as a material that can be edited, saved and exported.\nUndo restores the previous "
         "material."));
  auto* label = new QLabel(tr("Metho&d"));
  label->setBuddy(m_spaceBox);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(m_spaceBox, 1);
  m_modelLabel->setBuddy(m_modelBox);
  m_modelBox->setModel(&m_spaces.model());
  auto* modelRow = new QHBoxLayout;
  modelRow->addWidget(m_modelLabel);
  modelRow->addWidget(m_modelBox, 1);
  auto* choice = new QWidget;
  auto* column = new QVBoxLayout(choice);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addLayout(modelRow);
  column->addWidget(m_preserveDetail);
  column->addWidget(m_positionEditor, 1);
  column->addWidget(m_show);
  column->addWidget(m_open);
  choice->setFixedWidth(choiceEms * fontMetrics().height());
  return choice;
}

void InterpolationPanel::connectParts() {
  connect(&m_materials, &BlendMaterials::changed, this, &InterpolationPanel::blendMaterialsChanged);
  connect(&m_materials, &BlendMaterials::stateChanged, this, &InterpolationPanel::showMaterials);
  connect(&m_materials, &BlendMaterials::failed, this, &InterpolationPanel::failed);
  connect(&m_spaces, &BlendSpaces::changed, this, [this](Space space) {
    showOpenable();
    if (space != m_space) return;
    showExplanation();
    Q_EMIT subjectChanged();
  });
  connect(m_slots, &BlendSlots::touched, this, &InterpolationPanel::touched);
  connect(m_positionEditor, &BlendPositionEditor::positionEdited, this, &InterpolationPanel::moveTo);
  connect(m_spaceBox, &QComboBox::activated, this, [this](int index) {
    touched();
    setSpace(Space(m_spaceBox->itemData(index).toInt()));
  });
  connect(m_modelBox, &widgets::ModelBox::modelChosen, this, [this](const models::Model* model) {
    touched();
    m_modelBox->setModel(model);
    m_spaces.setModel(*model);
    Q_EMIT subjectChanged();
  });
  connect(m_preserveDetail, &QCheckBox::clicked, this, [this](bool preserve) {
    touched();
    m_spaces.setPreservesDetail(preserve);
    Q_EMIT subjectChanged();
  });
  connect(m_overview, &BlendOverview::chosen, this, [this](Space space, double t) {
    setSpace(space);
    moveTo(t < 0 ? m_position : widgets::pathPosition(m_materials.count(), t));
  });
  connect(m_overview, &BlendOverview::drawRequested, this, [this] { m_spaces.want(m_space); });
  connect(&m_rest, &QTimer::timeout, this, &InterpolationPanel::measureCost);
  connect(m_show, &QCheckBox::toggled, this, &InterpolationPanel::subjectChanged);
  connect(m_open, &QPushButton::clicked, this, &InterpolationPanel::openAsMaterial);
  // What is edited or opened is what the user wants to see.
  for (const auto signal : {&Document::materialChanged, &Document::editChanged})
    connect(&m_document, signal, this, [this] { setShownInPreview(false); });
  connect(&m_document, &Document::materialChanged, this, &InterpolationPanel::materialChanged);
}

std::vector<double> InterpolationPanel::weights() const { return widgets::weightsAt(m_materials.count(), m_position); }

void InterpolationPanel::setShownInPreview(bool shown) { m_show->setChecked(shown); }

std::optional<widgets::PreviewSubject> InterpolationPanel::subject() const {
  const widgets::PreparedBlendPtr blend = m_spaces.prepared(m_space);
  if (!isVisible() || !m_show->isChecked() || !blend) return {};
  return widgets::blendSubject(*blend, m_spaces.ordered(weights()));
}

QString InterpolationPanel::description() const {
  QStringList fractions;
  const std::vector<double> all = weights();
  for (int i = 0; i < m_materials.count(); ++i)
    if (const BlendMaterial* material = m_materials.at(i); material && all[std::size_t(i)] > 0)
      fractions << tr("%1 %2").arg(widgets::weightText(all[std::size_t(i)]), material->name);
  return tr("%1 (%2)").arg(fractions.join(QStringLiteral(", ")), widgets::spaceName(m_space));
}

void InterpolationPanel::setSpace(Space space) {
  m_space = space;
  const int index = m_spaceBox->findData(int(space));
  m_spaceBox->setCurrentIndex(index);
  m_spaceBox->setToolTip(widgets::spaceExplanation(space));
  for (QWidget* part : std::initializer_list<QWidget*>{m_modelLabel, m_modelBox})
    part->setVisible(BlendSpaces::usesModel(space));
  m_preserveDetail->setVisible(interpolation::losesDetail(space));
  showExplanation();
  m_overview->strip().setCurrentRow(index);
  if (isVisible()) m_spaces.want(space);
  showPosition();
  Q_EMIT subjectChanged();
}

void InterpolationPanel::showExplanation() {
  QString text = widgets::spaceExplanation(m_space);
  if (const widgets::PreparedBlendPtr blend = m_spaces.prepared(m_space); blend && widgets::mixesTables(*blend))
    text += '\n' + tr("The preview blends tables; a material that is not a table is sampled to one first.");
  if (const auto& cost = m_spaces.cost(m_space)) {
    const study::UseCost* present = presentCost();
    text += '\n' + (present ? tr("The blend takes %1. ").arg(widgets::timesText(*present))
                            : tr("At equal weights, the blend takes %1. ").arg(widgets::timesText(cost->middle)));
    if (!present && isVisible()) m_rest.start();
    text += std::isfinite(cost->lowestEndSnr) ? tr("Match with the materials at its ends: %1 (%2 dB).")
                                                    .arg(matchWord(cost->lowestEndSnr))
                                                    .arg(cost->lowestEndSnr, 0, 'f', 1)
                                              : tr("Its ends are the materials.");
  }
  m_positionEditor->setExplanation(text);
}

const study::UseCost* InterpolationPanel::presentCost() const {
  const auto& cost = m_spaces.cost(m_space);
  if (!cost) return nullptr;
  if (m_position == widgets::centrePosition(m_materials.count())) return &cost->middle;
  const bool isPresent = m_measured && m_measured->blend == m_spaces.prepared(m_space) &&
                         m_measured->weights == m_spaces.ordered(weights());
  return isPresent ? &m_measured->cost : nullptr;
}

void InterpolationPanel::measureCost() {
  const widgets::PreparedBlendPtr blend = m_spaces.prepared(m_space);
  if (!isVisible() || !blend || !m_spaces.cost(m_space) || presentCost()) return;
  const std::vector<double> weights = m_spaces.ordered(this->weights());
  m_tasks.run<study::UseCost>(
      {.title = tr("Measuring the blend"), .key = blendCostKey, .live = true},
      [blend, weights](const TaskControl& control) {
        return study::measureUse(*blend->interpolation->brdf(weights), {control.stop, {}});
      },
      [this, blend, weights](const study::UseCost& cost) {
        m_measured = {blend, weights, cost};
        showExplanation();
      });
}

void InterpolationPanel::moveTo(const QPointF& position) {
  m_position = widgets::nearestPosition(m_materials.count(), position);
  touched();
  showPosition();
  showExplanation();
  Q_EMIT subjectChanged();
}

void InterpolationPanel::useMaterials(const QStringList& ids) {
  if (ids.size() > widgets::maxBlended)
    return Q_EMIT failed(tr("Cannot blend %1 materials").arg(ids.size()),
                         tr("At most %1 materials can be blended. Select fewer.").arg(widgets::maxBlended));
  touched();
  if (ids.size() > 1) {
    const int count = int(ids.size());
    while (m_materials.count() < count) m_materials.addSlot();
    while (m_materials.count() > count) m_materials.removeSlot(m_materials.count() - 1);
    for (int i = 0; i < count; ++i) m_materials.read(i, ids[i]);
    return;
  }
  const QString& id = ids.front();
  for (int i = 0; i < m_materials.count(); ++i)
    if (!m_materials.at(i) && !m_materials.isReading(i)) return m_materials.read(i, id);
  if (m_materials.count() == widgets::maxBlended)
    return Q_EMIT failed(tr("All %1 slots have a material").arg(widgets::maxBlended),
                         tr("Empty a slot, or drop the material on the slot to replace."));
  m_materials.addSlot();
  m_materials.read(m_materials.count() - 1, id);
}

void InterpolationPanel::begin() {
  if (m_document.material() && !m_materials.at(0) && !m_materials.isReading(0)) m_materials.useCurrent(0);
  touched();
  m_slots->slotWidget(0).setFocus(Qt::OtherFocusReason);
}

void InterpolationPanel::blendMaterialsChanged() {
  const int count = m_materials.count();
  // What was equal fractions stays equal fractions.
  const bool middle = m_position == widgets::centrePosition(m_positionCount);
  m_position = middle ? widgets::centrePosition(count) : widgets::nearestPosition(count, m_position);
  m_positionCount = count;
  m_spaces.setMaterials(m_materials.isComplete() ? m_materials.materials()
                                                 : std::vector<interpolation::InterpolationMaterial>());
  showMaterials();
  m_overview->showSpaces();
  if (isVisible()) m_spaces.want(m_space);
  Q_EMIT subjectChanged();
}

void InterpolationPanel::materialChanged() {
  // A blend that is still being computed was to replace the material that was open before.
  m_tasks.drop(openKey);
  showMaterials();
}

void InterpolationPanel::showMaterials() {
  m_slots->showMaterials(weights());
  std::vector<widgets::BlendCorner> corners;
  for (int i = 0; i < m_materials.count(); ++i) {
    const BlendMaterial* material = m_materials.at(i);
    corners.push_back(material ? widgets::BlendCorner{material->name, material->picture} : widgets::BlendCorner());
  }
  m_positionEditor->setCorners(std::move(corners));
  showPosition();
}

void InterpolationPanel::showPosition() {
  m_slots->showWeights(weights());
  m_positionEditor->setPosition(m_position);
  // The strip only marks positions on its path.
  const double t = m_materials.count() == 3 ? 2 * m_position.x() : m_position.x();
  m_overview->strip().setMark(widgets::pathPosition(m_materials.count(), t) == m_position ? t : -1);
  showOpenable();
}

void InterpolationPanel::showOpenable() { m_open->setEnabled(m_spaces.prepared(m_space) != nullptr); }

void InterpolationPanel::openAsMaterial() {
  const widgets::PreparedBlendPtr blend = m_spaces.prepared(m_space);
  if (!blend) return Q_EMIT failed(tr("There is no blend to open"), tr("Choose a material for every slot first."));
  auto source = std::make_shared<documents::BlendSource>();
  source->space = m_space;
  source->model = blend->model;
  source->preserveDetail = blend->interpolation->preservesDetail();
  // As they were prepared: a document makes the blend again in the order that it names.
  source->weights = m_spaces.ordered(weights());
  source->materials.resize(std::size_t(m_materials.count()));
  for (int i = 0; i < m_materials.count(); ++i)
    source->materials[m_spaces.order()[std::size_t(i)]] = m_materials.at(i)->source;
  const QString text = tr("Open %1").arg(description());
  m_tasks.run<LoadedMaterialPtr>(
      {text, openKey},
      [blend, source](const TaskControl& control) {
        constexpr double blendFraction = 0.6;
        auto material = documents::blendedMaterial(*source, *blend->interpolation, control.between(0, blendFraction));
        return loadInMemory(std::move(material), source, control.between(blendFraction, 1));
      },
      [this, text](const LoadedMaterialPtr& material) { Q_EMIT materialMade(material, text); },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot open the blend"), error); });
}

bool InterpolationPanel::isSettled() const {
  return !isVisible() || (!m_materials.isReading() && m_spaces.isSettled() && !m_tasks.isRunning(openKey) &&
                          !m_rest.isActive() && !m_tasks.isRunning(blendCostKey));
}

void InterpolationPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  m_spaces.want(m_space);
  showExplanation();
  Q_EMIT subjectChanged();
}

void InterpolationPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  m_spaces.pause();
  m_rest.stop();
  m_tasks.drop(blendCostKey);
  Q_EMIT subjectChanged();
}

}  // namespace gonio::app

#include "moc_interpolation_panel.cpp"
