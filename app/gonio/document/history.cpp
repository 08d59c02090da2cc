// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/history.h"

#include <QCoreApplication>

namespace gonio::app {

void Command::forget() {
  if (m_forgotten) return;
  m_forgotten = true;
  release();
  setText(QCoreApplication::translate("History", "%1 (too old to undo)").arg(text()));
}

void Command::undo() {
  if (!m_forgotten) revert();
}

void Command::redo() {
  if (!m_forgotten) apply();
}

void History::add(Command* command) {
  push(command);
  bound();
}

std::size_t History::bytes() const {
  std::size_t sum = 0;
  for (int i = 0; i < count(); ++i) sum += static_cast<const Command*>(command(i))->bytes();
  return sum;
}

void History::bound() {
  std::size_t sum = bytes();
  // The newest step is always kept: what was just done can be undone.
  for (int i = 0; i + 1 < index() && sum > m_byteLimit; ++i) {
    auto* oldest = const_cast<Command*>(static_cast<const Command*>(command(i)));
    if (oldest->isForgotten()) continue;
    sum -= oldest->bytes();
    oldest->forget();
    // A saved state that lies before a forgotten step can no longer be reached.
    if (cleanIndex() >= 0 && cleanIndex() <= i) resetClean();
  }
}

}  // namespace gonio::app

#include "moc_history.cpp"
