// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>

namespace gonio::app {

class AcquisitionPanel;
class BackgroundTasks;
class ComparisonController;
class DockLayout;
class Document;
class DocumentController;
class FitRankingPanel;
struct FileSave;
class InterpolationPanel;

/// The Material menu: fits, blends, acquisition, and stopping work.
class MaterialMenu : public QMenu {
  Q_OBJECT

 public:
  struct Parts {
    Document& document;
    DocumentController& controller;
    BackgroundTasks& tasks;
    ComparisonController& comparison;
    DockLayout& docks;
    FitRankingPanel& ranking;
    InterpolationPanel& interpolation;
    AcquisitionPanel& acquisition;
  };
  MaterialMenu(const Parts& parts, QWidget* window);

 Q_SIGNALS:
  void saveRequested(const gonio::app::FileSave& save);

 private:
  void saveFit(const Document& document);
  void addFits(const Parts& parts);
  void addBlends(const Parts& parts);
  void addCancel(const Parts& parts);
};

}  // namespace gonio::app
