// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/scene/environment_controller.h"

#include <QFileInfo>
#include <QSettings>

#include "core/rendering/environment.h"
#include "widgets/preview/gl/textures.h"
#include "widgets/preview/preview_content.h"

namespace gonio::app {

namespace {
const QString recentKey = QStringLiteral("environments/recent");
constexpr int maxRecent = 6;
}  // namespace

EnvironmentController::EnvironmentController(BackgroundTasks& tasks, widgets::PreviewContent& preview, QObject* parent)
    : QObject(parent), m_tasks(tasks), m_preview(preview) {
  readRecent();
}

QString EnvironmentController::name() const {
  const auto& environment = m_preview.scene().environment;
  return environment ? QString::fromStdString(environment->name()) : QString();
}

void EnvironmentController::useSceneEnvironment() { m_preview.resetEnvironment(); }

bool EnvironmentController::isFromScene() const { return !m_preview.isEnvironmentChosen(); }

void EnvironmentController::readRecent() {
  m_recent = QSettings().value(recentKey).toStringList();
  m_recent.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
}

void EnvironmentController::remember(const QString& path) {
  if (!QFileInfo::exists(path)) return;  // bundled
  const QString whole = QFileInfo(path).absoluteFilePath();
  readRecent();  // other windows have opened some too
  m_recent.removeAll(whole);
  m_recent.prepend(whole);
  m_recent = m_recent.mid(0, maxRecent);
  QSettings().setValue(recentKey, m_recent);
  Q_EMIT recentChanged();
}

void EnvironmentController::open(const QString& nameOrPath) {
  m_tasks.run<std::shared_ptr<const rendering::EnvironmentMap>>(
      {tr("Reading the environment %1").arg(nameOrPath.section('/', -1)), QStringLiteral("environment")},
      [nameOrPath](const TaskControl&) -> std::shared_ptr<const rendering::EnvironmentMap> {
        if (nameOrPath.isEmpty()) return nullptr;
        const auto environment = rendering::openEnvironment(nameOrPath.toStdString());
        widgets::environmentTexels(environment);  // so that the preview need not wait for them
        return environment;
      },
      [this, nameOrPath](const std::shared_ptr<const rendering::EnvironmentMap>& environment) {
        m_preview.setEnvironment(environment);
        remember(nameOrPath);
        if (!environment) return;
        for (const std::string& note : environment->notes())
          Q_EMIT warned(nameOrPath.section('/', -1) + QStringLiteral(": ") + QString::fromStdString(note));
      },
      [this](const QString& error) {
        readRecent();
        Q_EMIT recentChanged();
        Q_EMIT failed(tr("Cannot read the environment"), error);
      });
}

}  // namespace gonio::app

#include "moc_environment_controller.cpp"
