// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

namespace gonio::app {

class MainWindow;

/// The Help menu and the command search.
class HelpMenu : public QObject {
  Q_OBJECT

 public:
  explicit HelpMenu(MainWindow& window);
};

}  // namespace gonio::app
