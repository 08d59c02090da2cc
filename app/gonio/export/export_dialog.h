// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>
#include <QImage>
#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <map>
#include <tuple>

#include "app/gonio/export/export_controller.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSettings;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace gonio::app {

/// Two pictures of the same size side by side with their names below; missing pictures leave an empty area.
class ExportPictures : public QWidget {
  Q_OBJECT

 public:
  explicit ExportPictures(QWidget* parent = nullptr);

  void setPictures(const QImage& original, const QImage& exported);
  void setExportedName(const QString& name);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage m_pictures[2];
  QString m_names[2];
};

/// File > Export for Renderer: a choice of targets. For each it shows its capabilities and, from a trial export in the
/// background, rendered SNR, bytes and pictures. Target, SNR and folder are remembered.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// Precondition: the document has a material. @param scene scene of the preview, written on request.
  ExportDialog(ExportController& controller, QSettings& settings, const rendering::Scene& scene, QWidget* parent);
  ~ExportDialog() override;

  const exports::ExportTarget& target() const;
  void chooseTarget(std::string_view id);
  /// Absolute path without the target's suffixes; empty if the field is empty. A relative entry is resolved against the
  /// folder with which the dialog starts.
  QString name() const;
  void setName(const QString& name);
  /// The trial of the selected target with the current options; null while it is being made or if it failed, coarse
  /// until it is refined.
  ExportTrialPtr trial() const;
  /// Whether a scene is written in addition to the material.
  bool withScene() const;

  void accept() override;

 private:
  QWidget* targetList();
  QWidget* details();
  QWidget* nameRow();
  QList<QTreeWidgetItem*> rows() const;
  QString proposedName() const;
  QString startFolder() const;
  void restore();
  void remember();
  exports::ExportOptions options() const;
  void showTarget();
  void startTrial();
  void showTrial();
  void showFiles();
  void showProgress();
  void browse();
  bool mayReplace();
  const rendering::Scene* writtenScene() const { return withScene() ? m_scene.get() : nullptr; }

  ExportController& m_controller;
  QSettings& m_settings;
  const std::shared_ptr<const rendering::Scene> m_scene;
  const materials::EditedMaterial m_material;
  QString m_error;  ///< of the last trial
  QTimer m_delay;
  QTreeWidget* m_targets;
  QLabel *m_purpose, *m_description;
  ExportPictures* m_pictures;
  QToolButton* m_match;  ///< opens m_numbers and m_description
  QLabel *m_numbers, *m_warnings, *m_files;
  QProgressBar* m_progress;
  QDoubleSpinBox* m_snr;
  QCheckBox *m_withScene, *m_keep;
  QLineEdit* m_name;
  QPushButton* m_export;
};

}  // namespace gonio::app
