// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

namespace gonio::widgets {

/// One edit of a stack, for people.
struct EditEntry {
  QString name;  ///< shown
  QString toolTip = {};
  double strength = 1;  ///< [0, 1]
  bool enabled = true;
  QString ownName = {};  ///< that the user gave it: what renaming starts from
  QString effect = {};   ///< measured: a line below the strength; empty: none

  bool operator==(const EditEntry&) const = default;
};

}  // namespace gonio::widgets
