// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

class QComboBox;
class QImage;

namespace gonio::widgets {
class NumberField;
class ParameterSlider;
class PreviewWidget;
}  // namespace gonio::widgets

namespace gonio::app {

class BackgroundTasks;
class EnvironmentController;
class ScenePanel;

/// The strip below the preview: scene, light, background and exposure.
class ViewStrip : public QWidget {
  Q_OBJECT

 public:
  ViewStrip(widgets::PreviewWidget& preview, ScenePanel& scene, EnvironmentController& environment,
            BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// Renders the icons of the scenes when their list is shown.
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Without the slider of the exposure, which a narrow strip leaves out; its field remains.
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// The user wants to choose a file.
  void sceneFileRequested();
  void environmentFileRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void build();
  int sliderRoom() const;
  void connectParts();
  void fillLights();
  /// Renders small pictures of the bundled environments in the background.
  void drawLights();
  /// The same for the bundled scenes, once their list is opened.
  void drawScenes();
  void setLightIcon(const QString& name, const QImage& picture);
  void refresh();
  void chooseLight(int index);
  void chooseBackground(int index);

  widgets::PreviewWidget& m_preview;
  ScenePanel& m_scene;
  EnvironmentController& m_environment;
  BackgroundTasks& m_tasks;
  bool m_hasSceneIcons = false;
  QComboBox *m_scenes, *m_lights, *m_backgrounds;
  widgets::ParameterSlider* m_slider;
  widgets::NumberField* m_exposure;
};

}  // namespace gonio::app
