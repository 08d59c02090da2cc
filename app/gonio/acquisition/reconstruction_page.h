// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "app/gonio/acquisition/acquisition_session.h"

class QComboBox;
class QLabel;
class QPushButton;
namespace gonio::widgets {
class ErrorCurve;
}
namespace gonio::widgets {
class ReconstructionView;
}

namespace gonio::app {

/// The error of an acquisition over the number of its samples.
class ErrorCurvePage : public QWidget {
  Q_OBJECT

 public:
  explicit ErrorCurvePage(const AcquisitionSession& session);

  widgets::ErrorCurve& curve() const { return *m_curve; }
  void refresh();

 private:
  void showCurve();

  const AcquisitionSession& m_session;
  QComboBox* m_quality;
  widgets::ErrorCurve* m_curve;
};

/// Whether the start button would stop the work in progress. If the settings changed meanwhile, it restarts the work
/// instead.
bool startCancels(const AcquisitionSession& session, const AcquisitionControls& controls);

/// Description of the running step, or of the possible next step.
QString acquisitionStatus(const AcquisitionSession& session, const AcquisitionControls& controls);

/// The reconstructed material beside the measured one, with its error.
class ReconstructionPage : public QWidget {
  Q_OBJECT

 public:
  ReconstructionPage(const AcquisitionSession& session, const AcquisitionControls& controls);

  void refresh();

 Q_SIGNALS:
  /// The user wants the result to become the document's material.
  void openRequested();

 private:
  void showResult();

  const AcquisitionSession& m_session;
  const AcquisitionControls& m_controls;
  widgets::ReconstructionView* m_view;
  QLabel* m_numbers;
  QPushButton* m_open;
};

}  // namespace gonio::app
