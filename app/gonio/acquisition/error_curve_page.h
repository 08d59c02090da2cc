// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/acquisition_session.h"

class QComboBox;

namespace gonio::widgets {
class ErrorCurve;
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

}  // namespace gonio::app
