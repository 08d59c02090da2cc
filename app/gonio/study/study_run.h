// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QStringList>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "app/gonio/study/study_model.h"

namespace gonio::app {

/// Measures representations of the open material, or of several materials of the library one after the other, in the
/// background: one row of its model after the other. Fits of the open material are stored with the document. If the
/// user stops, the results stay, and the next run continues from there.
class StudyRun : public QObject {
  Q_OBJECT

 public:
  enum class Subject { openMaterial, library };
  StudyRun(Subject subject, Document& document, BackgroundTasks& tasks, QObject* parent);
  ~StudyRun() override;

  StudyModel& model() { return m_model; }
  const StudyModel& model() const { return m_model; }
  Subject subject() const { return m_subject; }
  /// Sets the materials of the library; the results of those that remain stay.
  void setMaterials(const QStringList& ids);
  /// Sets what to measure. The results of representations that remain stay.
  void setChoice(const study::RepresentationChoice& choice);
  const QStringList& ids() const { return m_ids; }
  const study::RepresentationChoice& choice() const { return m_choice; }
  /// Sets how to measure; the times are chosen by measure().
  void setOptions(const study::StudyOptions& options) { m_options = options; }

  bool canMeasure() const;
  bool isRunning() const;
  bool isComplete(bool timed) const;
  /// Which rows to measure.
  struct Request {
    bool timed = true;        ///< whether to measure the times of evaluations and frames
    std::string family = {};  ///< only the rows of a family; empty: all
  };
  /// Measures the missing rows, or all again if none is missing. Results stay until new ones replace them.
  void measure(const Request& request);
  void cancel();

  /// Of which the model has results; null without results, and for the library.
  const LoadedMaterialPtr& material() const { return m_material; }
  /// The name of that material, or the number of materials; empty if there are none.
  QString title() const;
  /// What was measured, and the materials that could not be read.
  QString status() const;
  /// Description of the machine, one fact per line; empty before the first measurement.
  std::vector<std::string> machine() const;
  /// @param rows of the model, in order.
  QString csv(const std::vector<int>& rows) const;
  /// Writes the plot with the given axes, dark on white. @throws Error that names the file.
  void writeSvg(const QString& path, const study::StudyAxes& axes, const std::vector<int>& rows) const;

 Q_SIGNALS:
  /// The rows changed, or results were dropped or became outdated.
  void restarted();
  void rowMeasured();
  /// isRunning() changed.
  void runningChanged();
  void failed(const QString& title, const QString& text);

 private:
  void documentChanged();
  std::vector<study::Representation> wanted(std::size_t material) const;
  /// The first readable material with rows to measure.
  std::optional<std::size_t> nextMaterial() const;
  void measureNext();
  void start(std::size_t material);
  void add(std::size_t material, const LoadedMaterialPtr& loaded, const StudyModel::Studied& studied);
  std::string pictures() const;

  const Subject m_subject;
  Document& m_document;
  BackgroundTasks& m_tasks;
  StudyModel m_model;
  QString m_key;  ///< key of its tasks
  QStringList m_ids;
  LoadedMaterialPtr m_material;
  QString m_name;  ///< of m_material
  study::RepresentationChoice m_choice;
  study::StudyOptions m_options;
  Request m_request;
  std::optional<study::MachineFacts> m_machine;
  std::vector<QString> m_failures{QString()};  ///< error per material; empty: none
  bool m_wasRunning = false;
};

}  // namespace gonio::app
