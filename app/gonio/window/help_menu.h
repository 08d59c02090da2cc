// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>

namespace gonio::app {

/// The Help menu and the command search.
class HelpMenu : public QMenu {
  Q_OBJECT

 public:
  /// @param window whose actions are searched and listed.
  explicit HelpMenu(QWidget* window);
};

}  // namespace gonio::app
