// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <vector>

#include "core/models/model.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace gonio::widgets {

/// Which model explains the material: a list by family, a fit button, and how well it fits.
class ModelPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ModelPanel(QWidget* parent = nullptr);

  /// Shows a model (null: none chosen) and text about its fit. Emits nothing.
  void setModel(const models::Model* model, const QString& residual);
  /// While a fit runs the list stays usable: choosing another model replaces the running fit.
  void setBusy(bool busy);

 Q_SIGNALS:
  void modelChosen(const gonio::models::Model* model);
  void fitRequested();

 private:
  void fillModels();

  QComboBox* m_models;
  std::vector<const models::Model*> m_entries;  ///< of the list; null for a family's title
  QPushButton* m_fit;
  QLabel* m_residual;
};

/// Rich text about a model: name, what it is for, formula, source.
QString modelToolTip(const models::ModelSpec& spec);

}  // namespace gonio::widgets
