// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QObject>
#include <QScrollArea>
#include <optional>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"

class QToolButton;
namespace gonio::widgets {
class MaterialSlotWidget;
}

namespace gonio::app {

/// One of the materials of a blend, with its image and the document that reproduces it.
struct BlendMaterial {
  QString name, description;
  QImage picture;
  interpolation::InterpolationMaterial material;  ///< the material with its edits
  documents::EditDocument source;                 ///< document to reproduce it, with resolved paths
};

/// Reads a file, a .gonio document or a material of the library, and renders its picture. @throws Error, Cancelled.
BlendMaterial readBlendMaterial(const QString& id, const TaskControl& control);
/// Makes a material of a blend from an open material, with the edits of `source`. @throws Cancelled.
BlendMaterial makeBlendMaterial(const LoadedMaterial& material, const QString& name, documents::EditDocument source,
                                const TaskControl& control);

/// The two to four materials of the Blend panel, which are read in the background. Not part of the document.
class BlendMaterials : public QObject {
  Q_OBJECT

 public:
  BlendMaterials(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr);

  int count() const { return int(m_slots.size()); }
  /// Null if the slot is empty. While a new material is read, the old one stays.
  const BlendMaterial* at(int slot) const;
  bool isReading(int slot) const;
  /// Error message of the slot, or empty.
  QString failure(int slot) const { return m_slots[std::size_t(slot)].failure; }
  /// Whether every slot has a material.
  bool isComplete() const;
  bool isReading() const;
  /// All materials. Precondition: isComplete().
  std::vector<interpolation::InterpolationMaterial> materials() const;

  /// A file, a .gonio document, or a library's material by its id.
  void read(int slot, const QString& id);
  /// Uses the document's material in its current state, with its edits.
  void useCurrent(int slot);
  void clear(int slot);
  void addSlot();
  void removeSlot(int slot);
  void swap(int first, int second);

 Q_SIGNALS:
  /// A slot was filled, emptied, added or removed; isComplete() and materials() may have changed.
  void changed();
  /// Only the text of a slot changed: reading started or failed.
  void stateChanged();
  void failed(const QString& title, const QString& text);

 private:
  struct Slot {
    std::optional<BlendMaterial> material;
    QString failure;
    int key;  ///< number of its task
  };
  void fill(int slot, const QString& title, const QString& name, std::function<BlendMaterial(const TaskControl&)> make);
  int slotOf(int key) const;
  QString taskKey(int key) const;

  Document& m_document;
  BackgroundTasks& m_tasks;
  std::vector<Slot> m_slots;
  int m_nextKey = 0;
};

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
