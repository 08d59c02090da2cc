// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/analyse_menu.h"

#include <QActionGroup>
#include <QMenuBar>

#include "app/gonio/comparison/flicker_key.h"
#include "app/gonio/comparison/reference_dialog.h"
#include "app/gonio/study/study_panel.h"
#include "app/gonio/window/main_window.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

using widgets::CompareMode;

AnalyseMenu::AnalyseMenu(MainWindow& window) : QObject(&window), m_window(window) {
  QMenu* menu = window.menuBar()->addMenu(tr("&Analyse"));
  ComparisonController& comparison = window.comparison();
  QAction* compare =
      menu->addAction(tr("&Compare"), QKeySequence(Qt::Key_C), &comparison, &ComparisonController::toggle);
  compare->setCheckable(true);
  compare->setToolTip(tr("Two sides against each other in the preview: hold \\ to see the second alone"));
  const auto update = [&comparison, compare] { compare->setChecked(comparison.comparison().mode != CompareMode::off); };
  connect(&comparison, &ComparisonController::comparisonChanged, this, update);
  addModes(menu->addMenu(tr("Compare &As")));
  menu->addAction(tr("Compare with &Another Material..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C), this,
                  &AnalyseMenu::chooseReference);
  connect(&comparison, &ComparisonController::referenceWanted, this, &AnalyseMenu::chooseReference);
  QAction* study =
      menu->addAction(tr("&Measure Representations"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_M), this, [&window] {
        window.showDock(QStringLiteral("study"));
        window.study().measure();
      });
  study->setToolTip(tr("Accuracy against time: every way to keep the material, its error and what it costs"));
  const auto enable = [&window, study] { study->setEnabled(window.document().material() != nullptr); };
  connect(&window.document(), &Document::materialChanged, this, enable);
  enable();
  new FlickerKey(&window, [&window](bool held) { window.preview().setFlickering(held); });
}

void AnalyseMenu::addModes(QMenu* menu) {
  ComparisonController& comparison = m_window.comparison();
  auto* group = new QActionGroup(this);
  const std::pair<CompareMode, QString> modes[] = {{CompareMode::off, tr("&Off")},
                                                   {CompareMode::split, tr("&Split")},
                                                   {CompareMode::flicker, tr("&Flicker")},
                                                   {CompareMode::difference, tr("&Difference")},
                                                   {CompareMode::twoUp, tr("&Two-up")}};
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

void AnalyseMenu::chooseReference() {
  auto* dialog = new ReferenceDialog(m_window.library().model(), &m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ReferenceDialog::chosen, &m_window.comparison(), &ComparisonController::openReference);
  dialog->open();
}

}  // namespace gonio::app

#include "moc_analyse_menu.cpp"
