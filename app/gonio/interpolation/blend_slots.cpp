// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/interpolation/blend_slots.h"

#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/gonio/document/material_files.h"
#include "app/gonio/library/thumbnail.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/interpolation/blend_pad.h"
#include "widgets/interpolation/blend_position.h"
#include "widgets/interpolation/material_slot_widget.h"
#include "widgets/interpolation/prepared_blend.h"
#include "widgets/library/material_drag.h"

namespace gonio::app {

namespace {

constexpr int pictureSide = 160, pictureSamples = 24;
constexpr double loadFraction = 0.6, editFraction = 0.9;

}  // namespace

BlendMaterial makeBlendMaterial(const LoadedMaterial& material, const QString& name, documents::EditDocument source,
                                const TaskControl& control) {
  BlendMaterial result;
  result.name = name;
  const std::string& description = material.material.source.description;
  result.description = QString::fromStdString(description.empty() ? material.material.name : description);
  const auto table = material.table(control);
  result.material = documents::interpolationMaterial(
      material.material, withIncident(material.base, source.incident), table,
      editing::bakeEdits(table, source.edits, control.between(0, editFraction)), source.edits);
  result.picture =
      spherePicture(*result.material.material(), pictureSide, pictureSamples, control.between(editFraction, 1));
  source.view = {};
  result.source = std::move(source);
  return result;
}

BlendMaterial readBlendMaterial(const QString& id, const TaskControl& control) {
  documents::EditDocument source;
  LoadedMaterialPtr material;
  const std::string path = id.toStdString();
  if (isDocument(id)) {
    source = documents::resolved(documents::readDocument(path), path);
    material = loadSource(source, control.between(0, loadFraction));
  } else {
    material = loadMaterial(path, control.between(0, loadFraction));
    source.sourcePath = material->material.source.path.string();
  }
  source.sourceSha256 = material->material.source.sha256;
  const QString name =
      isDocument(id) ? shortName(id).section('.', 0, -2) : QString::fromStdString(material->material.name);
  return makeBlendMaterial(*material, name, source, control.between(loadFraction, 1));
}

BlendMaterials::BlendMaterials(Document& document, BackgroundTasks& tasks, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks) {
  for (int i = 0; i < widgets::minBlended; ++i) m_slots.push_back({{}, {}, m_nextKey++});
}

QString BlendMaterials::taskKey(int key) const { return QStringLiteral("blend-material-%1").arg(key); }

const BlendMaterial* BlendMaterials::at(int slot) const {
  const auto& material = m_slots[std::size_t(slot)].material;
  return material ? &*material : nullptr;
}

bool BlendMaterials::isReading(int slot) const { return m_tasks.isRunning(taskKey(m_slots[std::size_t(slot)].key)); }

bool BlendMaterials::isReading() const {
  for (int i = 0; i < count(); ++i)
    if (isReading(i)) return true;
  return false;
}

bool BlendMaterials::isComplete() const {
  return std::all_of(m_slots.begin(), m_slots.end(), [](const Slot& slot) { return slot.material.has_value(); });
}

std::vector<interpolation::InterpolationMaterial> BlendMaterials::materials() const {
  std::vector<interpolation::InterpolationMaterial> result;
  for (const Slot& slot : m_slots) result.push_back(slot.material->material);
  return result;
}

int BlendMaterials::slotOf(int key) const {
  for (int i = 0; i < count(); ++i)
    if (m_slots[std::size_t(i)].key == key) return i;
  return -1;
}

void BlendMaterials::fill(int slot, const QString& title, const QString& name,
                          std::function<BlendMaterial(const TaskControl&)> make) {
  const int key = m_slots[std::size_t(slot)].key;
  m_slots[std::size_t(slot)].failure.clear();
  m_tasks.run<BlendMaterial>(
      {title, taskKey(key)}, std::move(make),
      [this, key](const BlendMaterial& material) {
        m_slots[std::size_t(slotOf(key))].material = material;
        Q_EMIT changed();
      },
      [this, key, name](const QString& error) {
        m_slots[std::size_t(slotOf(key))].failure = error;
        Q_EMIT stateChanged();
        Q_EMIT failed(tr("Cannot use %1").arg(name), error);
      },
      [this] { Q_EMIT stateChanged(); });
  Q_EMIT stateChanged();
}

void BlendMaterials::read(int slot, const QString& id) {
  fill(slot, tr("Opening %1 for the blend").arg(shortName(id)), shortName(id),
       [id](const TaskControl& control) { return readBlendMaterial(id, control); });
}

void BlendMaterials::useCurrent(int slot) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  const QString name = m_document.name();
  fill(slot, tr("Preparing %1 for the blend").arg(widgets::spacedName(name)), name,
       [material, name, source = m_document.toEditDocument()](const TaskControl& control) {
         return makeBlendMaterial(*material, name, source, control);
       });
}

