// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_banner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace gonio::widgets {

PreviewBanner::PreviewBanner(QWidget* viewport)
    : QFrame(viewport), m_text(new QLabel(this)), m_button(new QPushButton(this)) {
  setObjectName(QStringLiteral("previewBanner"));
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  m_text->setTextFormat(Qt::PlainText);
  m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 3, 3, 3);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_button);
  connect(m_button, &QPushButton::clicked, this, &PreviewBanner::dismissed);
  hide();
}

void PreviewBanner::showText(const QString& text, const QString& button) {
  m_whole = text;
  m_text->setToolTip(text);
  m_text->setMinimumWidth(0);
  m_text->setText(text);
  m_button->setText(button);
  setVisible(!text.isEmpty());
  elide();
}

QSize PreviewBanner::sizeHint() const {
  const QMargins margins = layout()->contentsMargins();
  const QSize button = m_button->sizeHint();
  return {fontMetrics().horizontalAdvance(m_whole) + button.width() + layout()->spacing() + margins.left() +
              margins.right() + 2 * frameWidth() + fontMetrics().averageCharWidth(),
          button.height() + margins.top() + margins.bottom() + 2 * frameWidth()};
}

void PreviewBanner::elide() {
  m_text->setText(fontMetrics().elidedText(m_whole, Qt::ElideMiddle, std::max(1, m_text->width())));
}

void PreviewBanner::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  elide();
}

}  // namespace gonio::widgets

#include "moc_preview_banner.cpp"
