// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "core/figures/figure_description.h"

class QComboBox;
class QSpinBox;

namespace gonio::widgets {
class NumberField;
}

namespace gonio::app {

/// The settings for rendering and display of the pictures of a figure.
class FigurePictureSettings : public QWidget {
  Q_OBJECT

 public:
  explicit FigurePictureSettings(QWidget* parent = nullptr);

  figures::FigurePictures pictures() const;
  /// Sets the pictures without a signal.
  void setPictures(const figures::FigurePictures& pictures);

 Q_SIGNALS:
  void changed();

 private:
  void build();
  QComboBox* nameBox(const QString& usual, const std::vector<std::string>& names, const QString& file);
  /// Uses the chosen entry of a box; asks for a file if it is the last one.
  void choose(QComboBox& box, const QString& title, const QString& filter);
  void selectName(QComboBox& box, const std::string& name);

  QComboBox *m_scene, *m_environment, *m_toneMap;
  QSpinBox *m_size, *m_samples;
  widgets::NumberField* m_exposure;
  std::string m_sceneName, m_environmentName;
};

}  // namespace gonio::app
