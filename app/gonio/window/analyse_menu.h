// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>
#include <QPointer>

#include "app/gonio/figures/figure_dialog.h"

namespace gonio::app {

class ComparisonController;
class DockLayout;
class Document;
class StudyPanel;

/// The Analyse menu: comparisons, the study of representations, and figures.
class AnalyseMenu : public QMenu {
  Q_OBJECT

 public:
  AnalyseMenu(const FigureDialog::Parts& figures, ComparisonController& comparison, DockLayout& docks,
              StudyPanel& study, QWidget* window);

 private:
  void addComparison(ComparisonController& comparison);
  void addModes(QMenu* menu, ComparisonController& comparison);
  void addFigure(const FigureDialog::Parts& figures, QWidget* window);

  QPointer<FigureDialog> m_figure;  ///< at most one
};

}  // namespace gonio::app
