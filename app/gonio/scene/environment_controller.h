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

  /// Reads an environment in the background and lights the preview with it: a picture file or a bundled name ("studio",
  /// "sky"); empty: turns the environment off.
  void open(const QString& nameOrPath);
  /// Uses the scene's own light in this and all later scenes.
  void useSceneEnvironment();
  bool isFromScene() const;
  /// Name or path of the current environment, as for open(); empty: the distant light.
  QString name() const;
  /// Previously opened pictures, newest first, without bundled ones and without missing files.
  const QStringList& recent() const { return m_recent; }

 Q_SIGNALS:
  void recentChanged();
  void failed(const QString& title, const QString& text);
  /// What the reader changed or found unusual.
  void warned(const QString& text);

 private:
  void readRecent();
  void remember(const QString& path);

  BackgroundTasks& m_tasks;
  widgets::PreviewContent& m_preview;
  QStringList m_recent;
};

}  // namespace gonio::app
