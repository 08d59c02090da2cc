// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QStringList>

#include "app/gonio/document/background_task.h"

namespace gonio::widgets {
class PreviewContent;
}

namespace gonio::app {

/// The environment that lights the preview.
class EnvironmentController : public QObject {
  Q_OBJECT

 public:
  EnvironmentController(BackgroundTasks& tasks, widgets::PreviewContent& preview, QObject* parent = nullptr);

  /// Reads a picture in the background and lights the preview with it; a bundled name ("studio", "sky") too; empty
  /// turns the environment off.
  void open(const QString& nameOrPath);
  /// The light of the scene itself, in this scene and all that follow.
  void openScenesOwn();
  bool isScenesOwn() const;
  /// What open() takes for the environment in use; empty for the directional light.
  QString name() const;
  /// Pictures that were opened before, the newest first; no bundled ones, and none that could not be found again.
  const QStringList& recent() const { return m_recent; }

 Q_SIGNALS:
  void recentChanged();
  void failed(const QString& title, const QString& text);

 private:
  void readRecent();
  void remember(const QString& path);

  BackgroundTasks& m_tasks;
  widgets::PreviewContent& m_preview;
  QStringList m_recent;
};

}  // namespace gonio::app
