// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/export_settings.h"

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QLabel>

namespace gonio::app {

QDoubleSpinBox* exportSnrField() {
  constexpr double smallest = 10, largest = 80;
  auto* field = new QDoubleSpinBox;
  field->setRange(smallest, largest);
  field->setDecimals(0);
  field->setSuffix(QCoreApplication::translate("export", " dB"));
  field->setKeyboardTracking(false);
  field->setToolTip(QCoreApplication::translate("export",
                                                "Rendered SNR that the files should reach; a higher value gives larger "
                                                "files, and some targets cannot reach it"));
  return field;
}

QLabel* exportText() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setMinimumWidth(1);  // a long name must not widen the dialog
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace gonio::app
