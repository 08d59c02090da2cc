// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QComboBox>
#include <QWidget>
#include <vector>

#include "core/models/model.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace gonio::widgets {

/// A list of all models: the suggested ones first, then all by family.
class ModelBox : public QComboBox {
  Q_OBJECT

 public:
  explicit ModelBox(QWidget* parent = nullptr);

  /// Models that suit the material, which the list begins with. Emits nothing.
  void setSuggested(const std::vector<const models::Model*>& suggested);

  /// Null: none. Emits nothing.
  void setModel(const models::Model* model);

 Q_SIGNALS:
  /// By the user.
  void modelChosen(const gonio::models::Model* model);

 private:
  void fill();
  void addTitle(const QString& title);
  void addModel(const models::Model& model);

  std::vector<const models::Model*> m_suggested;
  std::vector<const models::Model*> m_entries;  ///< of the list; null for a title
};

/// Rich text about a model: name, what it is for, formula, source.
QString modelToolTip(const models::ModelSpec& spec);

/// The choice of the fitted model: a list and a fit button.
class ModelPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ModelPanel(QWidget* parent = nullptr);

  /// Shows a model (null: none chosen). Emits nothing.
  void setModel(const models::Model* model);
  /// As ModelBox::setSuggested().
  void setSuggested(const std::vector<const models::Model*>& suggested) { m_models->setSuggested(suggested); }
  /// During a fit the list remains enabled: choosing another model replaces the running fit.
  void setBusy(bool busy);

 Q_SIGNALS:
  void modelChosen(const gonio::models::Model* model);
  void fitRequested();

 private:
  ModelBox* m_models;
  QPushButton* m_fit;
};

/// Accuracy and cost in one line; a press shows all numbers below it.
class CostLine : public QWidget {
  Q_OBJECT

 public:
  explicit CostLine(QWidget* parent = nullptr);

  /// An empty line hides both.
  void setCosts(const QString& line, const QString& details);
  QString line() const;

 private:
  QToolButton* m_line;
  QLabel* m_details;
};

}  // namespace gonio::widgets
