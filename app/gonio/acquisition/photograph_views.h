// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/photograph_session.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace gonio::widgets {
class ResidualView;
class UncertaintyCurve;
}  // namespace gonio::widgets

namespace gonio::app {

class ReferenceView;
class SphereView;

/// The current photograph with the outline of the sphere, its residual beside it, all photographs in a strip below, and
/// the reconstructed material: spheres in the same and in another light, and its uncertainty.
class PhotographViews : public QWidget {
  Q_OBJECT

 public:
  explicit PhotographViews(PhotographSession& session);

  /// Index of the photograph that is shown; -1: none.
  int current() const { return m_current; }
  void setCurrent(int index);
  void refresh();
  /// @param isOpening whether a result is being opened. @param isBusy whether one is being made.
  void setState(bool isOpening, bool isBusy);

  ReferenceView& outline() const { return *m_outline; }
  widgets::ResidualView& residual() const { return *m_residual; }

 Q_SIGNALS:
  void currentChanged(int index);
  /// The user wants the result to become the document's material.
  void openRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QLayout* buildPhotograph();
  QLayout* buildResult();
  void connectParts();
  void showPhotograph();
  void showStrip();
  void showSpheres();
  void showResult();
  QString checksText() const;

  PhotographSession& m_session;
  int m_current = -1;
  QLabel *m_title, *m_residualTitle, *m_warnings, *m_checks;
  ReferenceView* m_outline;
  widgets::ResidualView* m_residual;
  QListWidget* m_strip;
  SphereView *m_sameLight, *m_otherLight;
  QComboBox* m_lights;
  QLabel* m_sameName;
  widgets::UncertaintyCurve* m_uncertainty;
  QPushButton* m_open;
};

}  // namespace gonio::app
