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

/// The grouped parameters of a model, as their ParameterSpecs describe them; coefficients of a series are collapsed
/// initially, and parameters without effect under the current choices are disabled. The panel does not own the values:
/// it emits the user's changes, and setValues() shows the result.
class ParameterPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterPanel(QWidget* parent = nullptr);

  /// Rebuilds the rows. Null shows `emptyText`, or a default text if it is empty.
  void setModel(const models::ModelSpec* spec, const QString& emptyText = {});
  /// @param reference the fitted values, to which a reset returns.
  void setValues(const models::ParameterValues& values, const models::ParameterValues& reference);
  /// Updates the display after a change of the program's units.
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
  bool m_coefficientsShown = false;  ///< the same for the next model
};

}  // namespace gonio::widgets
