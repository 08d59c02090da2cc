// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/factors/factors_with_costs.h"

class QLabel;
class QSlider;

namespace gonio::app {

/// Choice of the number of terms: a chart of the measured error over the number of terms, a slider below it, and the
/// costs of the selected number as text.
class FactorTermsView : public QWidget {
  Q_OBJECT

 public:
  explicit FactorTermsView(QWidget* parent = nullptr);

  /// @param measured null if the factors are not known.
  void setMeasured(std::shared_ptr<const FactorsWithCosts> measured);
  void setTerms(int terms);
  int terms() const;

 Q_SIGNALS:
  void termsChosen(int terms);

 private:
  class Chart;
  void refresh();

  std::shared_ptr<const FactorsWithCosts> m_measured;
  Chart* m_chart;
  QSlider* m_slider;
  QLabel* m_text;
};

}  // namespace gonio::app
