// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/transform_text.h"

namespace gonio::app {

QString transformFormula(DataTransform transform) {
  switch (transform) {
    case DataTransform::logPlus:
      return QStringLiteral("ln(1 + ρ)");
    case DataTransform::cosineLog:
      return QStringLiteral("ln(1 + ρ max(cos θi cos θo, 0.001))");
    case DataTransform::root:
      return QStringLiteral("√ρ");
    default:
      return QStringLiteral("ρ");
  }
}

}  // namespace gonio::app
