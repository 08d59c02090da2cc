// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "app/gonio/study/study_model.h"
#include "core/study/study_plot.h"
#include "core/study/study_record.h"

namespace gonio::app {

/// Measures the representations of the open material in the background, one row of the model after the other, and
/// records the results.
class StudyRun : public QObject {
  Q_OBJECT

 public:
  StudyRun(const Document& document, BackgroundTasks& tasks, StudyModel& model, QObject* parent);

  /// Sets what to measure; by default study::RepresentationChoice(). Drops the results.
  void setChoice(const study::RepresentationChoice& choice, const study::StudyOptions& options);
  /// Sets the families of representations to measure. Results of families that remain are not dropped.
  void setFamilies(const std::vector<std::string>& families);
  const std::vector<std::string>& families() const { return m_choice.names; }
  bool isRunning() const;
  /// Measures the missing rows, or all again if none is missing.
  void measure();
  void cancel();

  std::string title() const;
  /// Description of the machine, one fact per line; empty before the first measurement.
  std::vector<std::string> machine() const;
  QString csv() const;
  /// Writes the plot with `axes`, dark on white. @throws Error that names the file.
  void writeSvg(const QString& path, const study::StudyAxes& axes) const;

 Q_SIGNALS:
  /// The rows changed, or all results were dropped.
  void restarted();
  void rowMeasured();
  /// isRunning() changed.
  void runningChanged();
  void failed(const QString& title, const QString& text);

 private:
  void restart();
  std::vector<study::Representation> planned() const;
  void start(const LoadedMaterialPtr& material);
  std::string pictures() const;

  const Document& m_document;
  BackgroundTasks& m_tasks;
  StudyModel& m_model;
  study::RepresentationChoice m_choice;
  study::StudyOptions m_options;
  std::optional<study::MachineFacts> m_machine;
  bool m_wasRunning = false;
};

}  // namespace gonio::app