void BlendMaterials::clear(int slot) {
  Slot& one = m_slots[std::size_t(slot)];
  m_tasks.drop(taskKey(one.key));
  one.material.reset();
  one.failure.clear();
  Q_EMIT changed();
}

void BlendMaterials::addSlot() {
  if (count() == widgets::maxBlended) return;
  m_slots.push_back({{}, {}, m_nextKey++});
  Q_EMIT changed();
}

void BlendMaterials::removeSlot(int slot) {
  if (count() == widgets::minBlended) return;
  m_tasks.drop(taskKey(m_slots[std::size_t(slot)].key));
  m_slots.erase(m_slots.begin() + slot);
  Q_EMIT changed();
}

void BlendMaterials::swap(int first, int second) {
  std::swap(m_slots[std::size_t(first)], m_slots[std::size_t(second)]);
  Q_EMIT changed();
}

namespace {
constexpr int slotEms = 17;
}

BlendSlots::BlendSlots(const Document& document, BlendMaterials& materials)
    : m_document(document), m_materials(materials), m_swap(new QToolButton), m_add(new QToolButton) {
  build();
  for (int i = 0; i < widgets::maxBlended; ++i) connectSlot(i);
  connect(m_swap, &QToolButton::clicked, this, [this] { m_materials.swap(0, 1); });
  connect(m_add, &QToolButton::clicked, &m_materials, &BlendMaterials::addSlot);
}

widgets::MaterialSlotWidget* BlendSlots::nearestSlot(const QPointF& position) const {
  const QPoint inside = widget()->mapFrom(viewport(), position.toPoint());
  const auto distance = [&](int slot) { return std::abs(slotWidget(slot).geometry().center().y() - inside.y()); };
  int nearest = 0;
  for (int slot = 1; slot < m_materials.count(); ++slot)
    if (distance(slot) < distance(nearest)) nearest = slot;
  return &slotWidget(nearest);
}

void BlendSlots::offerTo(widgets::MaterialSlotWidget* widget, const QDropEvent& event) {
  if (widget == m_offered) return;
  QDragLeaveEvent leave;
  if (m_offered) QCoreApplication::sendEvent(m_offered, &leave);
  m_offered = widget;
  if (!widget) return;
  QDragEnterEvent enter(widget->rect().center(), event.possibleActions(), event.mimeData(), event.buttons(),
                        event.modifiers());
  QCoreApplication::sendEvent(widget, &enter);
}

void BlendSlots::dragEnterEvent(QDragEnterEvent* event) {
  if (widgets::draggedMaterial(event->mimeData()).isEmpty()) return;
  offerTo(nearestSlot(event->position()), *event);
  event->acceptProposedAction();
}

void BlendSlots::dragMoveEvent(QDragMoveEvent* event) {
  offerTo(nearestSlot(event->position()), *event);
  event->acceptProposedAction();
}

void BlendSlots::dragLeaveEvent(QDragLeaveEvent* event) {
  if (m_offered) QCoreApplication::sendEvent(std::exchange(m_offered, nullptr), event);
}

