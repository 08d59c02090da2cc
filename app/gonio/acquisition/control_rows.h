// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// What the rows of the Acquisition panel's form are made of.
#pragma once

#include <QString>

class QComboBox;
class QLabel;

namespace gonio::widgets {
class NumberField;
}

namespace gonio::app {

QLabel* rowHeading(const QString& text);

/// A number in a unit of `factor` per internal unit; the range and the step are internal.
widgets::NumberField* rowField(const QString& name, const QString& toolTip, double least, double most, double step,
                               const QString& unit, double factor = 1);

/// The column is narrow: long names are cut, not the boxes.
QComboBox* rowBox(const QString& toolTip);
/// An item that stands for nothing yet is not offered.
void hideItem(QComboBox& box, int item, bool hidden);

}  // namespace gonio::app
