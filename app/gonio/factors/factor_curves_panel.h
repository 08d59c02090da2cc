// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "app/gonio/document/file_exports.h"
#include "app/gonio/factors/factor_column.h"
#include "app/gonio/factors/factor_terms_view.h"
#include "widgets/curves/curve_view.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace gonio::app {

class FactorTermsView;

/// The content of the Factor curves dock: an editor for the PDV factors of the document's material. Factorises in the
/// background when it is first shown. Changes the document's active edit of factor curves, or adds one if there is
/// none; every change is an undo step.
class FactorCurvesPanel : public QWidget {
  Q_OBJECT

 public:
  FactorCurvesPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  FactorColumn& column(FactorAxis axis) const { return *m_columns[std::size_t(axis)]; }
  /// Shows the number of terms and what they leave out.
  QCheckBox& details() const { return *m_details; }
  QCheckBox& preserveDetail() const { return *m_preserveDetail; }
  /// Whether the factors of the document's material are known, or nothing is shown.
  bool isSettled() const;
  void operate(FactorAxis axis, FactorOperation operation);
  /// Stretches F2 of all terms and channels.
  void widen(double factor);
  /// Adds a new edit of the curves, once they are known; the panel must be visible.
  void addEdit();
  /// Replaces F1 or F2 by that of another material, which is read and factorised in the background. One undo step.
  /// @param id as in the library.
  void replaceCurve(FactorAxis axis, const QString& id);

 Q_SIGNALS:
  void failed(const QString& title, const QString& text);
  void saveRequested(const gonio::app::FileSave& save);

 protected:
  void showEvent(QShowEvent* event) override;
  QSize sizeHint() const override;

 private:
  using Curves = editing::FactorEdit::Curves;
  static const QString swapKey;  ///< key of the background task that reads the other material

  void buildControls();
  void connectColumns();
  void connectDocument();
  /// Marks theta_R in F1, and in F2 the distances |Dp| from the mirror direction to the nearest and the farthest point
  /// of the horizon. @param thetaR rad.
  void showLimits(double thetaR);
  void request();
  void forget();
  void adopt(const FactorsWithCosts& measured);
  void refresh();
  void showResiduals(FactorColumn& column);
  FactorsWithCosts::Kind kind() const;
  int channel() const;
  /// The content of the active edit, or of a new one without effect. Without curves while no factors are known.
  editing::FactorEdit current() const;
  void change(const factorization::PdvFactors& edited, const QString& text);
  /// Sets the active edit; removes it if it has no effect and no name.
  void apply(const editing::FactorEdit& edit, const QString& text);
  void curvesEdited(FactorAxis axis, const widgets::ChannelCurves& curves);
  void chooseTerms(int terms);
  void chooseForm();
  void resetAll();
  void save();

  Document& m_document;
  BackgroundTasks& m_tasks;
  QComboBox *m_channel, *m_form;
  QCheckBox *m_logarithmic, *m_preserveDetail, *m_details;
  QPushButton *m_factorise, *m_resetAll, *m_save;
  std::array<FactorColumn*, 3> m_columns;
  FactorTermsView* m_terms;
  QLabel* m_warning;
  std::shared_ptr<const FactorsWithCosts> m_measured;
  Curves m_original;                   ///< curves of m_measured with the selected number of terms
  FactorsWithCosts::Kind m_requested;  ///< of m_measured or of the running measurement
  bool m_running = false, m_refused = false, m_addWhenKnown = false;
};

}  // namespace gonio::app
