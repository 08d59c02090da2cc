// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "app/gonio/document/history.h"
#include "app/gonio/document/loaded_material.h"
#include "core/documents/edit_document.h"
#include "core/fitting/fit.h"
#include "core/materials/edited_material.h"

namespace gonio::app {

/// The state changed by undo steps.
struct EditState {
  editing::EditList edits;
  int selected = -1;  ///< the edit changed by the panels; -1: none
  /// The direction that is used as the incident one in measurements that are not reciprocal (RGL and UTIA files).
  IncidentDirection incident = IncidentDirection::viewer;
};

/// The edit that the panel of a kind of content shows and changes: the selected one if it has that kind, else the last
/// one that has it; -1: none.
template <class Content>
int activeIndex(const EditState& state) {
  const auto holds = [&](int i) { return std::holds_alternative<Content>(state.edits[std::size_t(i)].content); };
  if (state.selected >= 0 && holds(state.selected)) return state.selected;
  int index = int(state.edits.size()) - 1;
  while (index >= 0 && !holds(index)) --index;
  return index;
}

/// An open material and its edits. The material is immutable. Every change of the edits by the user is an undo step.
/// Opening, the automatic first fit, saving, selecting an edit, and changes of camera and light are not.
class Document : public QObject {
  Q_OBJECT

 public:
  /// A material with its file, fits and edits.
  struct Content {
    LoadedMaterialPtr material;
    EditState state;
    QString path;                          ///< of the .gonio file; empty if it was never saved
    std::vector<fitting::FitResult> fits;  ///< known fits of the material, newest last
  };

  explicit Document(QObject* parent = nullptr);

  const LoadedMaterialPtr& material() const { return m_content.material; }
  /// The BRDF that is shown and edited: the material's base, read with the incident direction of the state
  /// (EditState::incident). Null without a material.
  std::shared_ptr<const Brdf> base() const;
  /// The material with its edits, under the document's name, for exports. Null BRDFs without a material.
  materials::EditedMaterial edited() const;
  const EditState& state() const { return m_content.state; }
  /// In the order in which they are applied.
  const editing::EditList& edits() const { return m_content.state.edits; }
  /// The edit at activeIndex(); null if there is none.
  template <class Kind>
  const Kind* active() const {
    const int index = activeIndex<Kind>(state());
    return index < 0 ? nullptr : &std::get<Kind>(edits()[std::size_t(index)].content);
  }
  void select(int edit);

  const History& history() const { return m_history; }
  History& history() { return m_history; }
  /// Whether there are unsaved changes: of the material, the edits or the incident direction. An edit that only chooses
  /// a model is not a change.
  bool isModified() const;
  QString path() const { return m_content.path; }
  /// Name for titles: of the file, else of the material, else "Untitled".
  QString name() const;
  /// The folder of the document's file; of the measured file if it was never saved. Empty if there is neither, or if
  /// the folder belongs to Gonio's own data (acquired materials, materials saved in the library).
  QString folder() const;
  /// The edits that a proposed file name describes. Empty if the document has a file, because then the name of that
  /// file is proposed.
  editing::EditList describedEdits() const;

  /// Starts a new document with a material, without edits or with the edits of a .gonio file.
  void setMaterial(LoadedMaterialPtr material);
  void setMaterial(LoadedMaterialPtr material, const documents::EditDocument& stored, const QString& path);
  /// Marks the document as unsaved (after recovery).
  void markUnsaved();

  /// Replaces the material by another one, without edits or a file. One undo step; undoing it restores the material
  /// with its edits and its file.
  void replaceMaterial(LoadedMaterialPtr material, const QString& text);

  /// Replaces the edits in one undo step named `text`; no step if nothing changes. All steps between beginInteraction()
  /// and endInteraction() merge into one.
  /// @param selected the selected edit; by default unchanged.
  void replaceEdits(editing::EditList edits, const QString& text, std::optional<int> selected = {});
  /// Sets which direction is used as the incident one (EditState::incident), in one undo step.
  void setIncident(IncidentDirection incident);
  void beginInteraction();
  void endInteraction() { m_interacting = false; }
  bool isInteracting() const { return m_interacting; }
  /// The state before the current step: that at beginInteraction() during an interaction, else the current one.
  const EditState& stepBase() const { return m_interacting ? m_atBegin : state(); }

  /// Adds a fit of the material to the known ones.
  void rememberFit(fitting::FitResult fit);
  /// The newest known fit of a model, or null.
  const fitting::FitResult* knownFit(const models::Model& model) const;
  /// The fit from which an edit starts; null if its values come from a .gonio file.
  const fitting::FitResult* fitOf(const editing::DifferentialEdit& edit) const;
  /// Adds an edit for the automatic fit after opening, which has no effect yet. No undo step; the edit is also added to
  /// earlier steps, so that it remains when they are undone.
  void adoptFit(const fitting::FitResult& fit);
  /// Restarts the active differential edit from a fit, or adds a new one if there is none. One undo step, never part of
  /// an interaction.
  void chooseFit(fitting::FitResult fit);
  /// As replaceEdits(), but never part of an interaction; for edits computed in the background.
  void installEdits(editing::EditList edits, const QString& text, std::optional<int> selected = {});

  /// The content of a .gonio file.
  documents::EditDocument toEditDocument() const;
  void markSaved(const QString& path);

  /// For commands only.
  const Content& content() const { return m_content; }
  void setContent(Content content);
  void setState(const EditState& state);

 Q_SIGNALS:
  void materialChanged();
  /// The material was replaced by an undo step, so the history continues. Emitted after materialChanged().
  void materialReplaced();
  /// The sequence of models in the edits, or the fit from which one of them starts, changed.
  void stateChanged();
  /// Another part of the state changed: values, other edits or the incident direction.
  void editChanged();
  /// Another edit was selected.
  void selectionChanged();
  /// Name, path or modified state changed.
  void titleChanged();
  /// A change was not made, because the edits would exceed a limit (editing::checkLimits()).
  void refused(const QString& text);

 private:
  void startAnew(Content content);
  void addStep(EditState after, const QString& text);

  Content m_content;
  History m_history;
  EditState m_atBegin;
  /// The state of the file on disk, or of the material when it was opened; nullopt: there is no such file.
  struct Saved {
    LoadedMaterialPtr material;
    EditState state;
  };
  std::optional<Saved> m_saved;
  mutable std::shared_ptr<const Brdf> m_base, m_baseSource;  ///< cached base and the base from which it was made
  int m_interaction = 0;
  bool m_interacting = false;
};

/// The initial edit of a fit, without effect.
editing::DifferentialEdit identityEdit(const fitting::FitResult& fit);

}  // namespace gonio::app
