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

/// The numbers of what the comparison controller compares: every metric, rendered SNR and PSNR. Measured in the
/// background while the panel is in sight; grey until they are those of what is shown.
class ComparisonPanel : public QWidget {
  Q_OBJECT

 public:
  ComparisonPanel(ComparisonController& comparison, BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// Whether the numbers are those of the present subjects.
  bool isCurrent() const { return m_current; }
  const std::optional<ComparisonNumbers>& numbers() const { return m_numbers; }
  /// Whether nothing is to come: measured, out of sight, or nothing to compare.
  bool isSettled() const;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void subjectsChanged();
  void measure();
  void fillTable(const ComparisonNumbers* numbers);
  void copy();
  bool hasBoth() const;

  ComparisonController& m_comparison;
  BackgroundTasks& m_tasks;
  QTimer m_delay;
  QLabel* m_title;
  QTableWidget* m_table;
  QPushButton* m_copy;
  std::optional<ComparisonNumbers> m_numbers;
  ComparisonReferencePtr m_reference;  ///< of the last measurement, used again while it is the same subject
  bool m_current = false;
};

}  // namespace gonio::app
