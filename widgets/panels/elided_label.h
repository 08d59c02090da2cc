// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QLabel>

namespace gonio::widgets {

/// A label with one line of plain text, shortened by an ellipsis if it does not fit. It sets no tooltip.
class ElidedLabel : public QLabel {
 public:
  using QLabel::QLabel;

  /// Where text that is too long is cut; at its end by default.
  void setElideMode(Qt::TextElideMode mode) { m_mode = mode; }
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Qt::TextElideMode m_mode = Qt::ElideRight;
};

}  // namespace gonio::widgets
