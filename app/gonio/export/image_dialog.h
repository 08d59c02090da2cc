// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>
#include <QTimer>
#include <optional>

#include "app/gonio/document/file_exports.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSettings;
namespace gonio::widgets {
class PreviewWidget;
}

namespace gonio::app {

class ComparisonController;

/// A function that measures the numbers of the current comparison, for a line below a picture: "gold-paint, Edited
/// against Measured: BRDF SNR 23.4 dB; ...". The function takes about a second; call it outside the GUI thread.
FileExports::Caption comparisonCaption(const ComparisonController& comparison, const QString& material);

class ComparisonController;
class PictureSettings;

/// File > Export Image: the scene of the preview rendered with a selected size and quality, with estimates of time and
/// noise; or the preview's picture itself, to which names, scale and numbers can be added if it is a comparison. The
/// choices are remembered.
class ImageDialog : public QDialog {
  Q_OBJECT

 public:
  /// The objects that the dialog uses; they must outlive it.
  struct Parts {
    Document& document;
    FileExports& exports;
    BackgroundTasks& tasks;
    const ComparisonController& comparison;
    widgets::PreviewWidget& preview;
    QSettings& settings;
  };

  /// Precondition: the document has a material. @param name proposed file name, without folder and suffix.
  ImageDialog(const Parts& parts, const QString& name, QWidget* parent);
  ~ImageDialog() override;

  /// The current request, if the picture is rendered.
  PictureExport request() const;
  /// Whether the picture is rendered; if not, the preview's picture is used.
  bool rendersPicture() const;
  /// Nullopt until it has been measured.
  const std::optional<rendering::PictureEstimate>& estimate() const { return m_estimate; }
  QLineEdit& path() { return *m_path; }

  void accept() override;

 private:
  void build();
  QWidget* choiceRow();
  QWidget* pathRow();
  void connectParts();
  void restore(const QString& name);
  void remember();
  void browse();
  void showChoices();
  void startEstimate();
  void showEstimate();
  void exportPreview();
  bool mayReplace();

  const Parts m_parts;
  QTimer m_delay;
  std::optional<rendering::PictureEstimate> m_estimate;
  QString m_estimateError;
  QButtonGroup* m_source;
  PictureSettings* m_settings;
  QCheckBox* m_labels;
  QComboBox* m_format;
  QPushButton* m_export;
  QLineEdit* m_path;
  QLabel* m_cost;
};

}  // namespace gonio::app
