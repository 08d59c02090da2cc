// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "app/gonio/study/study_model.h"
#include "core/study/machine.h"
#include "core/study/study_plot.h"

namespace gonio::app {

/// Measures the representations of the open material in the background, one row of the model after the other, and
/// writes down what is measured.
class StudyRun : public QObject {
  Q_OBJECT

 public:
  StudyRun(const Document& document, BackgroundTasks& tasks, StudyModel& model, QObject* parent);

  /// What is measured from now on; all representations by default. Forgets what was measured.
  void setChoice(const study::RepresentationChoice& choice, const study::StudyOptions& options);
  bool isRunning() const;
  /// Measures what is missing; where nothing is, all anew.
  void measure();
  void cancel();

  std::string title() const;
  /// What was measured on, one fact a line; nothing before the first measurement.
  std::vector<std::string> machine() const;
  QString csv() const;
  /// The plot with `axes`, dark on white. @throws Error naming the file.
  void writeSvg(const QString& path, const study::StudyAxes& axes) const;

 Q_SIGNALS:
  /// All rows are empty again.
  void restarted();
  void rowMeasured();
  /// isRunning() is another.
  void runningChanged();
  void failed(const QString& title, const QString& text);

 private:
  void restart();
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
