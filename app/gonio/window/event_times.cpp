// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/event_times.h"

#include <QEvent>
#include <QMetaEnum>
#include <QThread>
#include <algorithm>
#include <map>

namespace gonio::app {

namespace {

constexpr qint64 longNanoseconds = 50'000'000;

QString described(const QObject* receiver, QEvent::Type type) {
  const char* name = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
  const QString owner = receiver->objectName().isEmpty() && receiver->parent()
                            ? QStringLiteral("child of ") + receiver->parent()->metaObject()->className()
                            : receiver->objectName();
  return QStringLiteral("%1 (%2) %3")
      .arg(receiver->metaObject()->className(), owner, name ? QString(name) : QString::number(type));
}

}  // namespace

bool TimedApplication::notify(QObject* receiver, QEvent* event) {
  return m_timing && receiver->thread() == thread() ? timed(receiver, event) : QApplication::notify(receiver, event);
}

bool TimedApplication::timed(QObject* receiver, QEvent* event) {
  const int level = thread()->loopLevel();
  if (!m_stack.empty()) {
    if (m_stack.back().loopLevel == level) return QApplication::notify(receiver, event);
    m_stack.back().hasNestedLoop = true;
  }
  // The receiver may be gone when it has handled the event.
  const QEvent::Type type = event->type();
  const QString what = described(receiver, type);
  m_stack.push_back({level, false});
  QElapsedTimer elapsed;
  elapsed.start();
  const bool result = QApplication::notify(receiver, event);
  const qint64 nanoseconds = elapsed.nsecsElapsed();
  if (!m_stack.back().hasNestedLoop) {
    ++m_events;
    if (nanoseconds > longNanoseconds) m_long.push_back({what, nanoseconds});
  }
  m_stack.pop_back();
  return result;
}

QString TimedApplication::eventTimes() const {
  struct Kind {
    int count = 0;
    qint64 longest = 0;
  };
  std::map<QString, Kind> kinds;
  for (const Long& event : m_long) {
    Kind& kind = kinds[event.what];
    ++kind.count;
    kind.longest = std::max(kind.longest, event.nanoseconds);
  }
  std::vector<std::pair<QString, Kind>> sorted(kinds.begin(), kinds.end());
  std::ranges::sort(sorted, std::greater{}, [](const auto& entry) { return entry.second.longest; });
  QString text = QStringLiteral("%1 events, %2 longer than 50 ms\n").arg(m_events).arg(m_long.size());
  for (const auto& [what, kind] : sorted)
    text += QStringLiteral("%1 ms at most, %2 times: %3\n")
                .arg(double(kind.longest) * 1e-6, 0, 'f', 0)
                .arg(kind.count)
                .arg(what);
  return text;
}

}  // namespace gonio::app
