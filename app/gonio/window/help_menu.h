// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>

#include "app/gonio/window/command_search.h"

namespace gonio::app {

/// The Help menu and the command search.
class HelpMenu : public QMenu {
  Q_OBJECT

 public:
  /// @param window its actions are searched and listed. @param others returns further entries of the
  /// search.
  HelpMenu(QWidget* window, const std::function<std::vector<SearchEntry>()>& others);
};

}  // namespace gonio::app
