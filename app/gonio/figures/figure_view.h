// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTimer>
#include <QWidget>

#include "app/gonio/figures/figure_controller.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace gonio::widgets {
class FigurePage;
}

namespace gonio::app {

/// The page of a figure, updated with its description, and the button that measures its missing cells.
class FigureView : public QWidget {
  Q_OBJECT

 public:
  explicit FigureView(BackgroundTasks& tasks, QWidget* parent = nullptr);

  void setDescription(const figures::FigureDescription& description);
  FigureController& controller() const { return *m_controller; }
  widgets::FigurePage& page() const { return *m_page; }
  /// The text beside the button: progress, missing cells or an error.
  QString status() const;
  /// Shows a message beside the button until the description changes.
  void setNotice(const QString& notice);
  /// Whether the page is up to date and no measurement is running.
  bool isSettled() const;

 Q_SIGNALS:
  void insetDrawn(const gonio::figures::FigureInset& inset);

 private:
  void build();
  void connectParts();
  void showFigure(const DrawnFigure& figure);
  /// Instruction for an empty figure; empty if the figure can be drawn.
  QString emptyText() const;
  /// The status while no figure is measured or written.
  QString restText() const;
  void refresh();

  BackgroundTasks& m_tasks;
  FigureController* m_controller;
  widgets::FigurePage* m_page;
  QLabel* m_status;
  QProgressBar* m_bar;
  QPushButton* m_measure;
  QTimer m_resized;  ///< redraws the page when resizing has ended
  std::size_t m_cells = 0, m_missing = 0;
  double m_errorMaximum = 0;
  QString m_failure, m_notice;
};

}  // namespace gonio::app
