// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <algorithm>

namespace gonio::widgets {

namespace {

QString fileOf(const QString& name) { return QStringLiteral(":/icons/%1.svg").arg(name); }

class IconEngine final : public QIconEngine {
 public:
  explicit IconEngine(QString name) : m_name(std::move(name)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const QPalette palette = QGuiApplication::palette();
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    painter->save();
    painter->setPen(palette.color(group, mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText));
    paintIcon(*painter, m_name, rect);
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

  QIconEngine* clone() const override { return new IconEngine(m_name); }

 private:
  QString m_name;
};

}  // namespace

bool hasIcon(const QString& name) { return QFile::exists(fileOf(name)); }

void paintIcon(QPainter& painter, const QString& name, const QRectF& rect) {
  QFile file(fileOf(name));
  const bool opened = file.open(QIODevice::ReadOnly);
  Q_ASSERT_X(opened, "paintIcon", qPrintable(file.fileName()));
  if (!opened) return;
  // Qt's renderer does not know the keyword, and draws no colour with an opacity of its own.
  const QColor colour = painter.pen().color();
  QSvgRenderer renderer(file.readAll().replace("currentColor", colour.name().toLatin1()));
  const double side = std::min(rect.width(), rect.height());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(painter.opacity() * colour.alphaF());
  renderer.render(&painter, QRectF(rect.center() - QPointF(side, side) / 2, QSizeF(side, side)));
  painter.restore();
}

QIcon themedIcon(const QString& name) {
  Q_ASSERT_X(hasIcon(name), "themedIcon", qPrintable(name));
  return QIcon(new IconEngine(name));
}

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
