// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>

#include "app/gonio/export/export_controller.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSettings;

namespace gonio::app {

/// Exports several materials of the library, without edits, to one target and one folder. Each is a separate task that
/// can be cancelled. Target, SNR and folder are remembered, shared with File > Export for Renderer.
class BatchDialog : public QDialog {
  Q_OBJECT

 public:
  /// @param ids materials of the library, at least one.
  BatchDialog(ExportController& controller, QSettings& settings, const QStringList& ids, QWidget* parent);

  const exports::ExportTarget& target() const;
  void chooseTarget(std::string_view id);
  QLineEdit& folder() { return *m_folder; }

  void accept() override;

 private:
  void build();
  void browse();
  void showFiles();
  ExportRequest request(qsizetype index) const;
  /// Names of files that already exist.
  QStringList existing() const;

  ExportController& m_controller;
  QSettings& m_settings;
  const QStringList m_ids, m_names;
  QComboBox* m_targets;
  QDoubleSpinBox* m_snr;
  QLineEdit* m_folder;
  QCheckBox* m_replace;
  QLabel *m_description, *m_files;
  QPushButton* m_export;
};

}  // namespace gonio::app
