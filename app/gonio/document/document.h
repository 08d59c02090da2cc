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

namespace gonio::app {

/// What undo steps change.
struct EditState {
  editing::EditList edits;
  int selected = -1;  ///< the edit that the panels change; -1: none
  /// Which direction takes the place of the incident one where the measurement is not reciprocal (RGL and UTIA files).
  IncidentSlot incident = IncidentSlot::viewer;
};

/// The edit that the panel of a kind of content shows and changes: the selected one where it is of that kind, else the
/// last of the kind; -1 where there is none.
template <class Content>
int activeIndex(const EditState& state) {
  const auto holds = [&](int i) { return std::holds_alternative<Content>(state.edits[std::size_t(i)].content); };
  if (state.selected >= 0 && holds(state.selected)) return state.selected;
  int index = int(state.edits.size()) - 1;
  while (index >= 0 && !holds(index)) --index;
  return index;
}

/// An open material and its edits. The material is immutable; every change of the edits by the user is an undo step.
/// Opening, the automatic first fit, saving, selecting an edit, camera and light are not.
class Document : public QObject {
  Q_OBJECT

 public:
  /// A material with what stands beside it.
  struct Content {
    LoadedMaterialPtr material;
    EditState state;
    QString path;                          ///< of the .gonio file; empty while it was never saved
    std::vector<fitting::FitResult> fits;  ///< of the material, as far as they are known; the newest last
  };

  explicit Document(QObject* parent = nullptr);

  const LoadedMaterialPtr& material() const { return m_content.material; }
  /// What is shown and edited: the material's base with the directions in the order that the state asks for. Null
  /// without a material.
  std::shared_ptr<const Brdf> base() const;
  const EditState& state() const { return m_content.state; }
  /// In the order in which they are applied.
  const editing::EditList& edits() const { return m_content.state.edits; }
  /// What activeIndex() finds; null where there is none.
  template <class Kind>
  const Kind* active() const {
    const int index = activeIndex<Kind>(state());
    return index < 0 ? nullptr : &std::get<Kind>(edits()[std::size_t(index)].content);
  }
  void select(int edit);

  const History& history() const { return m_history; }
  History& history() { return m_history; }
  /// Whether saving would keep something that opening the material again would not: another value, edit, order of
  /// directions. A model that is only chosen is nothing of the kind.
  bool isModified() const;
  QString path() const { return m_content.path; }
  /// For titles: the file's name, else the material's, else "Untitled".
  QString name() const;

  /// Starts anew with a material, without edits; or with the edits of a .gonio file.
  void setMaterial(LoadedMaterialPtr material);
  void setMaterial(LoadedMaterialPtr material, const editing::EditDocument& stored, const QString& path);
  /// Counts as unsaved from now on (a recovered document).
  void markUnsaved();

  /// Another material takes the place of this one, without edits and never saved: one undo step, which brings back the
  /// material with its edits and its file.
  void replaceMaterial(LoadedMaterialPtr material, const QString& text);

  /// Other edits: one undo step, named `text`; none where nothing changes. All steps between beginInteraction() and
  /// endInteraction() are one.
  /// @param selected which of them is selected then; kept where it is left out.
  void replaceEdits(editing::EditList edits, const QString& text, std::optional<int> selected = {});
  /// One undo step.
  void setIncident(IncidentSlot slot);
  void beginInteraction();
  void endInteraction() { m_interacting = false; }
  bool isInteracting() const { return m_interacting; }
  /// What the present step starts from: the state at beginInteraction() while one is under way, else the present one.
  const EditState& stepBase() const { return m_interacting ? m_atBegin : state(); }

  /// A fit of the material that is known from now on.
  void rememberFit(fitting::FitResult fit);
  /// The newest fit of a model; null where none is known.
  const fitting::FitResult* knownFit(const models::Model& model) const;
  /// The fit that an edit starts from; null where its values come from a .gonio file.
  const fitting::FitResult* fitOf(const editing::DifferentialEdit& edit) const;
  /// The automatic fit after opening: an edit that changes nothing yet, and no undo step. The steps before it get the
  /// edit too, so that undoing them keeps it.
  void adoptFit(const fitting::FitResult& fit);
  /// The active differential edit starts anew at a fit, or a new one does where there is none. One undo step, never
  /// part of an interaction.
  void chooseFit(fitting::FitResult fit);
  /// As replaceEdits(), but never part of an interaction: what was computed in the background.
  void installEdits(editing::EditList edits, const QString& text, std::optional<int> selected = {});

  /// What is written to a .gonio file.
  editing::EditDocument toEditDocument() const;
  void markSaved(const QString& path);

  /// For commands only.
  const Content& content() const { return m_content; }
  void setContent(Content content);
  void setState(const EditState& state);

 Q_SIGNALS:
  void materialChanged();
  /// By an undo step: the history goes on. After materialChanged().
  void materialReplaced();
  /// The models of the edits or the fits that they start from changed.
  void stateChanged();
  /// Anything else of the edits changed.
  void editChanged();
  /// Another edit is selected.
  void selectionChanged();
  /// Name, path or modified state changed.
  void titleChanged();

 private:
  void startAnew(Content content);
  void addStep(EditState after, const QString& text);

  Content m_content;
  History m_history;
  EditState m_atBegin;
  /// What the file on the disk holds, or the material as it was opened; nothing: no such file is there.
  struct Saved {
    LoadedMaterialPtr material;
    EditState state;
  };
  std::optional<Saved> m_saved;
  mutable std::shared_ptr<const Brdf> m_base, m_baseSource;  ///< of the state before, kept while it serves
  int m_interaction = 0;
  bool m_interacting = false;
};

/// The edit that a fit starts with: it changes nothing yet.
editing::DifferentialEdit identityEdit(const fitting::FitResult& fit);

}  // namespace gonio::app
