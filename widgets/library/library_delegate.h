// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStyledItemDelegate>

namespace gonio::widgets {

/// Draws a tile of the library: the picture (or a placeholder disc), its badge and the name below; or a heading.
class LibraryDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void setTileSize(int pixels) { m_tile = pixels; }
  int tileSize() const { return m_tile; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintTile(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;

  int m_tile = 96;
};

}  // namespace gonio::widgets
