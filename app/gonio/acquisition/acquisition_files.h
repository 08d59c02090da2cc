// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/acquisition/acquisition_subject.h"

class QFileDialog;

namespace gonio::app {

/// The plan and the values of a session as files and as text of the clipboard.
class AcquisitionFiles : public QObject {
  Q_OBJECT

 public:
  /// @param panel the parent of the dialogs.
  AcquisitionFiles(AcquisitionSession& session, AcquisitionControls& controls, AcquisitionSubject& subject,
                   QWidget* panel);

  /// The plan as comma-separated text, with what it was made for in comments.
  QString planText() const;
  void savePlan(const QString& path);
  /// A plan that was saved before, here or by goniotool: learns the training set and takes its directions.
  void readPlan(const QString& path);
  /// Values as comma-separated text, one row a sample. Reports what is wrong with them.
  void paste(const QString& text);
  void readValues(const QString& path);

  void askForPlan();
  void askForPlanFile();
  void askForValues();

 Q_SIGNALS:
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 private:
  std::vector<std::string> planComments() const;
  QFileDialog* openDialog(const QString& title, const QString& filter);

  AcquisitionSession& m_session;
  AcquisitionControls& m_controls;
  AcquisitionSubject& m_subject;
  QWidget* m_panel;
};

}  // namespace gonio::app
