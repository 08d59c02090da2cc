// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QScrollArea>

#include "app/gonio/interpolation/blend_materials.h"

class QToolButton;

namespace gonio::widgets {
class MaterialSlotWidget;
}

namespace gonio::app {

/// The material slots of a blend.
class BlendSlots : public QScrollArea {
  Q_OBJECT

 public:
  BlendSlots(const Document& document, BlendMaterials& materials);

  widgets::MaterialSlotWidget& slotWidget(int slot) const { return *m_widgets[std::size_t(slot)]; }
  void showMaterials(const std::vector<double>& weights);
  void showWeights(const std::vector<double>& weights);

 Q_SIGNALS:
  /// The user filled a slot.
  void touched();

 protected:
  /// Drops beside a slot go to the nearest one.
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void offerTo(widgets::MaterialSlotWidget* widget, const QDropEvent& event);
  widgets::MaterialSlotWidget* nearestSlot(const QPointF& position) const;
  void build();
  void connectSlot(int slot);
  void showMaterial(int slot, double weight);
  void askForFile(int slot);

  const Document& m_document;
  BlendMaterials& m_materials;
  std::vector<widgets::MaterialSlotWidget*> m_widgets;
  QToolButton *m_swap, *m_add;
  widgets::MaterialSlotWidget* m_offered = nullptr;  ///< target of a drag beside the slots
};

}  // namespace gonio::app
