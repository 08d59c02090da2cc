// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "widgets/library/library_order.h"

class QToolButton;

namespace gonio::widgets {

/// Filter buttons for each badge, kind and tag in the library, for favourites, and for recently opened materials.
/// Buttons of the same group are combined with OR, different groups with AND.
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
  /// Adds a button that puts its text in a list of the filter while it is pressed.
  QToolButton* addMember(const QString& text, const QString& toolTip, QStringList& list);
  QToolButton* addButton(const QString& text, const QString& toolTip);

  const LibraryModel& m_model;
  LibraryFilter m_filter;
  std::vector<QToolButton*> m_chips;
  QStringList m_tags;  ///< that have a button
};

}  // namespace gonio::widgets
