// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "widgets/library/library_order.h"

class QToolButton;

namespace gonio::widgets {

/// A button for each kind, origin and tag that the library has, for the favourites and what was opened lately. Those
/// that are pressed say what is shown: of several of one sort any, of two sorts both.
class LibraryChips : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryChips(const LibraryModel& model, QWidget* parent = nullptr);

  const LibraryFilter& filter() const { return m_filter; }
  void clear();
  QToolButton* chip(const QString& text) const;

 Q_SIGNALS:
  void filterChanged();

 private:
  void rebuild();
  void followTags();
  void addChip(const QString& text, const QString& toolTip, bool& wanted);
  /// One whose text is in a list of the filter while it is pressed.
  QToolButton* addMember(const QString& text, const QString& toolTip, QStringList& list);
  QToolButton* addButton(const QString& text, const QString& toolTip);

  const LibraryModel& m_model;
  LibraryFilter m_filter;
  std::vector<QToolButton*> m_chips;
  QStringList m_tags;  ///< that have a button
};

}  // namespace gonio::widgets
