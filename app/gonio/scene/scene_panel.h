// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/document/background_task.h"
#include "app/gonio/scene/scene_neighbours.h"
#include "core/rendering/effect_costs.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace gonio::widgets {
class EffectList;
class PreviewWidget;
}  // namespace gonio::widgets

namespace gonio::app {

/// What a bundled scene or environment is called: "Shader ball" of "shader-ball".
QString sceneTitle(const std::string& name);

/// The Scene dock: which scene the preview shows, the plan of its effects with a switch for each, what each was
/// measured to cost, and how far the preview's picture is from a converged one.
class ScenePanel : public QWidget {
  Q_OBJECT

 public:
  ScenePanel(widgets::PreviewWidget& preview, Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// A scene of the project, a scene file or a mesh: read in the background, shown, then `shown` is called.
  void open(const QString& nameOrPath, const std::function<void()>& shown = {});
  /// The same of a file that the user chooses.
  void askForFile();
  widgets::EffectList& effects() const { return *m_effects; }
  QComboBox& scenes() const { return *m_scenes; }
  QPushButton& measureButton() const { return *m_measure; }
  QPushButton& compareButton() const { return *m_compare; }
  SceneNeighbours& neighbours() const { return *m_neighbours; }
  const std::optional<EffectCosts>& costs() const { return m_costs; }
  QString result() const;

 Q_SIGNALS:
  void failed(const QString& title, const QString& text);

 private:
  QWidget* buildTop();
  QWidget* buildBottom();
  void show(const Scene& scene);
  void showScene(const Scene& scene);
  void refresh();
  void measureCosts();
  void compareWithReference();

  widgets::PreviewWidget& m_preview;
  BackgroundTasks& m_tasks;
  QComboBox* m_scenes;
  QLabel *m_description, *m_result;
  QPushButton *m_measure, *m_compare;
  SceneNeighbours* m_neighbours;
  widgets::EffectList* m_effects;
  std::optional<EffectCosts> m_costs;
};

}  // namespace gonio::app
