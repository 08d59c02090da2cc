// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/editing/differential_edit.h"

class QLabel;
class QVBoxLayout;

namespace gonio::widgets {

class ParameterRow;

/// The artist's controls (editing::artistControls()) of an edit, and the colour of the model's body. Under a control
/// that was moved stands what it does to which parameters; what the model has no parameter for is grey and says so.
/// Shows values that others own, as ParameterPanel does.
class ControlPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ControlPanel(QWidget* parent = nullptr);

  /// Null: nothing can be edited, `emptyText` says why.
  void setEdit(const editing::DifferentialEdit* edit, const QString& emptyText = {});

  /// Null for no row (nothing can be edited).
  ParameterRow* row(editing::ArtistControl control) const;
  ParameterRow* bodyRow() const { return m_body; }
  /// What is said under a control; empty while it changes nothing.
  QString changesText(editing::ArtistControl control) const;
  /// The control under the pointer, else the one with the focus.
  std::optional<editing::ArtistControl> currentControl() const;
  /// The model's parameter of the diffuse colour where its row is under the pointer, else where it has the focus.
  std::optional<int> currentBodyParameter() const;

 Q_SIGNALS:
  void editingStarted();
  void controlEdited(gonio::editing::ArtistControl control, const gonio::Rgb& value);
  void controlResetRequested(gonio::editing::ArtistControl control);
  /// The model's own parameter for the body's colour.
  void bodyEdited(int parameter, const gonio::Rgb& value);
  void bodyResetRequested(int parameter);
  void editingFinished();

 private:
  void build(const models::ModelSpec& spec);
  void showEmpty(const QString& text);
  void addControl(editing::ArtistControl control);
  void addBody();
  ParameterRow* addRow(const models::ParameterSpec& spec);
  void showChanges(const editing::DifferentialEdit& edit);
  void placeChanges();

  struct Control {
    ParameterRow* row = nullptr;
    QLabel* changes = nullptr;
  };

  const ParameterRow* currentRow() const;

  const models::ModelSpec* m_spec = nullptr;
  QVBoxLayout* m_layout;
  QWidget* m_content = nullptr;
  std::vector<Control> m_controls;  ///< in the order of ArtistControl; empty while nothing can be edited
  ParameterRow* m_body = nullptr;
  std::optional<models::ParameterSpec> m_bodySpec;  ///< of the model, under the name that it has here
  int m_bodyParameter = -1;
  bool m_editing = false;  ///< a row is under the hand
};

}  // namespace gonio::widgets
