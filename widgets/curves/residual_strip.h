// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <vector>

namespace gonio::widgets {

class CurveEditor;

/// A low chart under a curve editor, on its axis: at each of the curve's nodes the fraction of the material that its
/// curves leave unexplained.
class ResidualStrip : public QWidget {
  Q_OBJECT

 public:
  /// @param editor lies above this widget, at the same width; must live on.
  explicit ResidualStrip(const CurveEditor& editor, QWidget* parent = nullptr);

  /// @param shares [0, infinity), one a node of the editor: above 1 where the curves are farther from the material than
  /// black is. None: nothing is known.
  void setShares(const std::vector<double>& fractions, const QString& title);
  const std::vector<double>& fractions() const { return m_shares; }
  /// The upper end of the scale: a round share above the largest, at most 1; what is larger is drawn as 1.
  double scale() const;

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const CurveEditor& m_editor;
  std::vector<double> m_shares;
  QString m_title;
};

}  // namespace gonio::widgets
