// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"

namespace gonio::app {

/// What becomes of a document whose measured file has changed since it was saved.
enum class ChangedSource { withEdits, withoutEdits, cancel };

/// What the user does with a document that takes time or touches files: opening, fitting, saving. All of it runs in the
/// background but saving, which is a small file.
class DocumentController : public QObject {
  Q_OBJECT

 public:
  DocumentController(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr);

  /// A measured file, a bundled material ("library:...") or a .gonio document. Replaces what is open when it is read;
  /// a newer call wins. A material without an edit is then fitted with the default model.
  void open(const QString& path);
  /// An autosaved document; `originalPath` is where it belongs (empty: it was never saved).
  void openRecovered(const QString& autosavePath, const QString& originalPath);
  QString opening() const { return m_opening; }
  /// The answer to sourceChanged(). The document then counts as unsaved.
  void openChangedSource(ChangedSource choice);

  /// Uses the fit that is known of this material, or makes it. One undo step.
  void chooseModel(const models::Model& model);
  /// A second edit with the fit that is in use; where there is none, one with the default model.
  void addModelEdit();
  /// Fits the current model again, with the conventions that are chosen in the edit.
  void fit();
  void applyProposal();
  void discardProposal() { m_proposal.reset(); }
  bool isFitting() const;

  /// Writes the .gonio file. Returns false after failed().
  bool save(const QString& path, const nlohmann::json& view);
  /// Pastes edits, carried over to the open material, in the place of those of their kinds, in one undo step. The
  /// factors that edits of curves need are found first, and the fits that edits of models need where none is in use.
  void paste(const editing::EditList& edits);

 Q_SIGNALS:
  /// A document was read whose source is another file than when it was saved: it waits for openChangedSource().
  void sourceChanged(const QString& text);
  /// What was read is about to take the place of what is open.
  void installing();
  /// `path` is empty for recovered work that was never saved.
  void opened(const QString& path);
  /// The work of an autosaved copy is in the document now.
  void recovered(const QString& autosavePath);
  /// The view that a .gonio file holds.
  void viewRestored(const nlohmann::json& view);
  void saved(const QString& path);
  void failed(const QString& title, const QString& text);
  void warned(const QString& text);
  /// A cancelled fit has a best so far.
  void proposalOffered(const QString& text);

 private:
  struct Opened {
    LoadedMaterialPtr material;
    std::optional<editing::EditDocument> stored;
    QString path, documentPath;
    bool recovered = false;
  };
  void start(const QString& path, const QString& documentPath, bool recovered);
  void install(const Opened& opened);
  void offerChangedSource(Opened opened);
  /// @param choices the conventions to keep, as fitting::fit() takes them.
  void runFit(const models::Model& model, std::function<void(const fitting::FitResult&)> done,
              const models::ParameterValues& choices = {});
  void dropTasks();
  void automaticFit();
  bool hasModelEdit() const { return m_document.active<editing::DifferentialEdit>() != nullptr; }
  struct Pasted {
    editing::EditList edits;               ///< those of factors carried over, others as they were copied
    std::vector<fitting::FitResult> fits;  ///< of models that no fit was known of
  };
  void install(const Pasted& pasted);
  /// What an edit of a model that is pasted starts from; null where no fit of it is known.
  const models::ParameterValues* fittedValues(const models::Model& model) const;

  Document& m_document;
  BackgroundTasks& m_tasks;
  QString m_opening;
  std::shared_ptr<const Opened> m_changedSource;  ///< waits for an answer
  std::optional<fitting::FitResult> m_proposal;
};

/// The model that a newly opened material is fitted with.
const models::Model& defaultModel();

}  // namespace gonio::app