void BlendSlots::dropEvent(QDropEvent* event) {
  offerTo(nearestSlot(event->position()), *event);
  QCoreApplication::sendEvent(std::exchange(m_offered, nullptr), event);
}

void BlendSlots::build() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 4, 0);
  column->setSpacing(4);
  for (int i = 0; i < widgets::maxBlended; ++i) {
    m_widgets.push_back(new widgets::MaterialSlotWidget(QChar(u'A' + i)));
    column->addWidget(m_widgets.back());
  }
  m_swap->setText(tr("S&wap A and B"));
  m_swap->setToolTip(tr("Exchanges the materials A and B"));
  m_add->setText(tr("Add a ma&terial"));
  m_add->setToolTip(tr("Adds a third or fourth material; the slider becomes a triangle or a square"));
  auto* buttons = new QHBoxLayout;
  for (QToolButton* button : {m_swap, m_add}) {
    button->setFocusPolicy(Qt::StrongFocus);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  column->addLayout(buttons);
  column->addStretch();
  setWidget(content);
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);  // what it holds has the focus
  viewport()->setAcceptDrops(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFixedWidth(slotEms * fontMetrics().height());
}

void BlendSlots::connectSlot(int slot) {
  connect(&slotWidget(slot), &widgets::MaterialSlotWidget::materialDropped, this, [this, slot](const QString& id) {
    Q_EMIT touched();
    m_materials.read(slot, id);
  });
  connect(&slotWidget(slot), &widgets::MaterialSlotWidget::currentRequested, this, [this, slot] {
    Q_EMIT touched();
    m_materials.useCurrent(slot);
  });
  connect(&slotWidget(slot), &widgets::MaterialSlotWidget::fileRequested, this, [this, slot] { askForFile(slot); });
  connect(&slotWidget(slot), &widgets::MaterialSlotWidget::clearRequested, this, [this, slot] {
    if (m_materials.count() > widgets::minBlended)
      m_materials.removeSlot(slot);
    else
      m_materials.clear(slot);
  });
}

void BlendSlots::askForFile(int slot) {
  auto* dialog = new QFileDialog(this, tr("Material %1").arg(QChar(u'A' + slot)),
                                 widgets::dialogFolder(QStringLiteral("open")), materialFilter());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this, slot](const QString& path) {
    widgets::rememberDialogFolder(QStringLiteral("open"), path);
    Q_EMIT touched();
    m_materials.read(slot, path);
  });
  dialog->open();
}

void BlendSlots::showMaterials(const std::vector<double>& weights) {
  for (int i = 0; i < widgets::maxBlended; ++i) {
    slotWidget(i).setVisible(i < m_materials.count());
    slotWidget(i).setCurrentAvailable(m_document.material() != nullptr);
    if (i < m_materials.count()) showMaterial(i, weights[std::size_t(i)]);
  }
  m_add->setEnabled(m_materials.count() < widgets::maxBlended);
}

void BlendSlots::showMaterial(int slot, double weight) {
  widgets::SlotContent content;
  if (const BlendMaterial* material = m_materials.at(slot))
    content = {material->name, material->description, material->picture, {}};
  content.removable = m_materials.count() > widgets::minBlended;
  content.note = m_materials.isReading(slot) ? tr("Opening...")
                 : content.name.isEmpty()    ? QString()
                                             : widgets::weightText(weight);
  if (const QString failure = m_materials.failure(slot); !failure.isEmpty()) {
    content.note = tr("Could not be opened");
    content.toolTip = failure;
    content.failed = true;
  }
  slotWidget(slot).setContent(content);
}

void BlendSlots::showWeights(const std::vector<double>& weights) {
  for (int i = 0; i < m_materials.count(); ++i)
    if (m_materials.at(i) && !m_materials.isReading(i) && m_materials.failure(i).isEmpty())
      slotWidget(i).setNote(widgets::weightText(weights[std::size_t(i)]));
}

}  // namespace gonio::app

#include "moc_blend_slots.cpp"
