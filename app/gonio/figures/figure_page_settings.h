// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "core/figures/figure_description.h"

class QComboBox;
class QSpinBox;
class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
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

/// The settings of the page of a figure: title, width, font, inset and error maps.
class FigurePageSettings : public QWidget {
  Q_OBJECT

 public:
  explicit FigurePageSettings(QWidget* parent = nullptr);

  /// Writes the settings into a description.
  void apply(figures::FigureDescription& description) const;
  /// Shows the settings of a description without a signal.
  void setDescription(const figures::FigureDescription& description);
  /// Sets the inset, as drawn on the page, and switches it on.
  void setInset(const figures::FigureInset& inset);

 Q_SIGNALS:
  void changed();

 private:
  void buildPage(QFormLayout& form);
  void buildParts(QFormLayout& form);
  void connectParts();
  void showInset(const figures::FigureInset& inset);
  /// Sets the ranges of the position, which depend on the size: the inset must be inside the picture.
  void limitInset();
  void refresh();

  QLineEdit* m_title;
  QComboBox *m_columns, *m_font;
  QDoubleSpinBox* m_fontSize;
  double m_exactFontSize = 0;
  widgets::NumberField *m_x, *m_y, *m_side, *m_maximum;
  QCheckBox *m_inset, *m_maps, *m_fixed;
};

}  // namespace gonio::app
