// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/document/background_task.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace gonio::app {

class ComparisonController;

/// The numbers of the current comparison: all metrics, rendered SNR and PSNR. Measured in the background while the
/// panel is visible; grey while they are outdated.
class ComparisonPanel : public QWidget {
  Q_OBJECT

 public:
  ComparisonPanel(ComparisonController& comparison, BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// Whether the numbers belong to the current subjects.
  bool isCurrent() const { return m_current; }
  const std::optional<ComparisonNumbers>& numbers() const { return m_numbers; }
  /// Whether no measurement is pending: finished, hidden, or nothing to compare.
  bool isSettled() const;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void subjectsChanged();
  void measure();
  /// What the table depends on, apart from the values of the numbers.
  struct Shown {
    bool rows = false, numbers = false, current = false, measuring = false;
    bool operator==(const Shown&) const = default;
  };
  void showNumbers();
  void fillTable(const Shown& shown);
  void showFormula(int row, const ComparisonLine& line);
  void copy();
  bool hasBoth() const;

  ComparisonController& m_comparison;
  BackgroundTasks& m_tasks;
  QTimer m_delay;
  QLabel* m_title;
  QTableWidget* m_table;
  QPushButton* m_copy;
  std::optional<ComparisonNumbers> m_numbers;
  ComparisonReferencePtr m_reference;  ///< of the last measurement, reused as long as the subject does not change
  bool m_current = false;
  std::optional<Shown> m_shown;  ///< by the table
};

}  // namespace gonio::app
