// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QColor>
#include <QWidget>

#include "app/gonio/document/file_exports.h"

class QCheckBox;
class QComboBox;
class QPushButton;
class QSettings;
class QSpinBox;

namespace gonio::app {

/// Size, samples and background of a picture to be rendered.
class PictureSettings : public QWidget {
  Q_OBJECT

 public:
  /// @param preview the size for "As the preview".
  explicit PictureSettings(const QSize& preview, QWidget* parent = nullptr);

  /// @param environmentShown whether the preview shows the environment behind the objects; if so, the picture does,
  /// too.
  void restore(const QSettings& settings, bool environmentShown);
  void remember(QSettings& settings) const;
  rendering::RefinementLimits limits() const;
  /// Width of the widest label, for the alignment of other rows.
  int labelWidth() const;
  /// Writes the settings to a request.
  void apply(PictureExport& picture) const;

 Q_SIGNALS:
  /// The cost of a sample changed: size or background.
  void costChanged();
  /// The limits of samples or time changed.
  void limitsChanged();

 private:
  QWidget* sizeRow();
  QWidget* qualityRow();
  void connectParts();
  void chooseSize(int preset);
  /// Shows the size in the list.
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
