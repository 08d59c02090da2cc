// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QScrollArea>

#include "app/gonio/document/document_controller.h"

class QSettings;

namespace gonio::widgets {
class CollapsibleSection;
class ControlPanel;
class EditStack;
class FactList;
class ModelPanel;
class ParameterPanel;
class PlausibilityBadges;
}  // namespace gonio::widgets

namespace gonio::app {

class PlausibilityMonitor;
class RepresentationPanel;
class TableErrorMonitor;
class WavelengthPanel;

/// The right side of the window: Source, Model, Edits, Controls, Parameters, Plausibility and Representation of a
/// document, in sections that fold.
class Inspector : public QScrollArea {
  Q_OBJECT

 public:
  Inspector(Document& document, DocumentController& controller, BackgroundTasks& tasks, QWidget* parent = nullptr);

  widgets::ControlPanel* controls() const { return m_controls; }
  widgets::ParameterPanel* parameters() const { return m_parameters; }
  widgets::PlausibilityBadges* plausibility() const { return m_plausibility; }
  widgets::EditStack* edits() const { return m_edits; }
  RepresentationPanel* representation() const { return m_representation; }
  WavelengthPanel* wavelength() const { return m_wavelength; }
  /// Unfolds its section.
  void unfoldRepresentation();
  /// Unfolds the section of a row of its panels, scrolls there and gives the row the focus.
  void reveal(QWidget& row);
  /// Whether what is measured in the background describes the present state.
  bool isSettled() const;
  void saveState(QSettings& settings) const;
  void restoreState(const QSettings& settings);

  QSize sizeHint() const override;
  /// As wide as the widest row needs: nothing scrolls sideways.
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// Another edit of factor curves is wanted: the factor curves make it.
  void factorEditWanted();

 private:
  void connectDocument();
  void connectControls();
  void connectParameters();
  void offerArguments(QWidget& panel);
  void showSource();
  void showModel();
  QString noSlidersText() const;
  void showValues();
  void connectEdits();
  void showEdits();
  /// What an edit does to the energy.
  QString energyText(int edit) const;

  Document& m_document;
  DocumentController& m_controller;
  BackgroundTasks& m_tasks;
  widgets::FactList* m_source;
  TableErrorMonitor* m_tableError;
  WavelengthPanel* m_wavelength;
  RepresentationPanel* m_representation;
  widgets::ModelPanel* m_model;
  widgets::PlausibilityBadges* m_plausibility;
  PlausibilityMonitor* m_monitor;
  widgets::ControlPanel* m_controls;
  widgets::ParameterPanel* m_parameters;
  widgets::EditStack* m_edits;
  QMap<QString, widgets::CollapsibleSection*> m_sections;  ///< by the name under which they are remembered
  const models::Model* m_shownModel = nullptr;             ///< of the sliders
  QString m_noSliders;                                     ///< stands in their place where there is no model
};

}  // namespace gonio::app
