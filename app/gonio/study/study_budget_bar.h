// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "core/study/pareto.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace gonio::app {

/// Limits that a representation has to keep, the one that keeps them best, and a button that takes it.
class StudyBudgetBar : public QWidget {
  Q_OBJECT

 public:
  explicit StudyBudgetBar(QWidget* parent = nullptr);

  study::Budget budget() const;
  void setBudget(const study::Budget& budget);
  /// What is shown beside the limits.
  void setResult(const QString& text, bool mayTake);
  QPushButton& take() const { return *m_take; }

 Q_SIGNALS:
  void budgetChanged();
  void taken();

 private:
  QDoubleSpinBox* field(const QString& label, const QString& unit, double most, const QString& toolTip);

  QDoubleSpinBox *m_frame, *m_snr, *m_kilobytes;
  QLabel* m_result;
  QPushButton* m_take;
};

}  // namespace gonio::app
