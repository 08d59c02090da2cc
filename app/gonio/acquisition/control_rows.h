// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Widgets for the rows of the Acquisition panel's form.
#pragma once

#include <QString>

class QComboBox;
class QLabel;

namespace gonio::widgets {
class NumberField;
}

namespace gonio::app {

QLabel* rowHeading(const QString& text);

/// A field that shows internal values multiplied by `factor`. Range and step are in internal units.
widgets::NumberField* rowField(const QString& name, const QString& toolTip, double minimum, double maximum, double step,
                               const QString& unit, double factor = 1);

/// A combo box for the narrow column, which truncates long names.
QComboBox* rowBox(const QString& toolTip);
/// Hides an item that cannot be selected yet.
void hideItem(QComboBox& box, int item, bool hidden);

}  // namespace gonio::app
