// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <array>

#include "widgets/preview/gl/preview_comparison.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QPushButton;
class QToolButton;

namespace gonio::widgets {

class NumberField;

/// The controls of a comparison: the mode, the two sides, and what the mode needs. It shows what others own: it emits
/// what the user wants and shows the result.
class ComparisonBar : public QWidget {
  Q_OBJECT

 public:
  explicit ComparisonBar(QWidget* parent = nullptr);

  /// @param names of the subjects in the order of ComparedSubject; an empty one is not there and cannot be chosen.
  void setSubjects(const std::array<QString, 4>& names);
  void setSides(ComparedSubject first, ComparedSubject second);
  void setComparison(const PreviewComparison& comparison);
  /// The range that is in use while it is found automatically.
  void setFoundRange(double range);

 Q_SIGNALS:
  void comparisonEdited(const gonio::widgets::PreviewComparison& comparison);
  void sidesEdited(gonio::widgets::ComparedSubject first, gonio::widgets::ComparedSubject second);
  /// The user wants to choose another material as the reference.
  void referenceWanted();
  /// A file or a material of the library was dropped here: it is to be the reference.
  void referenceDropped(const QString& path);
  /// The button that shows the other side is held.
  void flickerHeld(bool held);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* buildModes();
  QWidget* buildSides();
  QWidget* buildDifference();
  void tellSides(int changed);
  void emitComparison();
  void refresh();

  PreviewComparison m_comparison;
  std::array<ComparedSubject, 2> m_chosen{ComparedSubject::edited, ComparedSubject::measured};
  QButtonGroup* m_modes;
  std::array<QComboBox*, 2> m_sides;
  QPushButton* m_hold;
  QComboBox* m_kind;
  QCheckBox* m_automatic;
  NumberField* m_range;
  QWidget *m_sideRow, *m_differenceRow;
};

}  // namespace gonio::widgets
