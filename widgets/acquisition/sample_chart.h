// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <vector>

#include "core/coordinates/half_difference.h"

namespace gonio::widgets {

/// The angles of a sample as one line of text:
/// "7: light θi 31.2°, φi 0.0° · viewer θo ..., φo ... · θh ..., θd ..., φd ...".
QString sampleText(int number, const DirectionPair& directions);

/// A drawing of the pairs of directions at which a material is measured, numbered from 1 in their order. Pointer and
/// arrow keys move the mark from sample to sample; the owner of several charts synchronises their marks.
class SampleChart : public QWidget {
  Q_OBJECT

 public:
  explicit SampleChart(QWidget* parent = nullptr);

  /// The mark stays if the sample still exists.
  void setSamples(std::vector<DirectionPair> samples);
  const std::vector<DirectionPair>& samples() const { return m_samples; }
  /// The sample that is marked, from 0; -1: none.
  void setCurrent(int sample);
  int current() const { return m_current; }
  /// Shown in the middle while there are no samples.
  void setHint(const QString& hint);

  /// Positions of a sample's dots, in widget pixels.
  virtual QList<QPointF> places(int sample) const = 0;
  /// The sample with the dot nearest to a position; -1 if none is close.
  int sampleAt(const QPointF& place) const;

  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// The pointer or the keys moved the mark.
  void currentChanged(int sample);
  /// The user clicked a sample, or pressed Enter on the marked one.
  void chosen(int sample);

 protected:
  /// Tooltip of a sample.
  virtual QString toolTipOf(int sample) const;
  /// Draws numbers beside the first dot of each sample where they do not overlap dots, other numbers or `taken`
  /// rectangles; the number of the marked sample is always drawn.
  void drawNumbers(QPainter& painter, std::vector<QRectF> taken = {}) const;
  static void drawCentred(QPainter& painter, const QPointF& at, const QString& text);
  /// Draws the hint if there are no samples.
  void drawHint(QPainter& painter, const QRectF& within) const;
  /// Frame around the focused chart.
  void drawFocus(QPainter& painter) const;

  bool event(QEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void moveTo(int sample);
  void drawNumber(QPainter& painter, int sample, std::vector<QRectF>& taken) const;

  std::vector<DirectionPair> m_samples;
  int m_current = -1;
  QString m_hint;
};

}  // namespace gonio::widgets
