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

  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace gonio::widgets
