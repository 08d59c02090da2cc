// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

namespace gonio::widgets {

/// The bar between two pictures: dragged with the mouse, moved with the arrow keys (Shift: finer), reset to the middle
/// by a double-click or Home. It covers a strip of its parent and adapts to the parent's size.
class SplitBar : public QWidget {
  Q_OBJECT

 public:
  explicit SplitBar(QWidget* parent);

  /// Fraction of the parent's width, [0, 1]. Emits nothing.
  void setPosition(double fraction);
  double position() const { return m_position; }

 Q_SIGNALS:
  void moved(double fraction);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void moveTo(double fraction);
  void place();

  double m_position = 0.5;
  double m_grip = 0;  ///< position of the mouse on the bar, pixels from its middle
};

}  // namespace gonio::widgets
