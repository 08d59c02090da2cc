// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/analyse_menu.h"

#include <QActionGroup>

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/study/study_panel.h"
#include "app/gonio/window/dock_layout.h"

namespace gonio::app {

using widgets::CompareMode;

AnalyseMenu::AnalyseMenu(const FigureDialog::Parts& figures, ComparisonController& comparison, DockLayout& docks,
                         StudyPanel& study, QWidget* window)
    : QMenu(tr("&Analyse"), window) {
  const Document& document = figures.document;
  addComparison(comparison);
  QAction* measure =
      addAction(tr("&Measure Representations"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_M), this, [&docks, &study] {
        docks.show(QStringLiteral("study"));
        study.measure();
      });
  measure->setToolTip(tr("Accuracy vs. cost: the error and the cost of every representation of the material"));
  QAction* sheet = addAction(tr("Contact S&heet..."), this, [&docks, &study] {
    if (!study.openSheet()) docks.show(QStringLiteral("study"));
  });
  sheet->setToolTip(tr("The measured representations as images side by side, with error maps"));
  const auto enable = [&document, measure, sheet] {
    for (QAction* action : {measure, sheet}) action->setEnabled(document.material() != nullptr);
  };
  connect(&document, &Document::materialChanged, this, enable);
  enable();
  addFigure(figures, window);
}

void AnalyseMenu::addFigure(const FigureDialog::Parts& figures, QWidget* window) {
  QAction* action =
      addAction(tr("F&igure..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F), this, [this, figures, window] {
        if (!m_figure) {
          m_figure = new FigureDialog(figures, window);
          m_figure->setAttribute(Qt::WA_DeleteOnClose);
        }
        m_figure->show();
        m_figure->raise();
        m_figure->activateWindow();
      });
  action->setToolTip(
      tr("Makes a figure for a paper: a grid of materials and representations with error maps, insets and "
         "numbers"));
}

void AnalyseMenu::addComparison(ComparisonController& comparison) {
  QAction* compare = addAction(tr("&Compare"), QKeySequence(Qt::Key_C), &comparison, &ComparisonController::toggle);
  compare->setCheckable(true);
  compare->setToolTip(
      tr("Compares two materials or states, such as measured and edited, in the preview; hold \\ to see only "
         "the second"));
  const auto update = [&comparison, compare] { compare->setChecked(comparison.comparison().mode != CompareMode::off); };
  connect(&comparison, &ComparisonController::comparisonChanged, this, update);
  addModes(addMenu(tr("Comparison M&ode")), comparison);
  addAction(tr("Compare with &Another Material..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C), &comparison,
            &ComparisonController::referenceRequested);
}

void AnalyseMenu::addModes(QMenu* menu, ComparisonController& comparison) {
  auto* group = new QActionGroup(this);
  const std::pair<CompareMode, QString> modes[] = {{CompareMode::off, tr("&Off")},
                                                   {CompareMode::split, tr("&Split")},
                                                   {CompareMode::flicker, tr("&Flicker")},
                                                   {CompareMode::difference, tr("&Difference")},
                                                   {CompareMode::twoUp, tr("S&ide by Side")}};
  for (const auto& [mode, text] : modes) {
    QAction* action = group->addAction(menu->addAction(text));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [&comparison, mode = mode] {
      widgets::PreviewComparison changed = comparison.comparison();
      changed.mode = mode;
      comparison.setComparison(changed);
    });
    connect(menu, &QMenu::aboutToShow, this,
            [&comparison, action, mode = mode] { action->setChecked(comparison.comparison().mode == mode); });
  }
}

}  // namespace gonio::app

#include "moc_analyse_menu.cpp"
