// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <optional>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "app/gonio/acquisition/acquisition_result.h"
#include "widgets/acquisition/factor_curves.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace gonio::widgets {
class NumberField;
class ReconstructionView;
}  // namespace gonio::widgets

namespace gonio::app {

class AcquisitionFiles;

/// A factor measurement: its settings, the readings of both curves, and the predicted material with its error and the
/// reasons why it may be unreliable. The readings are simulated from the measured material, again after each change
/// while the page is visible, or taken from a file.
class FactorPage : public QWidget {
  Q_OBJECT

 public:
  /// @param tasks may be destroyed before the page; its tasks end with the page.
  FactorPage(const AcquisitionSession& session, const AcquisitionControls& controls, AcquisitionFiles& files,
             BackgroundTasks& tasks);

  FactorSettings settings() const;
  /// Null until there is a result.
  const FactorResultPtr& result() const { return m_result; }
  /// Takes the readings, and the settings that belong to them, from a file. If it cannot be read, reports the error and
  /// changes nothing.
  void openReadings(const QString& path);
  void saveReadings(const QString& path);
  /// Discards the readings of the file and simulates readings again.
  void simulate();
  /// "chrome from two curves"
  QString resultName() const;
  bool isBusy() const;

 Q_SIGNALS:
  /// The user wants the predicted material to become the document's material.
  void openRequested();
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QLayout* buildSettings();
  QLayout* buildResult();
  void connectParts();
  void measure();
  void changeAxes();
  void showResult();
  widgets::FactorCurves::Content shownCurves() const;
  QStringList facts() const;
  void refreshControls();

  const AcquisitionSession& m_session;
  const AcquisitionControls& m_controls;
  AcquisitionFiles& m_files;
  BackgroundTasks& m_tasks;
  FactorResultPtr m_result;
  QString m_resultOf;
  std::optional<FactorReadingsFile> m_opened;  ///< empty: the readings are simulated
  QComboBox* m_axes;
  widgets::NumberField *m_fixedAngle, *m_readings;
  QCheckBox* m_bound;
  widgets::FactorCurves* m_curves;
  widgets::ReconstructionView* m_view;
  QLabel *m_numbers, *m_warnings;
  QPushButton *m_open, *m_openReadings, *m_saveReadings, *m_simulate;
};

}  // namespace gonio::app
