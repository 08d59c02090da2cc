// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/document/loaded_material.h"
#include "core/factorization/pdv_samples.h"

class QLabel;
class QSlider;

namespace gonio::app {

/// The factors of a material with the error and cost of each number of terms.
struct FactorsWithCosts {
  /// Options selected before the factorisation; the number of terms is selected afterwards.
  struct Kind {
    factorization::PdvForm form = factorization::PdvForm::twoFactors;
    DataTransform transform = DataTransform::logPlus;
    bool operator==(const Kind&) const = default;
  };
  LoadedMaterialPtr material;
  factorization::PdvFactorization factorization;
  // For each number of terms; index 0: one term.
  std::vector<factorization::PdvResidualsAlong> along;  ///< residuals at each node
  std::vector<std::size_t> bytes;                       ///< size of a file with the factors
  std::vector<double> nanoseconds;  ///< per evaluation on one core, median of several runs on this machine

  /// Relative residual |y - y^| / |y| with this number of terms, in the weighted norm of the factorisation; y is the
  /// transformed BRDF, y^ its approximation. In [0, 1].
  double residual(int terms) const { return factorization.residuals[std::size_t(terms)]; }
};

inline constexpr int maxEditedTerms = 10;

/// Factorises and measures the costs; takes a few seconds for three factors. @throws Cancelled.
FactorsWithCosts factorizeWithCosts(const LoadedMaterialPtr& material, const FactorsWithCosts::Kind& kind,
                                    const TaskControl& control = {});

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
