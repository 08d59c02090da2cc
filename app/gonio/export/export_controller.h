// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QObject>
#include <optional>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "core/export/export_target.h"

namespace gonio::app {

/// What an export is made of: the document's material as it was when it was asked for. Cheap to copy.
struct ExportSubject {
  LoadedMaterialPtr material;
  std::shared_ptr<const Brdf> base;
  editing::EditList edits;
  QString name;                              ///< of the document
  std::vector<std::filesystem::path> files;  ///< that it is about: exports never replace them

  explicit ExportSubject(const Document& document);
  std::shared_ptr<const Brdf> edited() const;
  /// Not for the GUI thread: it reads an RGL file again. @throws Error.
  exports::ExportSource source() const;
  /// "chrome_edited"
  QString proposedName() const;
};

/// An export in memory, with its pictures.
struct ExportTrial {
  exports::MadeExport made;
  QImage original, exported;
};
using ExportTrialPtr = std::shared_ptr<const ExportTrial>;

/// What the user asks for: a target and the name of its files.
struct ExportRequest {
  const exports::ExportTarget* target = nullptr;
  exports::ExportOptions options;
  QString name;                                  ///< a path without the target's suffixes
  std::shared_ptr<const Scene> scene = nullptr;  ///< written beside the material; null: none
  QString place = {};                            ///< among several: "3 of 12"; empty: there is one
};

/// Makes exports in the background and writes them. Each is a task of its own, so that several wait in a row.
class ExportController : public QObject {
  Q_OBJECT

 public:
  ExportController(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr);

  const Document& document() const { return m_document; }
  BackgroundTasks& tasks() { return m_tasks; }

  /// Makes an export without writing it; a newer trial takes the place of an older one.
  void tryOut(const ExportSubject& subject, const exports::ExportTarget& target, const exports::ExportOptions& options,
              std::function<void(ExportTrialPtr)> done, const std::function<void(const QString&)>& failed);
  void dropTrial();
  /// Progress of the trial, [0, 1]; nothing while none runs.
  std::optional<double> trialProgress() const;

  /// Writes an export, which replaces files of its names but never the source.
  /// @param trial of this request; null: it is made first.
  void write(const ExportSubject& subject, const ExportRequest& request, const ExportTrialPtr& trial);
  /// Writes a material of the library as it was measured, edits aside; the file it comes from is never replaced.
  /// @param id what openMaterial() takes: a path or a bundled material. @param replace files of these names
  void writeMeasured(const QString& id, const ExportRequest& request, bool replace);
  /// The last export of this document once more, as the document is now. Contract: canRepeat().
  void repeat();
  bool canRepeat() const { return m_last.has_value(); }
  const std::optional<ExportRequest>& last() const { return m_last; }

 Q_SIGNALS:
  void exported(const QString& files);
  void failed(const QString& title, const QString& text);
  void warned(const QString& text);
  /// The user stopped it: nothing was written.
  void cancelled(const QString& files);
  /// canRepeat() may have changed.
  void lastChanged();

 private:
  /// Returns the warnings.
  using Writer = std::function<std::vector<std::string>(const TaskControl&)>;
  void writeInBackground(const ExportRequest& request, Writer writer);

  Document& m_document;
  BackgroundTasks& m_tasks;
  std::optional<ExportRequest> m_last;
};

/// "chrome_rgb.bsdf and chrome_spec.bsdf"
QString fileNames(const exports::ExportTarget& target, const QString& name, const Scene* withScene = nullptr);

}  // namespace gonio::app
