// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QLabel>

namespace gonio::widgets {

/// A label of one line of plain text that ends in an ellipsis where it has too little room; the tooltip shows the
/// whole.
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
