// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QButtonGroup>
#include <QScrollArea>
#include <QString>

#include "app/gonio/document/document_controller.h"
#include "core/editing/differential_edit.h"

class QSettings;
namespace gonio::widgets {
class CollapsibleSection;
class ControlPanel;
class CostLine;
class EditStack;
class FactList;
class ModelPanel;
class ParameterPanel;
class PlausibilityBadges;
}  // namespace gonio::widgets

namespace gonio::app {

/// The change of an edit as arguments of `goniotool edit`: "--model ggx --set roughness=0.4 --control tint=1,0.5,0.2
/// --compose lobes". Numbers are exact, with a decimal point in every locale.
QString editArguments(const editing::DifferentialEdit& edit);

class CostMonitor;
class PlausibilityMonitor;
class RepresentationPanel;
class TableErrorMonitor;
class WavelengthPanel;

/// The kinds of editing: the controls of a model, the factor curves of the measurement, a blend with other materials.
enum class EditingKind { sliders, curves, blend };

/// The right side of the window: the kinds of editing, the controls, their cost and the list of edits; then, under
/// Details, the model, all parameters, plausibility, representation and source.
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
  /// Marks the kind of editing whose panel is in view. Emits nothing.
  void setKind(EditingKind kind);
  EditingKind kind() const { return EditingKind(m_kinds.checkedId()); }
  /// Expands the Representation section.
  void unfoldRepresentation();
  /// Expands the section that contains a row, scrolls to the row and gives it the focus.
  void reveal(QWidget& row);
  /// Whether the background measurements belong to the current state.
  bool isSettled() const;
  void saveState(QSettings& settings) const;
  void restoreState(const QSettings& settings);

  QSize sizeHint() const override;
  /// Wide enough for the widest row, so that there is no horizontal scrolling.
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// The user chose a kind of editing.
  void kindChosen(gonio::app::EditingKind kind);
  /// The user wants another edit of factor curves, which FactorCurvesPanel adds.
  void factorEditRequested();

 private:
  QWidget* buildKinds();
  void addSection(QLayout& layout, const QString& key, const QString& title, QWidget* content);
  QWidget* buildDetails();
  void connectDocument();
  void connectControls();
  void connectParameters();
  void offerArguments(QWidget& panel);
  void showSource();
  void showModel();
  void showCosts();
  QString noSlidersText() const;
  void showValues();
  void connectEdits();
  void showEdits();
  /// The effect of an edit on the energy.
  QString energyText(int edit) const;
  /// The edit of an entry of the list.
  int editOf(int entry) const;

  Document& m_document;
  DocumentController& m_controller;
  BackgroundTasks& m_tasks;
  widgets::FactList* m_source;
  TableErrorMonitor* m_tableError;
  CostMonitor* m_costs;
  WavelengthPanel* m_wavelength;
  RepresentationPanel* m_representation;
  widgets::ModelPanel* m_model;
  widgets::CostLine* m_cost;
  widgets::PlausibilityBadges* m_plausibility;
  PlausibilityMonitor* m_monitor;
  widgets::ControlPanel* m_controls;
  widgets::ParameterPanel* m_parameters;
  widgets::EditStack* m_edits;
  int m_unlisted = -1;                                     ///< the edit of the fit alone, which has no entry; -1: none
  QButtonGroup m_kinds;                                    ///< by EditingKind
  QMap<QString, widgets::CollapsibleSection*> m_sections;  ///< by their name in the settings
  const models::Model* m_shownModel = nullptr;             ///< model of the sliders
  QString m_noSliders;                                     ///< text shown instead of sliders if there is no model
};

}  // namespace gonio::app
