// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QPixmap>
#include <QWidget>
#include <vector>

namespace gonio::widgets {

/// One representation on a contact sheet. A null picture is pending.
struct SheetTile {
  QString name;
  QString numbers;  ///< one to three lines below the name
  QPixmap picture;
  QPixmap map;        ///< error map; null: none
  QString note = {};  ///< text in place of a null picture; empty: that it is being rendered
};

/// Pictures of materials and their representations side by side, with error maps on a common scale, names and numbers.
/// Two tiles can be selected. The same drawing code is used for the widget and for pictures of any size.
class ContactSheet : public QWidget {
  Q_OBJECT

 public:
  explicit ContactSheet(QWidget* parent = nullptr);

  void setTiles(std::vector<SheetTile> tiles);
  const std::vector<SheetTile>& tiles() const { return m_tiles; }
  /// Sets the absolute luminance difference shown in the last colour of the error maps; 0: no maps.
  void setRange(double range);
  void setMapsShown(bool shown);
  /// Sets the side of a picture in the widget, in pixels; smaller if the columns need it.
  void setTileSide(int pixels);
  /// Sets the number of columns in the widget; 0: as many as it has room for.
  void setColumns(int columns);
  int columns() const { return m_columns; }

  /// At most two tiles, in the order of selection.
  const std::vector<int>& selected() const { return m_selected; }
  /// Selects or deselects a tile; a third selection drops the oldest.
  void toggle(int tile);

  /// The whole sheet on white, without the selection.
  QImage picture(int tileSide, int columns) const;
  /// The same as a PDF file of one page, with texts as text. @param tileSide in points.
  QByteArray pdf(int tileSide, int columns) const;

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void selectionChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Layout;
  Layout layoutFor(int tileSide, int columns, const QFont& font) const;
  Layout layoutIn(int width) const;
  void draw(QPainter& painter, const Layout& layout, const QColor& text) const;
  void drawTile(QPainter& painter, const Layout& layout, std::size_t index) const;
  void drawPlaceholder(QPainter& painter, const QRect& square, const QString& note) const;
  void drawScale(QPainter& painter, const Layout& layout) const;

  std::vector<SheetTile> m_tiles;
  std::vector<int> m_selected;
  int m_current = 0, m_side = 160, m_columns = 0;
  double m_range = 0;
  bool m_mapsShown = true;
};

}  // namespace gonio::widgets
