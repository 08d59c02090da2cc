// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QSortFilterProxyModel>

#include "widgets/library/library_model.h"

namespace gonio::widgets {

/// The materials that match a search, in groups below their headings, sorted inside each group.
class LibraryOrder : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  LibraryOrder(LibraryModel* model, QObject* parent);

  void setGrouping(LibraryGrouping grouping);

 protected:
  /// A heading where one of its materials matches; a material by its name or its kind.
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  bool matches(int row) const;

  LibraryModel* m_model;
  LibraryGrouping m_grouping = LibraryGrouping::none;
};

}  // namespace gonio::widgets
