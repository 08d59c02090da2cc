// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "core/factorization/pdv_factors.h"

namespace gonio::widgets {
class CurveEditor;
class ResidualStrip;
}  // namespace gonio::widgets

namespace gonio::app {

/// The factors of the model, by what they run over.
enum class FactorAxis { theta, deviation, phi };

const std::vector<double>& nodesOf(const factorization::PdvFactors& factors, FactorAxis axis);
std::vector<double>& curveOf(factorization::PdvTerm& term, FactorAxis axis);
const std::vector<double>& curveOf(const factorization::PdvTerm& term, FactorAxis axis);

/// What a button does to the curves of a factor.
enum class FactorOperation { stronger, weaker, wider, narrower, tiltUp, tiltDown, smooth, reset };

/// The factors with an operation on one axis, on all terms of a channel (or of all, -1). `reset` takes the curves of
/// `original` back where there are as many terms.
factorization::PdvFactors operated(const factorization::PdvFactors& factors, const factorization::PdvFactors& original,
                                   FactorAxis axis, FactorOperation operation, int channel);
QString operationText(FactorOperation operation, FactorAxis axis);

/// One factor: its curve editor, what its curves leave unexplained, the buttons of its operations, and a place where a
/// material's thumbnail can be dropped.
class FactorColumn : public QWidget {
  Q_OBJECT

 public:
  explicit FactorColumn(FactorAxis axis, QWidget* parent = nullptr);

  widgets::CurveEditor& editor() const { return *m_editor; }
  widgets::ResidualStrip& residuals() const { return *m_residuals; }
  FactorAxis axis() const { return m_axis; }
  void setButtonsEnabled(bool enabled);
  /// What the values of the curves are: shown beside the axis of F1, whose curves carry the strength.
  void setTransform(DataTransform transform);

 Q_SIGNALS:
  void operationChosen(gonio::app::FactorOperation operation);
  /// A material's thumbnail was dropped: an id as the library has it.
  void materialDropped(const QString& id);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  FactorAxis m_axis;
  DataTransform m_transform = DataTransform::logPlus;
  widgets::CurveEditor* m_editor;
  widgets::ResidualStrip* m_residuals;
  QWidget* m_buttons;
  QWidget* m_dropNote;
};

}  // namespace gonio::app
