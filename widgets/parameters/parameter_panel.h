// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <vector>

#include "core/models/model.h"

class QLabel;
class QVBoxLayout;

namespace gonio::widgets {

class ParameterRow;

/// The parameters of a model, grouped, each as its ParameterSpec describes it and nothing else; the many coefficients
/// of a series are folded away at first, and what does not matter with the present choices is grey. The panel shows
/// values that others own: it emits what the user wants and shows the result by setValues().
class ParameterPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterPanel(QWidget* parent = nullptr);

  /// Rebuilds the rows; null shows an explaining text. `emptyText` replaces the default one.
  void setModel(const models::ModelSpec* spec, const QString& emptyText = {});
  /// @param reference what a reset goes back to: the fitted values.
  void setValues(const models::ParameterValues& values, const models::ParameterValues& reference);
  /// Again, after the units of the program have changed.
  void showUnits();

  std::size_t rowCount() const { return m_rows.size(); }
  ParameterRow* row(std::size_t parameter) const { return m_rows[parameter]; }
  /// The parameter under the pointer, else the one with the focus, else -1.
  int currentParameter() const;

 Q_SIGNALS:
  void editingStarted();
  void valueEdited(int parameter, const gonio::Rgb& value);
  void editingFinished();
  void resetRequested(int parameter);

 private:
  void addGroup(models::ParameterGroup group);
  void addRow(std::size_t index, QWidget* parent);

  const models::ModelSpec* m_spec = nullptr;
  QVBoxLayout* m_layout;
  QWidget* m_content = nullptr;
  std::vector<ParameterRow*> m_rows;
  bool m_coefficientsShown = false;  ///< kept from one model to the next
};

}  // namespace gonio::widgets
