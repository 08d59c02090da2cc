// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/control_rows.h"

#include <QComboBox>
#include <QLabel>
#include <QListView>

#include "widgets/inputs/number_field.h"

namespace gonio::app {

QLabel* rowHeading(const QString& text) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  label->setContentsMargins(0, 6, 0, 0);
  return label;
}

widgets::NumberField* rowField(const QString& name, const QString& toolTip, double minimum, double maximum, double step,
                               const QString& unit, double factor) {
  auto* number = new widgets::NumberField;
  number->setRange(minimum, maximum);
  number->setStep(step);
  number->setUnit(unit, factor);
  number->setAccessibleName(name);
  number->setToolTip(toolTip);
  number->setFixedWidth(6 * number->fontMetrics().height());
  return number;
}

QComboBox* rowBox(const QString& toolTip) {
  auto* box = new QComboBox;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  box->setToolTip(toolTip);
  return box;
}

void hideItem(QComboBox& box, int item, bool hidden) {
  static_cast<QListView*>(box.view())->setRowHidden(item, hidden);
}

}  // namespace gonio::app
