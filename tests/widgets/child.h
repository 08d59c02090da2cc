// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QLabel>
#include <QWidget>

#include "widgets/inputs/menu_text.h"

namespace gonio::test {

/// The first widget of a type in `parent` that a user would call `name`: by its accessible name, the text on it, or the
/// text of its label; marks of keys do not count. Null if there is none.
template <class Widget>
Widget* child(const QWidget& parent, const QString& name) {
  const auto reads = [&](const QString& text) { return widgets::withoutKeyMarks(text) == name; };
  for (Widget* one : parent.findChildren<Widget*>())
    if (one->accessibleName() == name || reads(one->property("text").toString())) return one;
  for (const QLabel* label : parent.findChildren<QLabel*>())
    if (auto* one = qobject_cast<Widget*>(label->buddy()); one && reads(label->text())) return one;
  return nullptr;
}

}  // namespace gonio::test
