// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "core/study/study_plot.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace gonio::app {

/// Limits for a representation, the best representation within them, and a button that uses it.
class StudyBudgetBar : public QWidget {
  Q_OBJECT

 public:
  explicit StudyBudgetBar(QWidget* parent = nullptr);

  study::Budget budget() const;
  void setBudget(const study::Budget& budget);
  /// Shows a text beside the limits. @param canUse whether the button is enabled.
  void setResult(const QString& text, bool canUse);
  QPushButton& useButton() const { return *m_use; }

 Q_SIGNALS:
  void budgetChanged();
  void useRequested();

 private:
  QDoubleSpinBox* field(const QString& label, const QString& unit, double maximum, const QString& toolTip);

  QDoubleSpinBox *m_frame, *m_snr, *m_kilobytes;
  QLabel* m_result;
  QPushButton* m_use;
};

}  // namespace gonio::app
