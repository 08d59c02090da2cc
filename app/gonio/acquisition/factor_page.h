// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "app/gonio/acquisition/factor_result.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace gonio::widgets {
class FactorCurves;
class NumberField;
class ReconstructionView;
}  // namespace gonio::widgets

namespace gonio::app {

/// A factor measurement of the measured material: its settings, the readings of both curves, and the predicted material
/// with its error and the reasons why it may be unreliable. Measures again after each change while it is visible.
class FactorPage : public QWidget {
  Q_OBJECT

 public:
  /// @param tasks may be destroyed before the page; its tasks end with the page.
  FactorPage(const AcquisitionSession& session, const AcquisitionControls& controls, BackgroundTasks& tasks);

  FactorSettings settings() const;
  /// Null until there is a result.
  const FactorResultPtr& result() const { return m_result; }
  /// "chrome from two curves"
  QString resultName() const;
  bool isBusy() const;

  QComboBox& axesBox() const { return *m_axes; }
  QCheckBox& boundBox() const { return *m_bound; }
  widgets::NumberField& fixedAngle() const { return *m_fixedAngle; }
  widgets::FactorCurves& curves() const { return *m_curves; }
  widgets::ReconstructionView& view() const { return *m_view; }
  QPushButton& openButton() const { return *m_open; }
  /// The numbers of the result, and the warnings, as text.
  QString numbers() const;
  QString warnings() const;

 Q_SIGNALS:
  /// The user wants the predicted material to become the document's material.
  void openRequested();
  void failed(const QString& title, const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QLayout* buildSettings();
  QLayout* buildResult();
  void connectParts();
  void measure();
  void showResult();

  const AcquisitionSession& m_session;
  const AcquisitionControls& m_controls;
  BackgroundTasks& m_tasks;
  FactorResultPtr m_result;
  QString m_resultOf;
  QComboBox* m_axes;
  widgets::NumberField *m_fixedAngle, *m_readings;
  QCheckBox* m_bound;
  widgets::FactorCurves* m_curves;
  widgets::ReconstructionView* m_view;
  QLabel *m_numbers, *m_warnings;
  QPushButton* m_open;
};

}  // namespace gonio::app
