// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QTimer>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"

namespace gonio::widgets {
class PlausibilityBadges;
}

namespace gonio::app {

/// Checks the edited material after each change, in the background; the newest state wins.
class PlausibilityMonitor : public QObject {
  Q_OBJECT

 public:
  PlausibilityMonitor(Document& document, BackgroundTasks& tasks, widgets::PlausibilityBadges& badges,
                      QObject* parent = nullptr);
  /// Whether the badges tell of the present state.
  bool isCurrent() const { return m_current; }

 private:
  void changed();
  void check();

  Document& m_document;
  BackgroundTasks& m_tasks;
  widgets::PlausibilityBadges& m_badges;
  QTimer m_delay;
  bool m_current = true;
};

}  // namespace gonio::app
