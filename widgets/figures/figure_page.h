// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

namespace gonio::widgets {

/// The page of a figure, scaled to the width of the widget or to fit as a whole. The user can draw a square on a
/// picture to mark the part that insets magnify, or move the existing square.
class FigurePage : public QWidget {
  Q_OBJECT

 public:
  explicit FigurePage(QWidget* parent = nullptr);

  /// @param pictures their positions, in fractions of the page's width and height; all show the same square.
  void setPage(const QImage& page, std::vector<QRectF> pictures);
  /// Sets a text shown instead of the page: an instruction or an error. Empty: shows the page.
  void setMessage(const QString& message);
  const QString& message() const { return m_message; }
  /// Sets the square, in fractions of a picture's side from the top left; nullopt: none.
  void setSquare(const std::optional<QRectF>& square);
  /// Whether the page is scaled so that the surrounding widget shows all of it.
  void setWhole(bool whole);
  /// Width of the page in screen pixels, for rendering it.
  int pageWidth() const;
  /// Position of a picture in the widget.
  QRectF placeOf(std::size_t picture) const;

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void squareDrawn(const QRectF& square);
  /// pageWidth() changed.
  void resized();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// A drag: its picture, its start, and the square that it moves, if any.
  struct Drag {
    std::size_t picture;
    QPointF start;
    std::optional<QRectF> moved;
    QRectF square;
  };

  /// Width of the page in a widget of the given width.
  double shownWidth(int width) const;
  QRectF pagePlace() const;
  /// A position in fractions of a picture, clamped to the picture.
  QPointF inPicture(std::size_t picture, const QPointF& position) const;
  std::optional<std::size_t> pictureAt(const QPointF& position) const;
  void reportWidth();
  void paintMessage(QPainter& painter) const;
  void paintDrag(QPainter& painter) const;

  QImage m_page;
  std::vector<QRectF> m_pictures;
  QString m_message;
  std::optional<QRectF> m_square;
  bool m_whole = false;
  int m_reportedWidth = 0;  ///< pageWidth() at the last resized()
  std::optional<Drag> m_drag;
};

}  // namespace gonio::widgets
