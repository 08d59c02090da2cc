// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QComboBox>
#include <QWidget>
#include <vector>

#include "core/models/model.h"

class QPushButton;

namespace gonio::widgets {

class ElidedLabel;

/// A list of all models by family.
class ModelBox : public QComboBox {
  Q_OBJECT

 public:
  explicit ModelBox(QWidget* parent = nullptr);

  /// Null: none. Emits nothing.
  void setModel(const models::Model* model);

 Q_SIGNALS:
  /// By the user.
  void modelChosen(const gonio::models::Model* model);

 private:
  void fill();

  std::vector<const models::Model*> m_entries;  ///< of the list; null for a family's title
};

/// Rich text about a model: name, what it is for, formula, source.
QString modelToolTip(const models::ModelSpec& spec);

/// The choice of the fitted model: a list by family, a fit button, and what its accuracy costs.
class ModelPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ModelPanel(QWidget* parent = nullptr);

  /// Shows a model (null: none chosen). Emits nothing.
  void setModel(const models::Model* model);
  /// Shows the accuracy and the cost in one line below the model, and all numbers in its tooltip.
  void setCosts(const QString& line, const QString& details);
  /// During a fit the list remains enabled: choosing another model replaces the running fit.
  void setBusy(bool busy);

 Q_SIGNALS:
  void modelChosen(const gonio::models::Model* model);
  void fitRequested();

 private:
  ModelBox* m_models;
  QPushButton* m_fit;
  ElidedLabel* m_costs;
};

}  // namespace gonio::widgets
