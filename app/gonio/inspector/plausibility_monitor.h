// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QTimer>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "core/editing/edit_energy.h"

namespace gonio::widgets {
class PlausibilityBadges;
}

namespace gonio::app {

/// Checks the edited material after each change and measures its energy before and after each edit, in the background.
/// Only the newest state is processed.
class PlausibilityMonitor : public QObject {
  Q_OBJECT

 public:
  PlausibilityMonitor(Document& document, BackgroundTasks& tasks, widgets::PlausibilityBadges& badges,
                      QObject* parent = nullptr);
  /// Whether the badges and the energies belong to the current state.
  bool isCurrent() const { return m_current; }
  /// The energies before the first edit and after each edit; empty while they are outdated.
  const std::vector<editing::Energy>& energies() const { return m_energies; }

 Q_SIGNALS:
  /// The energies became available or outdated.
  void energiesChanged();

 private:
  void changed();
  void check();

  Document& m_document;
  BackgroundTasks& m_tasks;
  widgets::PlausibilityBadges& m_badges;
  QTimer m_delay;
  bool m_current = true;
  std::vector<editing::Energy> m_energies;
};

}  // namespace gonio::app
