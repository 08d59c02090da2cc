// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QByteArray>
#include <QHash>
#include <QObject>
#include <QString>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"

namespace gonio::app {

/// The documents that this editor has read or written, each with a digest of its content at that time. Before a file is
/// replaced, its digest shows whether another program has written to it since.
class FileVersions {
 public:
  /// SHA-256 of the file's content; empty if there is no such file or it cannot be read.
  static QByteArray digest(const QString& path);

  void remember(const QString& path, const QByteArray& digest);
  /// Whether the file was remembered and now has other content. False for a file that no longer exists, since saving
  /// then loses nothing. Reads the file.
  bool hasChanged(const QString& path) const;

 private:
  QHash<QString, QByteArray> m_digests;  ///< by absolute path
};

/// What to open if the source of a document has changed since the document was saved: the document with its edits, its
/// source without them, or nothing.
enum class ChangedSource { withEdits, withoutEdits, cancel };

/// Actions on a document that take time or access files: opening, fitting, saving. They run in the background, except
/// saving, which writes a small file.
class DocumentController : public QObject {
  Q_OBJECT

 public:
  DocumentController(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr);

  /// Opens a material file, a bundled material ("library:...") or a .gonio document. It replaces the open document once
  /// it is read, unless a newer call replaced the request. The caller has asked about the unsaved changes that exist
  /// now; if there are others by then, unsavedChanges() is emitted instead. If no edit changes a model, the default
  /// model is then fitted.
  void open(const QString& path);
  /// Opens an autosaved copy. @param originalPath path of the document itself; empty: it was never saved.
  void openRecovered(const QString& autosavePath, const QString& originalPath);
  /// Path of the file that is being opened; empty if there is none.
  QString opening() const { return m_opening; }
  /// Opens a material in memory, such as a blend, in one undo step (Document::replaceMaterial()). Unsaved changes of
  /// the open document are asked about first, because they would not be saved with the new one: unsavedChanges().
  void openInMemory(const LoadedMaterialPtr& material, const QString& text);
  /// Answers unsavedChanges(): replaces the open document, or keeps it.
  void replaceUnsaved(bool replace);
  /// Answers sourceChanged(). `withEdits` opens the document and marks it as unsaved; `withoutEdits` opens its source
  /// like a material file; `cancel` changes nothing.
  void openChangedSource(ChangedSource choice);

  /// Uses the known fit of this model, or fits it first. One undo step.
  void chooseModel(const models::Model& model);
  /// Adds another edit with the fit in use, or with the default model if there is none.
  void addModelEdit();
  /// Fits the current model again, with the choices of the edit (parameters that select a formula).
  void fit();
  void applyProposal();
  void discardProposal() { m_proposal.reset(); }
  bool isFitting() const;

  /// Whether another program has written to this .gonio file since it was opened or saved here.
  bool hasChangedOnDisk(const QString& path) const { return m_versions.hasChanged(path); }
  /// Writes the .gonio file. Returns false after failed().
  bool save(const QString& path, const nlohmann::json& view);
  /// Pastes edits, transferred to the open material, in place of the edits of the same kinds, in one undo step. Factors
  /// for edits of curves, and fits for edits of models that have none, are computed first.
  void paste(const editing::EditList& edits);

 Q_SIGNALS:
  /// The source file of a document changed after the document was saved; waits for openChangedSource().
  void sourceChanged(const QString& text);
  /// `name` would replace a document with unsaved changes; waits for replaceUnsaved().
  void unsavedChanges(const QString& name);
  /// The document that was read is about to replace the open one.
  void installing();
  /// `path` is empty for recovered work that was never saved.
  void opened(const QString& path);
  /// The document now contains the work of an autosaved copy.
  void recovered(const QString& autosavePath);
  /// The view stored in a .gonio file.
  void viewRestored(const nlohmann::json& view);
  void saved(const QString& path);
  void failed(const QString& title, const QString& text);
  void warned(const QString& text);
  /// A cancelled fit has an intermediate result, or a fit of several lobes is much closer than the automatic one.
  void proposalOffered(const QString& text);

 private:
  struct Opened {
    LoadedMaterialPtr material;
    std::optional<documents::EditDocument> stored;
    QString path, documentPath;
    QByteArray digest;  ///< of the document's file, before it was read; empty without one
    bool recovered = false, unsaved = false;
  };
  /// What the caller of open() knew of the open document.
  struct KnownState {
    LoadedMaterialPtr material;
    editing::EditList edits;
    IncidentDirection incident = IncidentDirection::viewer;
    bool operator==(const KnownState&) const = default;
  };
  KnownState currentState() const;
  /// Runs `install` now, or after the answer to unsavedChanges() if changes would be lost that were not in `known`.
  void replace(const QString& name, const std::optional<KnownState>& known, std::function<void()> install);
  void start(const QString& path, const QString& documentPath, bool recovered);
  void install(const Opened& opened);
  void offerChangedSource(Opened opened);
  /// @param choices the choices to use, as for fitting::fit().
  void useFit(const fitting::FitResult& fit);
  void warnAbout(const fitting::FitResult& fit);
  void runFit(const models::Model& model, std::function<void(const fitting::FitResult&)> done,
              const models::ParameterValues& choices = {});
  void dropTasks();
  void automaticFit();
  /// Fits several lobes in the background too, and proposes them if their error is much lower.
  void compareWithSeveralLobes(const fitting::FitResult& single);
  bool hasModelEdit() const { return m_document.active<editing::DifferentialEdit>() != nullptr; }
  struct Pasted {
    editing::EditList edits;               ///< edits of factors transferred, others as copied
    std::vector<fitting::FitResult> fits;  ///< of models without a known fit
  };
  void install(const Pasted& pasted);
  /// The fitted values from which a pasted edit of a model starts; null if no fit is known.
  const models::ParameterValues* fittedValues(const models::Model& model) const;

  Document& m_document;
  BackgroundTasks& m_tasks;
  FileVersions m_versions;
  QString m_opening;
  std::optional<KnownState> m_known;              ///< at the last open()
  std::shared_ptr<const Opened> m_changedSource;  ///< waits for openChangedSource()
  std::function<void()> m_replacement;            ///< waits for replaceUnsaved()
  std::optional<fitting::FitResult> m_proposal;
};

/// The model of the automatic fit.
const models::Model& defaultModel();

}  // namespace gonio::app
