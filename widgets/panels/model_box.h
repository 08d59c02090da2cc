// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QComboBox>
#include <vector>

#include "core/models/model.h"

namespace gonio::widgets {

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

}  // namespace gonio::widgets
