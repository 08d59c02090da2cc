// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/icons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmapCache>
#include <numbers>

namespace gonio::widgets {

namespace {

/// Paths on a 16 x 16 grid.
void drawGlyph(QPainter& painter, Glyph glyph) {
  switch (glyph) {
    case Glyph::reset: {
      painter.drawArc(QRectF(3.5, 3.5, 9, 9), -120 * 16, 250 * 16);
      QPainterPath head;
      head.moveTo(3.2, 2.6);
      head.lineTo(3.9, 7.0);
      head.lineTo(8.0, 5.6);
      head.closeSubpath();
      painter.fillPath(head, painter.pen().color());
      return;
    }
    case Glyph::collapsed:
      painter.drawPolyline(QPolygonF{{6, 3.5}, {10.5, 8}, {6, 12.5}});
      return;
    case Glyph::expanded:
      painter.drawPolyline(QPolygonF{{3.5, 6}, {8, 10.5}, {12.5, 6}});
      return;
    case Glyph::search:
      painter.drawEllipse(QRectF(3, 3, 7, 7));
      painter.drawLine(QPointF(9, 9), QPointF(13, 13));
      return;
    case Glyph::close:
      painter.drawLine(QPointF(4, 4), QPointF(12, 12));
      painter.drawLine(QPointF(12, 4), QPointF(4, 12));
      return;
    case Glyph::passed:
      painter.drawPolyline(QPolygonF{{3, 8.5}, {6.5, 12}, {13, 4.5}});
      return;
    case Glyph::warning:
      painter.drawPolygon(QPolygonF{{8, 2.5}, {14, 13.5}, {2, 13.5}});
      painter.drawLine(QPointF(8, 6.5), QPointF(8, 9.5));
      painter.drawPoint(QPointF(8, 11.6));
      return;
    case Glyph::note:
      painter.drawEllipse(QRectF(2.5, 2.5, 11, 11));
      painter.drawLine(QPointF(8, 7.5), QPointF(8, 11));
      painter.drawPoint(QPointF(8, 5));
      return;
    case Glyph::sliders:
      for (const auto& [y, knob] : {std::pair{3.5, 10.0}, {8.0, 5.0}, {12.5, 9.0}}) {
        painter.drawLine(QPointF(2, y), QPointF(knob - 2, y));
        painter.drawEllipse(QPointF(knob, y), 1.6, 1.6);
        painter.drawLine(QPointF(knob + 2, y), QPointF(14, y));
      }
      return;
    case Glyph::curves: {
      QPainterPath curve;
      curve.moveTo(1.5, 13);
      curve.cubicTo(6, 13, 5.5, 3, 8, 3);
      curve.cubicTo(10.5, 3, 10, 13, 14.5, 13);
      painter.drawPath(curve);
      return;
    }
    case Glyph::blend:
      painter.drawEllipse(QRectF(1.5, 3.5, 9, 9));
      painter.drawEllipse(QRectF(5.5, 3.5, 9, 9));
      return;
    case Glyph::shown:
    case Glyph::hidden: {
      QPainterPath eye;
      eye.moveTo(1.5, 8);
      eye.cubicTo(4.5, 2.8, 11.5, 2.8, 14.5, 8);
      eye.cubicTo(11.5, 13.2, 4.5, 13.2, 1.5, 8);
      painter.drawPath(eye);
      if (glyph == Glyph::shown)
        painter.drawEllipse(QPointF(8, 8), 2, 2);
      else
        painter.drawLine(QPointF(3, 13), QPointF(13, 3));
      return;
    }
    case Glyph::pending:
      for (const double x : {4.0, 8.0, 12.0}) painter.drawPoint(QPointF(x, 8));
      return;
  }
}

class GlyphEngine final : public QIconEngine {
 public:
  explicit GlyphEngine(Glyph glyph) : m_glyph(glyph) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const QPalette palette = QGuiApplication::palette();
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    painter->save();
    painter->setPen(palette.color(group, QPalette::ButtonText));
    paintGlyph(*painter, m_glyph, rect);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap result(size);
    if (result.isNull()) return result;  // of a button without room: nothing can be painted
    result.fill(Qt::transparent);
    QPainter painter(&result);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return result;
  }

  QIconEngine* clone() const override { return new GlyphEngine(m_glyph); }

 private:
  Glyph m_glyph;
};

}  // namespace

void paintGlyph(QPainter& painter, Glyph glyph, const QRectF& rect) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(rect.topLeft());
  painter.scale(rect.width() / 16.0, rect.height() / 16.0);
  painter.setPen(QPen(painter.pen().color(), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  drawGlyph(painter, glyph);
  painter.restore();
}

QIcon glyphIcon(Glyph glyph) { return QIcon(new GlyphEngine(glyph)); }

QPixmap scaledPixmap(const QPixmap& pixmap, const QSize& size) {
  const QString key = QStringLiteral("scaled/%1/%2x%3").arg(pixmap.cacheKey()).arg(size.width()).arg(size.height());
  QPixmap result;
  if (!QPixmapCache::find(key, &result)) {
    result = pixmap.scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPixmapCache::insert(key, result);
  }
  return result;
}

}  // namespace gonio::widgets
