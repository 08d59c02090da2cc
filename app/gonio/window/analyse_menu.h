// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

class QMenu;

namespace gonio::app {

class MainWindow;

/// The Analyse menu: comparisons.
class AnalyseMenu : public QObject {
  Q_OBJECT

 public:
  explicit AnalyseMenu(MainWindow& window);

 private:
  void addModes(QMenu* menu);
  void chooseReference();

  MainWindow& m_window;
};

}  // namespace gonio::app
