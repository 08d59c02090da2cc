// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>

namespace gonio::app {

class ComparisonController;
class DockLayout;
class Document;
class StudyPanel;

/// The Analyse menu: comparisons, and the study of representations.
class AnalyseMenu : public QMenu {
  Q_OBJECT

 public:
  AnalyseMenu(const Document& document, ComparisonController& comparison, DockLayout& docks, StudyPanel& study,
              QWidget* window);

 private:
  void addComparison(ComparisonController& comparison);
  void addModes(QMenu* menu, ComparisonController& comparison);
};

}  // namespace gonio::app
