// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/interpolation/blend_slots.h"

#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QToolButton>
#include <QVBoxLayout>
#include <cstdlib>
#include <utility>

#include "app/gonio/document/material_files.h"
#include "widgets/inputs/dialog_folder.h"
#include "widgets/interpolation/blend_pad.h"
#include "widgets/interpolation/blend_position.h"
#include "widgets/interpolation/material_slot_widget.h"
#include "widgets/interpolation/prepared_blend.h"
#include "widgets/library/material_drag.h"

namespace gonio::app {

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
