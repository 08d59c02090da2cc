// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <QTimer>
#include <map>
#include <optional>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "core/export/export_target.h"
#include "core/study/accuracy_study.h"

class QDoubleSpinBox;
class QLabel;

namespace gonio::app {

/// Settings remembered by the export dialogs.
namespace export_settings {
inline const QString target = QStringLiteral("export/target"), snr = QStringLiteral("export/snr"),
                     folder = QStringLiteral("export/folder"), scene = QStringLiteral("export/scene");
}

/// A field for the rendered SNR that files should reach, dB.
QDoubleSpinBox* exportSnrField();
/// A label with text that wraps and can be copied.
QLabel* exportText();

/// An export in memory, with its picture.
struct ExportTrial {
  exports::ExportResult made;
  QImage exported;                     ///< coarse until `isRefined`; null if the target is not rendered
  bool isRefined = false;              ///< whether the following members are known
  double flip = 0;                     ///< of the pictures of material and export
  std::optional<study::UseCost> cost;  ///< of ExportResult::brdf
};
using ExportTrialPtr = std::shared_ptr<const ExportTrial>;

/// The user's request: a target and the name of its files.
struct ExportRequest {
  const exports::ExportTarget* target = nullptr;
  exports::ExportOptions options;
  QString name;                                             ///< path without the target's suffixes
  std::shared_ptr<const rendering::Scene> scene = nullptr;  ///< scene to write in addition to the material; null: none
  QString place = {};  ///< position among several, e.g. "3 of 12"; empty: there is one
};

/// Makes and writes exports in the background. Each is a separate task; several wait in a queue.
class ExportController : public QObject {
  Q_OBJECT

 public:
  ExportController(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr);

  const Document& document() const { return m_document; }
  BackgroundTasks& tasks() { return m_tasks; }

  /// Makes an export of a material (Document::edited()) without writing it, coarse pictures first; a newer trial
  /// replaces an older one that still runs. What is known is kept until a trial of another material or other edits.
  /// @param changed called whenever picture() or known() has changed.
  void tryOut(const materials::EditedMaterial& material, const exports::ExportTarget& target,
              const exports::ExportOptions& options, const std::function<void()>& changed,
              const std::function<void(const QString&)>& failed);
  /// The picture of a material; null if it is not known.
  QImage picture(const materials::EditedMaterial& material) const;
  /// A coarse picture of what an export is expected to look like, until there is a trial: of the material for renderers
  /// that read its values, of its fit for engines; null if neither tells.
  QImage expected(const materials::EditedMaterial& material, const exports::ExportTarget& target) const;
  /// The trial of a material; null if it is not known. Every target has its own, also where two write the same files:
  /// Mitsuba reads the colours of an RGL file, pbrt the spectra.
  ExportTrialPtr known(const materials::EditedMaterial& material, const exports::ExportTarget& target,
                       double snr) const;
  void dropTrial();
  /// Progress of the trial, [0, 1]; nullopt if none is running.
  std::optional<double> trialProgress() const;

  /// Writes an export. Replaces existing files of the same names, but never the source.
  /// @param trial trial of this request; null: the export is made first.
  void write(const materials::EditedMaterial& material, const ExportRequest& request, const ExportTrialPtr& trial);
  /// Writes a material of the library without edits. Never replaces its own file.
  /// @param id a material file or a bundled material; a .gonio document is refused. @param replace whether existing
  /// files are replaced.
  void writeMeasured(const QString& id, const ExportRequest& request, bool replace);
  /// Repeats the last export of this document with its current state. Precondition: canRepeat().
  void repeat();
  bool canRepeat() const { return m_last.has_value(); }
  /// Whether the last export of this document is repeated when its edits have rested for a second.
  void setKeptUpToDate(bool kept);
  bool isKeptUpToDate() const { return m_isKept; }
  const std::optional<ExportRequest>& last() const { return m_last; }

 Q_SIGNALS:
  void exported(const QString& files);
  void failed(const QString& title, const QString& text);
  void warned(const QString& text);
  /// The user cancelled; nothing was written.
  void cancelled(const QString& files);
  /// canRepeat() may have changed.
  void lastChanged();

 private:
  /// Returns the warnings.
  using Writer = std::function<std::vector<std::string>(const TaskControl&)>;
  void writeInBackground(const ExportRequest& request, Writer writer);
  using Key = std::pair<std::string_view, double>;  ///< id of the target; SNR, 0 where the target does not use it
  static Key keyOf(const exports::ExportTarget& target, double snr) { return {target.id, target.usesSnr ? snr : 0}; }
  bool isKnown(const materials::EditedMaterial& material) const;
  void drawCoarse(const std::function<void()>& changed);
  std::shared_ptr<const Brdf> editedFit() const;
  void refine(const Key& key, const QString& title, const std::function<void()>& changed,
              const std::function<void(const QString&)>& failed);

  /// What is known of one material with its edits.
  struct Known {
    materials::EditedMaterial material;
    QImage picture, fit;     ///< of the material, and of its edited fit
    bool isRefined = false;  ///< the picture
    std::map<Key, ExportTrialPtr> trials;
  };

  Document& m_document;
  BackgroundTasks& m_tasks;
  Known m_known;
  std::optional<ExportRequest> m_last;
  bool m_isKept = false;
  QTimer m_rest;  ///< until the edits have rested
};

/// "chrome_rgb.bsdf and chrome_spec.bsdf"
QString fileNames(const exports::ExportTarget& target, const QString& name,
                  const rendering::Scene* withScene = nullptr);

}  // namespace gonio::app
