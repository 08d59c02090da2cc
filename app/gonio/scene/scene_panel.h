// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "app/gonio/document/background_task.h"
#include "app/gonio/interpolation/blend_slots.h"
#include "core/rendering/effect_costs.h"
#include "widgets/preview/preview_content.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;
namespace gonio::widgets {
class MaterialSlotWidget;
}
namespace gonio::widgets {
class EffectList;
class PreviewWidget;
}  // namespace gonio::widgets

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
  void showScene(const rendering::Scene& scene);
  /// One per material slot; empty: the edited material.
  std::vector<widgets::SlotMaterial> materials() const;
  /// A file, a .gonio document, or a library's material by its id.
  void read(int slot, const QString& id);

 Q_SIGNALS:
  void changed();
  void failed(const QString& title, const QString& text);

 private:
  struct OtherMaterial {
    BlendMaterial end;
    widgets::SlotMaterial shown;
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

/// Title of a bundled scene or environment, e.g. "Shader ball" for "shader-ball".
QString sceneTitle(const std::string& name);

/// The Scene dock: the choice of the scene, the plan of its effects with a switch and the measured cost of each, and
/// the SNR of the preview's picture against that of the path tracer.
class ScenePanel : public QWidget {
  Q_OBJECT

 public:
  ScenePanel(widgets::PreviewWidget& preview, Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// Opens a bundled scene, a scene file or a mesh: reads it in the background and shows it, then calls `shown`.
  /// @param pose of a mesh; nothing: as it was last shown.
  void open(const QString& nameOrPath, std::optional<rendering::MeshPose> pose = {},
            const std::function<void()>& shown = {});
  /// Asks the user for a file and opens it.
  void askForFile();
  /// Whether the scene is a mesh, which turnMesh() turns by 90 degrees about the axis that points up.
  bool showsMesh() const;
  void turnMesh();
  SceneMaterialSlots& otherSlots() const { return *m_otherSlots; }
  const std::optional<rendering::EffectCosts>& costs() const { return m_costs; }
  QString result() const;

 Q_SIGNALS:
  void failed(const QString& title, const QString& text);
  /// What the readers of the scene's files changed.
  void warned(const QString& text);

 private:
  QWidget* buildTop();
  QWidget* buildBottom();
  void show(const rendering::Scene& scene);
  void showScene(const rendering::Scene& scene);
  void refresh();
  void measureCosts();
  void compareWithReference();
  void planMayChange();
  void checkPlan();

  widgets::PreviewWidget& m_preview;
  const Document& m_document;
  BackgroundTasks& m_tasks;
  QComboBox *m_scenes, *m_up, *m_sampling;
  QLabel *m_description, *m_result;
  QPushButton *m_turn, *m_measure, *m_compare;
  QSpinBox* m_reflections;
  SceneMaterialSlots* m_otherSlots;
  widgets::EffectList* m_effects;
  std::optional<rendering::EffectCosts> m_costs;
  QTimer m_checkDelay;
};

}  // namespace gonio::app
