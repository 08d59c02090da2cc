// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

namespace gonio::widgets {

/// Small spheres of blends, one row per space and one column per step, to compare spaces. A click, or Enter on the cell
/// selected by the arrow keys, requests that space at that step.
class BlendStrip : public QWidget {
  Q_OBJECT

 public:
  struct Row {
    QString name;
    QString toolTip;
    std::vector<QImage> pictures;  ///< one per step; null: pending
    QString note = {};             ///< why there are no pictures: "waiting", "cancelled", or an error
    bool failed = false;
  };

  explicit BlendStrip(QWidget* parent = nullptr);

  /// @param steps labels of the columns, e.g. "0", "1/6"
  void setSteps(const QStringList& steps);
  void setRows(std::vector<Row> rows);
  void setRow(int row, Row content);
  const std::vector<Row>& rows() const { return m_rows; }
  /// Marks the row of the current space.
  void setCurrentRow(int row);
  int currentRow() const { return m_currentRow; }
  /// Marks a position along the columns, in [0, 1]; negative: none.
  void setMark(double fraction);
  /// Shown while there are no rows.
  void setEmptyText(const QString& text);
  QRectF cell(int row, int step) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void chosen(int row, int step);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  struct Cell {
    int row, step;
  };
  double side() const;
  double labelWidth() const;
  double headerHeight() const;
  QRectF rowArea(int row) const;
  void updateRow(int row);
  Cell cellAt(const QPointF& position) const;
  void drawRow(QPainter& painter, int row) const;
  void drawSteps(QPainter& painter) const;
  void moveCursor(int rows, int steps);

  QStringList m_steps;
  std::vector<Row> m_rows;
  QString m_emptyText;
  int m_currentRow = 0;
  double m_mark = -1;
  Cell m_cursor{0, 0};
};

}  // namespace gonio::widgets
