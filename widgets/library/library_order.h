// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QSortFilterProxyModel>

#include "widgets/library/library_model.h"

namespace gonio::widgets {

/// A filter of the library; empty lists match everything.
struct LibraryFilter {
  QStringList badges, kinds, tags;
  bool favourites = false;
  bool recent = false;  ///< opened in the last week
  bool operator==(const LibraryFilter&) const = default;
};

/// The materials that match a search, in groups below their headings, sorted inside each group.
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

  LibraryModel* m_model;
  LibraryGrouping m_grouping = LibraryGrouping::none;
  QStringList m_words;
  LibraryFilter m_filter;
};

}  // namespace gonio::widgets
