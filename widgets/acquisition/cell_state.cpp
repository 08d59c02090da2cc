// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/acquisition/cell_state.h"

#include <QCoreApplication>

namespace gonio::widgets {

namespace {

struct CellStateText {
  Q_DECLARE_TR_FUNCTIONS(CellState)
};

Qt::BrushStyle hatching(CellState state) {
  switch (state) {
    case CellState::belowHorizon:
      return Qt::SolidPattern;
    case CellState::grazing:
      return Qt::BDiagPattern;
    case CellState::forbidden:
      return Qt::DiagCrossPattern;
    case CellState::unlearned:
      return Qt::Dense5Pattern;
    case CellState::measurable:
      break;
  }
  return Qt::NoBrush;
}

}  // namespace

QString stateName(CellState state) {
  switch (state) {
    case CellState::belowHorizon:
      return CellStateText::tr("below the horizon");
    case CellState::grazing:
      return CellStateText::tr("beyond the max. polar angle");
    case CellState::forbidden:
      return CellStateText::tr("unreachable by the rig");
    case CellState::unlearned:
      return CellStateText::tr("missing in some materials");
    case CellState::measurable:
      break;
  }
  return CellStateText::tr("measurable");
}

QBrush stateBrush(CellState state, const PlotStyle& style) {
  QColor colour = style.text;
  colour.setAlphaF(state == CellState::belowHorizon ? 0.28f : 0.6f);
  return QBrush(colour, hatching(state));
}

}  // namespace gonio::widgets
