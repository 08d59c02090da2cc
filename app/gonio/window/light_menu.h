// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>

class QActionGroup;

namespace gonio::widgets {
class PreviewContent;
}

namespace gonio::app {

class EnvironmentController;

/// View > Light: the environment of the preview.
class LightMenu : public QMenu {
  Q_OBJECT

 public:
  LightMenu(EnvironmentController& environment, widgets::PreviewContent& preview, QWidget* window);

  /// Asks for a picture and lights the preview with it.
  void askForFile();

 private:
  void add(const QString& text, const QString& name, const QKeySequence& key = {});
  void addOwn();
  void showRecent();
  void addBackground();

  EnvironmentController& m_environment;
  widgets::PreviewContent& m_preview;
  QActionGroup* m_group;
  QList<QAction*> m_recent;
  QAction* m_afterRecent = nullptr;
};

}  // namespace gonio::app
