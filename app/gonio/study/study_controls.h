// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "core/study/study_plot.h"

class QDoubleSpinBox;

namespace gonio::app {

/// A label before a field, with its shortcut.
QLabel* labelFor(const QString& text, QWidget* buddy);

/// The representations that need only the material, to be ticked; families with several have these below them.
class StudyChoice : public QTreeWidget {
  Q_OBJECT

 public:
  StudyChoice();

  /// Sets the ids of families and representations that are ticked; emits namesChanged().
  void setNames(const std::vector<std::string>& names);
  /// The smallest list of such ids.
  std::vector<std::string> names() const;

 Q_SIGNALS:
  void namesChanged();

 private:
  bool m_filling = false;
};

/// Limits for a representation, the best representation within them, and a button that uses it.
class StudyBudgetBar : public QWidget {
  Q_OBJECT

 public:
  StudyBudgetBar();

  study::Budget budget() const;
  void setBudget(const study::Budget& budget);
  /// Shows a text beside the limits. @param canUse whether the button is enabled.
  void setResult(const QString& text, bool canUse);

 Q_SIGNALS:
  void budgetChanged();
  void useRequested();

 private:
  QDoubleSpinBox* field(const QString& text, const QString& unit, double maximum);

  QDoubleSpinBox *m_maxFrame, *m_minSnr, *m_maxSize;
  QLabel* m_result;
  QPushButton* m_use;
};

}  // namespace gonio::app
