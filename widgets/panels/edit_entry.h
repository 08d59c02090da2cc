// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

namespace gonio::widgets {

/// One edit of a stack, for display.
struct EditEntry {
  QString name;  ///< shown
  QString toolTip = {};
  double strength = 1;  ///< [0, 1]
  bool enabled = true;
  QString ownName = {};  ///< name given by the user, the initial text of renaming
  QString effect = {};   ///< measured effect, a line below the strength; empty: none

  bool operator==(const EditEntry&) const = default;
};

}  // namespace gonio::widgets
