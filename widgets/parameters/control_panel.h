// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/editing/differential_edit.h"

class QLabel;
class QVBoxLayout;

namespace gonio::widgets {

class ParameterRow;

/// The artist's controls (editing::artistControls()) of an edit, and the colour of the model's diffuse term. A line
/// below the controls states what the one that was moved last changes; controls without parameters in the model are
/// disabled, with an explanation. Does not own the values, like ParameterPanel.
class ControlPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ControlPanel(QWidget* parent = nullptr);

  /// Null: nothing can be edited; `emptyText` states the reason.
  void setEdit(const editing::DifferentialEdit* edit, const QString& emptyText = {});

  /// Null if nothing can be edited.
  ParameterRow* row(editing::ArtistControl control) const;
  /// The parameters that a control changes, "Roughness 0.3 → 0.6"; at most two are named. Empty: it changes none.
  QString changes(editing::ArtistControl control) const;
  /// The control under the pointer, else the one with the focus.
  std::optional<editing::ArtistControl> currentControl() const;
  /// The model's parameter of the diffuse colour if its row is under the pointer or has the focus.
  std::optional<int> currentDiffuseParameter() const;

 Q_SIGNALS:
  void editingStarted();
  void controlEdited(gonio::editing::ArtistControl control, const gonio::Rgb& value);
  void controlResetRequested(gonio::editing::ArtistControl control);
  /// The model's own parameter for the colour of the diffuse term.
  void diffuseEdited(int parameter, const gonio::Rgb& value);
  void diffuseResetRequested(int parameter);
  void editingFinished();

 private:
  void build(const models::ModelSpec& spec);
  void showEmpty(const QString& text);
  void addControl(editing::ArtistControl control);
  void addDiffuse();
  ParameterRow* addRow(const models::ParameterSpec& spec);
  void showChanges(const editing::DifferentialEdit& edit);

  struct Control {
    ParameterRow* row = nullptr;
    QStringList changes = {};
  };

  const ParameterRow* currentRow() const;

  const models::ModelSpec* m_spec = nullptr;
  QVBoxLayout* m_layout;
  QWidget* m_content = nullptr;
  std::vector<Control> m_controls;  ///< in the order of ArtistControl; empty while nothing can be edited
  ParameterRow* m_diffuse = nullptr;
  std::optional<models::ParameterSpec> m_diffuseSpec;  ///< of the model, with the name used in this panel
  int m_diffuseParameter = -1;
  QLabel* m_line;                                 ///< the changes of one control, and in its tooltip those of all
  std::optional<editing::ArtistControl> m_moved;  ///< by the user, last
};

}  // namespace gonio::widgets
