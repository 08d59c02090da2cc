// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "widgets/preview/gl/preview_comparison.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QPushButton;
class QToolButton;

namespace gonio::widgets {

class NumberField;

/// The controls of a comparison: the mode, the two sides, and the settings of the mode. It owns no state: it emits the
/// user's choices and shows the state that it is given.
class ComparisonBar : public QWidget {
  Q_OBJECT

 public:
  explicit ComparisonBar(QWidget* parent = nullptr);

  /// @param names of the subjects in the order of ComparedSubject; a subject with an empty name cannot be selected.
  void setSubjects(const std::array<QString, 4>& names);
  void setSides(ComparedSubject first, ComparedSubject second);
  void setComparison(const PreviewComparison& comparison);
  /// The automatically determined range that is in use.
  void setFoundRange(double range);

 Q_SIGNALS:
  void comparisonEdited(const gonio::widgets::PreviewComparison& comparison);
  void sidesEdited(gonio::widgets::ComparedSubject first, gonio::widgets::ComparedSubject second);
  /// The user wants to choose another material as the reference.
  void referenceRequested();
  /// A file or a material of the library was dropped here, to become the reference.
  void referenceDropped(const QString& path);
  /// The button that shows the other side was pressed or released.
  void flickerHeld(bool held);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* buildModes();
  QWidget* buildSides();
  QWidget* buildDifference();
  void emitSides(int changed);
  void emitComparison();
  void refresh();

  PreviewComparison m_comparison;
  std::array<ComparedSubject, 2> m_chosen{ComparedSubject::edited, ComparedSubject::measured};
  std::optional<std::array<QString, 4>> m_names;  ///< as shown, indexed by ComparedSubject
  QButtonGroup* m_modes;
  std::array<QComboBox*, 2> m_sides;
  QPushButton* m_hold;
  QComboBox* m_kind;
  QCheckBox* m_automatic;
  NumberField* m_range;
  QWidget *m_sideRow, *m_differenceRow;
};

}  // namespace gonio::widgets
