// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/factors/factor_column.h"

#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>
#include <vector>

#include "app/gonio/document/material_code.h"
#include "core/factorization/pdv_operations.h"
#include "widgets/curves/curve_editor.h"
#include "widgets/curves/residual_strip.h"
#include "widgets/inputs/flow_layout.h"
#include "widgets/library/material_drag.h"

namespace gonio::app {

namespace {

using factorization::PdvFactors;
using factorization::PdvTerm;

constexpr double step = 1.1, tiltStep = 0.1, smoothRadius = 1.5;

struct FactorColumnText {
  Q_DECLARE_TR_FUNCTIONS(FactorColumn)
};

QString transformedValue(DataTransform transform) {
  if (transform == DataTransform::none) return FactorColumnText::tr("ρ [1/sr]");
  return FactorColumnText::tr("%1, ρ in 1/sr").arg(transformFormula(transform));
}

widgets::CurveAxis chartAxis(FactorAxis axis, DataTransform transform) {
  switch (axis) {
    case FactorAxis::theta:
      return {.title = FactorColumnText::tr("F1: specular strength vs. angle"),
              .label = FactorColumnText::tr("angle of the mirror direction [°]"),
              .symbol = FactorColumnText::tr("angle"),
              .suffix = FactorColumnText::tr("°"),
              .valueLabel = transformedValue(transform),
              .unit = radians(1),
              .tick = 15};
    case FactorAxis::deviation:
      return {.title = FactorColumnText::tr("F2: highlight profile"),
              .label = FactorColumnText::tr("distance from the mirror direction"),
              .symbol = FactorColumnText::tr("distance"),
              .valueLabel = FactorColumnText::tr("fraction of F1"),
              .help = FactorColumnText::tr("Dotted lines: distances from the mirror direction to the nearest and the "
                                           "farthest point of the horizon (near and far horizon),\n"
                                           "for the angle under the pointer in F1."),
              .tick = 0.25,
              .squareRoot = true};
    default:
      return {.title = FactorColumnText::tr("F3: azimuthal variation"),
              .label = FactorColumnText::tr("|φ|, azimuth about the mirror direction, degrees: 0 towards the viewer"),
              .symbol = FactorColumnText::tr("|φ|"),
              .suffix = FactorColumnText::tr("°"),
              .valueLabel = FactorColumnText::tr("fraction of F1"),
              .unit = radians(1),
              .tick = 30};
  }
}

std::vector<double> operated(const std::vector<double>& nodes, const std::vector<double>& curve,
                             FactorOperation operation) {
  using namespace factorization;
  switch (operation) {
    case FactorOperation::stronger:
      return scaled(curve, step);
    case FactorOperation::weaker:
      return scaled(curve, 1 / step);
    case FactorOperation::wider:
      return widened(nodes, curve, step);
    case FactorOperation::narrower:
      return widened(nodes, curve, 1 / step);
    case FactorOperation::tiltUp:
      return tilted(nodes, curve, tiltStep);
    case FactorOperation::tiltDown:
      return tilted(nodes, curve, -tiltStep);
    case FactorOperation::smooth:
      return smoothed(curve, smoothRadius);
    default:
      return curve;
  }
}

struct Button {
  FactorOperation operation;
  const char *text, *toolTip;
};
constexpr Button buttons[] = {
    {FactorOperation::wider, QT_TRANSLATE_NOOP("FactorColumn", "Wider"),
     QT_TRANSLATE_NOOP("FactorColumn", "Stretches the curves of all terms along the axis to 1.1 times their width")},
    {FactorOperation::narrower, QT_TRANSLATE_NOOP("FactorColumn", "Narrower"),
     QT_TRANSLATE_NOOP("FactorColumn", "Shrinks the curves of all terms along the axis to 1 / 1.1 of their width")},
    {FactorOperation::stronger, QT_TRANSLATE_NOOP("FactorColumn", "Stronger"),
     QT_TRANSLATE_NOOP("FactorColumn", "Scales the curves of all terms by 1.1")},
    {FactorOperation::weaker, QT_TRANSLATE_NOOP("FactorColumn", "Weaker"),
     QT_TRANSLATE_NOOP("FactorColumn", "Scales the curves of all terms by 1 / 1.1")},
    {FactorOperation::tiltUp, QT_TRANSLATE_NOOP("FactorColumn", "Tilt up"),
     QT_TRANSLATE_NOOP(
         "FactorColumn",
         "Tilts the curves of all terms about their midpoint: −10 % at the left end, +10 % at the right")},
    {FactorOperation::tiltDown, QT_TRANSLATE_NOOP("FactorColumn", "Tilt down"),
     QT_TRANSLATE_NOOP(
         "FactorColumn",
         "Tilts the curves of all terms about their midpoint: +10 % at the left end, −10 % at the right")},
    {FactorOperation::smooth, QT_TRANSLATE_NOOP("FactorColumn", "Smooth"),
     QT_TRANSLATE_NOOP("FactorColumn", "Averages neighbouring nodes of the curves of all terms")},
    {FactorOperation::reset, QT_TRANSLATE_NOOP("FactorColumn", "Reset"),
     QT_TRANSLATE_NOOP("FactorColumn", "Restores the curves of all terms to those of the measurement")}};

}  // namespace

const std::vector<double>& nodesOf(const PdvFactors& f, FactorAxis axis) {
  return axis == FactorAxis::theta ? f.thetaNodes : axis == FactorAxis::deviation ? f.deviationNodes : f.phiNodes;
}
std::vector<double>& curveOf(PdvTerm& term, FactorAxis axis) {
  return axis == FactorAxis::theta ? term.f1 : axis == FactorAxis::deviation ? term.f2 : term.f3;
}
const std::vector<double>& curveOf(const PdvTerm& term, FactorAxis axis) {
  return curveOf(const_cast<PdvTerm&>(term), axis);
}

PdvFactors operated(const PdvFactors& factors, const PdvFactors& original, FactorAxis axis, FactorOperation operation,
                    int channel) {
  PdvFactors result = factors;
  for (std::size_t c = 0; c < 3; ++c) {
    if (channel >= 0 && channel != int(c)) continue;
    for (std::size_t i = 0; i < result.channels[c].size(); ++i) {
      std::vector<double>& curve = curveOf(result.channels[c][i], axis);
      if (operation != FactorOperation::reset)
        curve = operated(nodesOf(factors, axis), curve, operation);
      else if (i < original.channels[c].size())
        curve = curveOf(original.channels[c][i], axis);
    }
  }
  return factorization::withRoomForEdits(result);
}

QString operationText(FactorOperation operation, FactorAxis axis) {
  for (const Button& button : buttons)
    if (button.operation == operation)
      return QStringLiteral("F%1: %2").arg(int(axis) + 1).arg(FactorColumnText::tr(button.text));
  return {};
}

FactorColumn::FactorColumn(FactorAxis axis, QWidget* parent)
    : QWidget(parent),
      m_axis(axis),
      m_editor(new widgets::CurveEditor),
      m_residuals(new widgets::ResidualStrip(*m_editor)),
      m_buttons(new QWidget) {
  m_editor->setAxis(chartAxis(axis, m_transform));
  auto* row = new widgets::FlowLayout(m_buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  std::vector<QToolButton*> widening;
  for (const Button& one : buttons) {
    auto* button = new QToolButton;
    button->setText(FactorColumnText::tr(one.text));
    if (axis != FactorAxis::deviation &&
        (one.operation == FactorOperation::wider || one.operation == FactorOperation::narrower)) {
      widening.push_back(button);
      continue;
    }
    button->setToolTip(FactorColumnText::tr(one.toolTip));
    button->setAutoRepeat(one.operation != FactorOperation::reset);
    button->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this,
            [this, operation = one.operation] { Q_EMIT operationChosen(operation); });
  }
  // Only F2 has these; the others leave their room, so that all charts have the same height.
  for (QToolButton* button : widening) {
    QSizePolicy policy = button->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    button->setSizePolicy(policy);
    row->addWidget(button);
    button->hide();
  }
  auto* note = new QLabel(axis == FactorAxis::theta ? FactorColumnText::tr("Use F1 of This Material")
                                                    : FactorColumnText::tr("Use F2 of This Material"),
                          this);
  note->setAlignment(Qt::AlignCenter);
  note->setAutoFillBackground(true);
  note->setFrameShape(QFrame::Box);
  note->hide();
  m_dropNote = note;
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3, 3, 3, 3);
  layout->setSpacing(3);
  layout->addWidget(m_editor, 1);
  layout->addWidget(m_residuals);
  layout->addWidget(m_buttons);
  // F3 has no meaning of its own that another material could lend.
  setAcceptDrops(axis != FactorAxis::phi);
}

