// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStyledItemDelegate>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QListView;
class QSlider;
class QToolButton;

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

class LibraryChips;
class LibraryModel;
class LibraryOrder;
class LibrarySelection;

/// A grid of materials with search, grouping, sorting and a size slider; several can be selected. Enter or a
/// double-click opens, Space shows a large picture, arrow keys move. It reports which materials are visible, so that
/// their pictures are rendered first.
class LibraryView : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryView(LibraryModel* model, QWidget* parent = nullptr);

  /// The source of the materials, shown above the grid.
  void setTitle(const QString& title);
  /// Shown instead of an empty grid.
  void setEmptyText(const QString& text);
  void setTileSize(int pixels);
  int tileSize() const;
  void setSortMode(int mode);
  int sortMode() const;
  /// A LibraryGrouping.
  void setGrouping(int grouping);
  int grouping() const;
  QStringList visibleIds() const;
  /// The user's selection and actions.
  LibrarySelection& selection() const { return *m_selection; }
  /// Whether the filter buttons are visible.
  void setChipsShown(bool shown);
  bool chipsShown() const;
  LibraryChips& chips() const { return *m_chips; }

  QListView* list() const { return m_list; }
  QLineEdit* search() const { return m_search; }

 Q_SIGNALS:
  void visibleIdsChanged(const QStringList& ids);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Accepts drops of its own materials without effect, so that a drag which ends in the library opens nothing.
  void dragEnterEvent(QDragEnterEvent* event) override;

 private:
  void buildControls();
  void connectList();
  void updateEmptyState();
  void filterChanged();

  LibraryModel* m_model;
  LibraryOrder* m_proxy;
  LibraryDelegate* m_delegate;
  QLabel* m_title;
  QLineEdit* m_search;
  LibraryChips* m_chips;
  QToolButton* m_filter;
  QComboBox* m_group;
  QComboBox* m_sort;
  QListView* m_list;
  LibrarySelection* m_selection;
  QLabel* m_empty;
  QSlider* m_size;
  QTimer m_visibleTimer;
  QString m_emptyText;
};

}  // namespace gonio::widgets
