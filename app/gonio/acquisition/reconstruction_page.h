// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/acquisition_controls.h"

class QLabel;
class QPushButton;

namespace gonio::widgets {
class ReconstructionView;
}

namespace gonio::app {

/// The reconstructed material beside the measured one, with its error.
class ReconstructionPage : public QWidget {
  Q_OBJECT

 public:
  ReconstructionPage(const AcquisitionSession& session, const AcquisitionControls& controls);

  widgets::ReconstructionView& view() const { return *m_view; }
  QPushButton& openButton() const { return *m_open; }
  /// The numbers of the result as text.
  QString numbers() const;
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