void FactorColumn::setButtonsEnabled(bool enabled) { m_buttons->setEnabled(enabled); }

void FactorColumn::setTransform(DataTransform transform) {
  if (transform == m_transform) return;
  m_transform = transform;
  m_editor->setAxis(chartAxis(m_axis, transform));
}

void FactorColumn::dragEnterEvent(QDragEnterEvent* event) {
  if (m_editor->nodes().empty() || widgets::draggedMaterial(event->mimeData()).isEmpty()) return;
  const int line = fontMetrics().height();
  m_dropNote->setGeometry(line, height() / 2 - line, width() - 2 * line, 2 * line);
  m_dropNote->raise();
  m_dropNote->show();
  update();
  event->acceptProposedAction();
}

void FactorColumn::dragLeaveEvent(QDragLeaveEvent*) {
  m_dropNote->hide();
  update();
}

void FactorColumn::dropEvent(QDropEvent* event) {
  m_dropNote->hide();
  update();
  event->acceptProposedAction();
  Q_EMIT materialDropped(widgets::draggedMaterial(event->mimeData()));
}

void FactorColumn::paintEvent(QPaintEvent* event) {
  QWidget::paintEvent(event);
  if (m_dropNote->isHidden()) return;
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 3));
  painter.drawRect(rect().adjusted(1, 1, -2, -2));
}

}  // namespace gonio::app

#include "moc_factor_column.cpp"
