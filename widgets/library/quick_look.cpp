// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/quick_look.h"

#include <QLabel>
#include <QPixmap>
#include <QVBoxLayout>

namespace gonio::widgets {

namespace {
constexpr int windowGap = 8;
}

QuickLook::QuickLook(QWidget* library)
    : QFrame(library, Qt::ToolTip), m_picture(new QLabel(this)), m_text(new QLabel(this)) {
  setAttribute(Qt::WA_ShowWithoutActivating);
  setFrameShape(QFrame::StyledPanel);
  m_picture->setFixedSize(side, side);
  m_picture->setAlignment(Qt::AlignCenter);
  m_text->setWordWrap(true);
  m_text->setTextFormat(Qt::RichText);
  m_text->setFixedWidth(side);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_picture);
  layout->addWidget(m_text);
}

void QuickLook::showMaterial(const QString& id, const QString& text, const QImage& picture) {
  m_id = id;
  m_text->setText(text);
  setPicture(id, picture);
  adjustSize();
  const QWidget& library = *parentWidget();
  move(library.mapToGlobal(QPoint(library.width() + windowGap, windowGap)));
  show();
}

void QuickLook::setPicture(const QString& id, const QImage& picture) {
  if (id != m_id) return;
  QPixmap pixmap = QPixmap::fromImage(picture);
  const double ratio = devicePixelRatioF();
  if (!pixmap.isNull())
    pixmap = pixmap.scaled(QSize(side, side) * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  pixmap.setDevicePixelRatio(ratio);
  m_picture->setPixmap(pixmap);
}

void QuickLook::mousePressEvent(QMouseEvent*) { hide(); }

}  // namespace gonio::widgets

#include "moc_quick_look.cpp"
