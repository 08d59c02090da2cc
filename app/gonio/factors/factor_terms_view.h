// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/factors/measured_factors.h"

class QLabel;
class QSlider;

namespace gonio::app {

/// How many terms of factors are used, beside what each count costs: the measured error over the terms as a chart, a
/// slider below it, the numbers of the chosen count in words.
class FactorTermsView : public QWidget {
  Q_OBJECT

 public:
  explicit FactorTermsView(QWidget* parent = nullptr);

  /// Null: nothing is known.
  void setMeasured(std::shared_ptr<const MeasuredFactors> measured);
  void setTerms(int terms);
  int terms() const;

 Q_SIGNALS:
  void termsChosen(int terms);

 private:
  class Chart;
  void refresh();

  std::shared_ptr<const MeasuredFactors> m_measured;
  Chart* m_chart;
  QSlider* m_slider;
  QLabel* m_text;
};

}  // namespace gonio::app
