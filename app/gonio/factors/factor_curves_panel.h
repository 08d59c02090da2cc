// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "app/gonio/document/file_saves.h"
#include "app/gonio/factors/factor_column.h"
#include "app/gonio/factors/measured_factors.h"
#include "widgets/curves/curve_view.h"

class QCheckBox;
class QComboBox;
class QPushButton;

namespace gonio::app {

class FactorTermsView;

/// The content of the Factor curves dock: the PDV factors of the document's material under the hand. Factorises in the
/// background when it is first shown. It changes the document's active edit of factor curves, or makes one where there
/// is none; every change is an undo step.
class FactorCurvesPanel : public QWidget {
  Q_OBJECT

 public:
  FactorCurvesPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  FactorColumn& column(FactorAxis axis) const { return *m_columns[std::size_t(axis)]; }
  FactorTermsView& termsView() const { return *m_terms; }
  QCheckBox& keepDetail() const { return *m_keepDetail; }
  /// Whether the factors of the document's material are known, or nothing is shown.
  bool isSettled() const;
  void operate(FactorAxis axis, FactorOperation operation);
  /// Stretches F2 of all terms and channels.
  void widen(double factor);
  /// A new edit of the curves, once they are known; the panel has to be shown.
  void addEdit();
  /// Takes F1 or F2 of a material over, by its id in the library: read and factorised in the background, an undo step.
  void takeOver(FactorAxis axis, const QString& id);

 Q_SIGNALS:
  void failed(const QString& title, const QString& text);
  void saveRequested(const gonio::app::FileSave& save);

 protected:
  void showEvent(QShowEvent* event) override;
  QSize sizeHint() const override;

 private:
  using Curves = editing::FactorEdit::Curves;
  static const QString swapKey;  ///< of the background task that reads the other material

  void buildControls();
  void connectColumns();
  void connectDocument();
  /// Where the disk of directions ends for a viewer, rad.
  void showLimits(double thetaR);
  void request();
  void forget();
  void adopt(const MeasuredFactors& measured);
  void refresh();
  void showResiduals(FactorColumn& column);
  MeasuredFactors::Kind kind() const;
  int channel() const;
  /// The content of the active edit, or one that changes nothing yet. Without curves while nothing is known.
  editing::FactorEdit current() const;
  void change(const factorization::PdvFactors& edited, const QString& text);
  /// What changes nothing and has no name is no edit.
  void apply(const editing::FactorEdit& edit, const QString& text);
  void curvesEdited(FactorAxis axis, const widgets::ChannelCurves& curves);
  void chooseTerms(int terms);
  void chooseForm();
  void resetAll();
  void save();

  Document& m_document;
  BackgroundTasks& m_tasks;
  QComboBox *m_channel, *m_form;
  QCheckBox *m_logarithmic, *m_keepDetail;
  QPushButton *m_factorise, *m_resetAll, *m_save;
  std::array<FactorColumn*, 3> m_columns;
  FactorTermsView* m_terms;
  std::shared_ptr<const MeasuredFactors> m_measured;
  Curves m_original;                  ///< those of m_measured with the chosen number of terms
  MeasuredFactors::Kind m_requested;  ///< of m_measured, or of what is being measured
  bool m_running = false, m_refused = false, m_addWhenKnown = false;
};

}  // namespace gonio::app
