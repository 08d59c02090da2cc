// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "app/gonio/acquisition/acquisition_sample_model.h"

class QPushButton;
class QTableView;

namespace gonio::app {

class AcquisitionFiles;

/// The samples of an acquisition as a table, with import and export as files and text.
class SamplesPage : public QWidget {
  Q_OBJECT

 public:
  SamplesPage(const AcquisitionSession& session, const AcquisitionControls& controls, AcquisitionFiles& files);

  QTableView& table() const { return *m_table; }
  /// Selects the row of a sample; -1: none.
  void setCurrent(int sample);
  void refresh();

 Q_SIGNALS:
  void currentChanged(int sample);

 private:
  QPushButton* button(const QString& text, const QString& toolTip, std::function<void()> clicked);
  void buildTable();
  void showDirections();

  const AcquisitionSession& m_session;
  const AcquisitionControls& m_controls;
  AcquisitionSampleModel m_model;
  QTableView* m_table;
  QPushButton* m_openPlan;
  std::vector<QPushButton*> m_needPlan;  ///< enabled once there is a plan
};

}  // namespace gonio::app
