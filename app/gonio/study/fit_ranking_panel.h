// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/document/document_controller.h"
#include "app/gonio/study/fit_ranking_model.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;

namespace gonio::app {

struct SheetSource;

/// Compares all models: fits them in the background, shows each when it is finished, and uses the one that is clicked.
/// The fits are stored with the document's material.
class FitRankingPanel : public QWidget {
  Q_OBJECT

 public:
  FitRankingPanel(Document& document, DocumentController& controller, BackgroundTasks& tasks,
                  QWidget* parent = nullptr);

  FitRankingModel& model() { return m_model; }
  QTreeView* view() const { return m_view; }
  bool isRunning() const;

 public Q_SLOTS:
  void fitAll();

 Q_SIGNALS:
  void contactSheetRequested(const gonio::app::SheetSource& source);
  void failed(const QString& title, const QString& text);

 private:
  void buildView();
  void materialChanged();
  void take(const study::RankedFit& ranked);
  void use(const QModelIndex& index);
  void refresh();

  Document& m_document;
  DocumentController& m_controller;
  BackgroundTasks& m_tasks;
  FitRankingModel m_model;
  QSortFilterProxyModel* m_sorted;
  QComboBox* m_metric;
  QPushButton *m_fitAll, *m_sheet, *m_copy;
  QTreeView* m_view;
  QLabel* m_empty;
};

}  // namespace gonio::app
