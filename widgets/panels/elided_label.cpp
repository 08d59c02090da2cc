// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/elided_label.h"

#include <QPainter>
#include <QStyle>

namespace gonio::widgets {

QSize ElidedLabel::minimumSizeHint() const {
  constexpr int characters = 8;
  return {fontMetrics().averageCharWidth() * characters, QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  style()->drawItemText(&painter, contentsRect(), int(alignment()), palette(), isEnabled(),
                        fontMetrics().elidedText(text(), m_mode, contentsRect().width()), foregroundRole());
}

}  // namespace gonio::widgets
