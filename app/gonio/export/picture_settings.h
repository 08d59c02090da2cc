// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QColor>
#include <QWidget>

#include "app/gonio/document/picture_export.h"

class QCheckBox;
class QComboBox;
class QPushButton;
class QSettings;
class QSpinBox;

namespace gonio::app {

/// Size, samples and background of a picture that is to be rendered.
class PictureSettings : public QWidget {
  Q_OBJECT

 public:
  /// @param preview the size that "As the preview" means.
  explicit PictureSettings(const QSize& preview, QWidget* parent = nullptr);

  /// @param environmentShown whether the preview shows the environment behind the objects: then the picture does.
  void restore(const QSettings& settings, bool environmentShown);
  void remember(QSettings& settings) const;
  RefinementLimits limits() const;
  /// Of the widest label, so that other rows can stand below them.
  int labelWidth() const;
  /// Sets what is chosen here.
  void apply(PictureExport& picture) const;

 Q_SIGNALS:
  /// What a sample costs is another: size, background.
  void costChanged();
  /// How many samples, how much time.
  void limitsChanged();

 private:
  QWidget* sizeRow();
  QWidget* qualityRow();
  void connectParts();
  void chooseSize(int preset);
  /// Names the size in the list.
  void showSize();
  void chooseColour();
  void showChoices();

  const QSize m_preview;
  QColor m_colour;
  QComboBox *m_sizes, *m_backgrounds;
  QSpinBox *m_width, *m_height, *m_samples, *m_seconds;
  QCheckBox* m_limited;
  QPushButton* m_colourButton;
};

}  // namespace gonio::app
