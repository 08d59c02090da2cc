// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <vector>

#include "app/gonio/interpolation/blend_materials.h"
#include "widgets/preview/preview_content.h"

namespace gonio::widgets {
class MaterialSlotWidget;
}

namespace gonio::app {

/// The material slots of the Scene dock, for the further materials of scenes with several materials. Not part of the
/// document.
class SceneMaterialSlots : public QWidget {
  Q_OBJECT

 public:
  /// Number of material slots in addition to that of the edited material.
  static constexpr int count = 3;

  SceneMaterialSlots(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// Shows the material slots of a scene.
  void showScene(const Scene& scene);
  /// One per material slot; empty: the edited material.
  std::vector<widgets::SceneMaterial> materials() const;
  /// A file, a .gonio document, or a library's material by its id.
  void read(int slot, const QString& id);
  widgets::MaterialSlotWidget& slotWidget(int slot) const { return *m_slots[std::size_t(slot)].widget; }

 Q_SIGNALS:
  void changed();
  void failed(const QString& title, const QString& text);

 private:
  struct OtherMaterial {
    BlendMaterial end;
    widgets::SceneMaterial shown;
  };
  struct Slot {
    widgets::MaterialSlotWidget* widget;
    std::optional<OtherMaterial> other;
    QString failure;
  };
  static OtherMaterial prepared(BlendMaterial end);
  void fill(int slot, const QString& name, std::function<BlendMaterial(const TaskControl&)> make);
  void useCurrent(int slot);
  void clear(int slot);
  void askForFile(int slot);
  void show(int slot);

  Document& m_document;
  BackgroundTasks& m_tasks;
  std::vector<Slot> m_slots;
};

}  // namespace gonio::app
