// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "app/gonio/document/history.h"
#include "app/gonio/document/loaded_material.h"
#include "core/editing/edit_document.h"
#include "core/fitting/fit.h"

namespace gonio::app {

/// What undo steps change: the fitted model and the edit on it.
struct EditState {
  std::optional<fitting::FitResult> fit;  ///< absent while the parameters come from a .gonio file
  std::optional<editing::DifferentialEdit> edit;
  std::optional<editing::FactorEdit> factors;  ///< absent while nobody touched the factor curves
};

/// An open material and its edit. The material is immutable; every change of the edit by the user is an undo step.
/// Opening, the automatic first fit, saving, camera and light are not.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);

  const LoadedMaterialPtr& material() const { return m_material; }
  const EditState& state() const { return m_state; }
  const std::optional<editing::DifferentialEdit>& edit() const { return m_state.edit; }
  const std::optional<editing::FactorEdit>& factors() const { return m_state.factors; }
  /// All edits in the order in which they are applied.
  std::vector<editing::Edit> edits() const { return editing::editStack(m_state.factors, m_state.edit); }
  const History& history() const { return m_history; }
  History& history() { return m_history; }
  bool isModified() const { return !m_history.isClean(); }
  /// Of the .gonio file; empty while it was never saved.
  QString path() const { return m_path; }
  /// For titles: the file's name, else the material's, else "Untitled".
  QString name() const;

  /// Starts anew with a material, without an edit; or with the edit of a .gonio file.
  void setMaterial(LoadedMaterialPtr material);
  void setMaterial(LoadedMaterialPtr material, const editing::EditDocument& stored, const QString& path);
  /// Counts as unsaved from now on (a recovered document).
  void markUnsaved() { m_history.resetClean(); }

  /// Another material takes the place of this one, without edits and never saved: one undo step, which brings back the
  /// material with its edits and its file.
  void replaceMaterial(LoadedMaterialPtr material, const QString& text);

  /// The automatic fit after opening: no undo step.
  void adoptFit(const fitting::FitResult& fit);
  /// One undo step with the old and the new values. The edit starts anew at the fitted values.
  void chooseFit(const fitting::FitResult& fit);

  /// All changes of one parameter between these two are one undo step.
  void beginInteraction();
  void endInteraction();
  void setParameter(int parameter, const Rgb& value);
  void resetParameter(int parameter);
  void resetAll();
  /// The model's edit: how much of its change is added, in [0, 1], and whether it counts at all.
  void setEditStrength(double strength);
  void setEditEnabled(bool enabled);
  /// Back to the fitted values at full strength: one undo step.
  void deleteEdit();
  /// One undo step; of one interaction, all together. Absent: no edit of factors.
  void setFactors(const std::optional<editing::FactorEdit>& factors, const QString& text);
  /// Replaces those edits that are given, in one undo step; `fit` too when the model's is one of another model.
  void paste(const std::optional<editing::FactorEdit>& factors, const std::optional<editing::DifferentialEdit>& edit,
             const std::optional<fitting::FitResult>& fit = {});

  /// What is written to a .gonio file.
  editing::EditDocument toEditDocument() const;
  void markSaved(const QString& path);

  /// For commands only.
  void setContent(LoadedMaterialPtr material, const EditState& state, const QString& path);
  void setState(const EditState& state);
  void setEditedValue(int parameter, const Rgb& value);
  void setEditShare(double strength, bool enabled);
  void replaceFactors(const std::optional<editing::FactorEdit>& factors);

 Q_SIGNALS:
  void materialChanged();
  /// By an undo step: the history goes on. After materialChanged().
  void materialReplaced();
  /// The model, the fit or all values changed.
  void stateChanged();
  /// Only edited values changed.
  void editChanged();
  /// Name, path or modified state changed.
  void titleChanged();

 private:
  void changeEditShare(double strength, bool enabled, const QString& text);
  void startAnew(LoadedMaterialPtr material, const EditState& state, const QString& path);

  LoadedMaterialPtr m_material;
  EditState m_state;
  QString m_path;
  History m_history;
  int m_interaction = 0;
  bool m_interacting = false;
};

/// The identity edit on a fit.
editing::DifferentialEdit identityEdit(const fitting::FitResult& fit);

}  // namespace gonio::app
