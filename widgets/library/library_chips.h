// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QSortFilterProxyModel>
#include <QWidget>
#include <functional>
#include <vector>

#include "widgets/library/library_model.h"

class QToolButton;

namespace gonio::widgets {

/// A filter of the library; empty lists match everything.
struct LibraryFilter {
  QStringList badges, kinds, tags;
  bool favourites = false;
  bool recent = false;  ///< opened in the last week
  bool operator==(const LibraryFilter&) const = default;
};

/// The materials that match a search, each in its best quality that matches, in groups below their headings, sorted
/// inside each group.
class LibraryOrder : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  LibraryOrder(LibraryModel* model, QObject* parent);

  void setGrouping(LibraryGrouping grouping);
  /// Words in any order: each must be the beginning of a word of the name, the kind, the badge, the source or a tag.
  void setSearch(const QString& text);
  void setFilter(const LibraryFilter& filter);

 protected:
  /// Headings are accepted if one of their materials matches.
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  bool matches(int row) const;
  /// Whether no better quality of the same material matches.
  bool isBest(int row) const;

  LibraryModel* m_model;
  LibraryGrouping m_grouping = LibraryGrouping::none;
  QStringList m_words;
  LibraryFilter m_filter;
};

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
