// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <vector>

namespace gonio::widgets {

class CurveEditor;

/// A low chart below a curve editor, with the same axis: the relative residual of the factors at each node of the
/// curve.
class ResidualStrip : public QWidget {
  Q_OBJECT

 public:
  /// @param editor above this widget, with the same width; must outlive it.
  explicit ResidualStrip(const CurveEditor& editor, QWidget* parent = nullptr);

  /// @param fractions relative residuals >= 0, one per node of the editor; above 1 if the curves approximate the
  /// material worse than 0 would. Empty: unknown.
  void setFractions(const std::vector<double>& fractions, const QString& title);
  const std::vector<double>& fractions() const { return m_fractions; }
  /// The upper end of the scale: a round number above the largest residual, at most 1; larger residuals are drawn as 1.
  double scale() const;

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const CurveEditor& m_editor;
  std::vector<double> m_fractions;
  QString m_title;
};

}  // namespace gonio::widgets
