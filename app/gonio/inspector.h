// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QScrollArea>

#include "app/gonio/document_controller.h"

class QSettings;

namespace gonio::widgets {
class CollapsibleSection;
class FactList;
class ModelPanel;
class ParameterPanel;
}  // namespace gonio::widgets

namespace gonio::app {

/// The right side of the window: Source, Model, Parameters of a document, in sections that fold.
class Inspector : public QScrollArea {
  Q_OBJECT

 public:
  Inspector(Document& document, DocumentController& controller, BackgroundTasks& tasks, QWidget* parent = nullptr);

  widgets::ParameterPanel* parameters() const { return m_parameters; }
  void saveState(QSettings& settings) const;
  void restoreState(const QSettings& settings);

  QSize sizeHint() const override;

 private:
  void connectDocument();
  void connectParameters();
  void showSource();
  void showModel();
  void showValues();

  Document& m_document;
  DocumentController& m_controller;
  BackgroundTasks& m_tasks;
  widgets::FactList* m_source;
  widgets::ModelPanel* m_model;
  widgets::ParameterPanel* m_parameters;
  QList<widgets::CollapsibleSection*> m_sections;
  const models::Model* m_shownModel = nullptr;
};

}  // namespace gonio::app
