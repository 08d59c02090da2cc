// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <array>
#include <vector>

class QCustomPlot;
class QLabel;

namespace gonio::widgets {

struct PlotStyle;

/// The two curves of a factor measurement, one chart each, with a dot per reading and a line per channel: in the mirror
/// direction vs. angle ("along"), and at the fixed angle vs. distance from the mirror direction ("across").
class FactorCurves : public QWidget {
  Q_OBJECT

 public:
  using Channels = std::array<std::vector<double>, 3>;  ///< red, green, blue
  struct Content {
    std::vector<double> angles;  ///< degrees
    std::vector<double> distances;
    Channels along, across;  ///< one value per angle and per distance
    QString angleTitle, distanceTitle;
  };

  explicit FactorCurves(QWidget* parent = nullptr);

  void setContent(Content content);
  const Content& content() const { return m_content; }
  /// Shown in the middle while there are no curves.
  void setHint(const QString& hint);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void draw(QCustomPlot& chart, const std::vector<double>& places, const Channels& curves,
            const PlotStyle& style) const;

  Content m_content;
  QCustomPlot *m_along, *m_across;
  QLabel* m_hint;
};

}  // namespace gonio::widgets
