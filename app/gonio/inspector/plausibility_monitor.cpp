// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/plausibility_monitor.h"

#include "core/editing/edit_plausibility.h"
#include "widgets/panels/plausibility_badges.h"

namespace gonio::app {

namespace {
const QString plausibilityKey = QStringLiteral("plausibility");
/// After the last change: a slider that moves is not slowed down by checks of every step.
constexpr int checkDelayMilliseconds = 120;

struct Findings {
  std::vector<metrics::PlausibilityCheck> checks;
  std::vector<editing::Energy> energies;
};
}  // namespace

PlausibilityMonitor::PlausibilityMonitor(Document& document, BackgroundTasks& tasks,
                                         widgets::PlausibilityBadges& badges, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks), m_badges(badges) {
  m_delay.setSingleShot(true);
  m_delay.setInterval(checkDelayMilliseconds);
  connect(&m_delay, &QTimer::timeout, this, &PlausibilityMonitor::check);
  for (const auto signal : {&Document::materialChanged, &Document::stateChanged, &Document::editChanged})
    connect(&document, signal, this, &PlausibilityMonitor::changed);
}

void PlausibilityMonitor::changed() {
  m_tasks.drop(plausibilityKey);
  m_current = !m_document.material();
  m_energies.clear();
  Q_EMIT energiesChanged();
  if (m_current) {
    m_delay.stop();
    return m_badges.clear();
  }
  m_badges.setPending();
  m_delay.start();
}

void PlausibilityMonitor::check() {
  const std::vector<editing::Edit> edits = m_document.edits();
  m_tasks.run<Findings>(
      {tr("Checking"), plausibilityKey, false, true},
      [base = m_document.base(), edits](const TaskControl& control) {
        return Findings{editing::checkEditPlausibility(base, edits, control),
                        editing::energiesThrough(base, edits, control)};
      },
      [this](const Findings& findings) {
        m_current = true;
        m_badges.setChecks(findings.checks);
        m_energies = findings.energies;
        Q_EMIT energiesChanged();
      });
}

}  // namespace gonio::app

#include "moc_plausibility_monitor.cpp"
