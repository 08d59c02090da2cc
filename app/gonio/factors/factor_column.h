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

/// The factors of the PDV model, by their argument.
enum class FactorAxis { theta, deviation, phi };

const std::vector<double>& nodesOf(const factorization::PdvFactors& factors, FactorAxis axis);
std::vector<double>& curveOf(factorization::PdvTerm& term, FactorAxis axis);
const std::vector<double>& curveOf(const factorization::PdvTerm& term, FactorAxis axis);

/// The operations on the curves of a factor that have buttons.
enum class FactorOperation { stronger, weaker, wider, narrower, tiltUp, tiltDown, smooth, reset };

/// Applies an operation to the curves of one axis, for all terms of a channel (-1: of all channels). `reset` restores
/// the curves of `original`, if it has as many terms.
factorization::PdvFactors operated(const factorization::PdvFactors& factors, const factorization::PdvFactors& original,
                                   FactorAxis axis, FactorOperation operation, int channel);
QString operationText(FactorOperation operation, FactorAxis axis);

/// One factor: its curve editor, the residuals along its axis, buttons for its operations, and a drop area for a
/// material's thumbnail.
class FactorColumn : public QWidget {
  Q_OBJECT

 public:
  explicit FactorColumn(FactorAxis axis, QWidget* parent = nullptr);

  widgets::CurveEditor& editor() const { return *m_editor; }
  widgets::ResidualStrip& residuals() const { return *m_residuals; }
  FactorAxis axis() const { return m_axis; }
  void setButtonsEnabled(bool enabled);
  /// Sets the transform of the values. Only the axis of F1 shows it, because F2 and F3 are relative to F1.
  void setTransform(DataTransform transform);

 Q_SIGNALS:
  void operationChosen(gonio::app::FactorOperation operation);
  /// A material's thumbnail was dropped. @param id as in the library.
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
