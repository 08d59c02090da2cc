// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

namespace gonio::app {

class MainWindow;

/// The Material menu: fits, and stopping work.
class MaterialMenu : public QObject {
  Q_OBJECT

 public:
  explicit MaterialMenu(MainWindow& window);
};

}  // namespace gonio::app
