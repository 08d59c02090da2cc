// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QUndoStack>
#include <cstddef>

namespace gonio::app {

/// An undo step that knows what it costs to keep and can let go of its content.
class Command : public QUndoCommand {
 public:
  using QUndoCommand::QUndoCommand;

  /// Memory that this step keeps alive.
  virtual std::size_t bytes() const = 0;
  /// Frees the content: from now on the step does nothing in either direction.
  void forget();
  bool isForgotten() const { return m_forgotten; }

  void undo() final;
  void redo() final;

 protected:
  virtual void apply() = 0;
  virtual void revert() = 0;
  virtual void release() = 0;

 private:
  bool m_forgotten = false;
};

/// The undo history of a document: unlimited by count, bounded by bytes. When it grows beyond the bound, the oldest
/// steps forget their content; undo then stops at the oldest state that is still known.
class History : public QUndoStack {
  Q_OBJECT

 public:
  static constexpr std::size_t defaultByteLimit = std::size_t(256) << 20;

  explicit History(QObject* parent = nullptr) : QUndoStack(parent) {}

  void setByteLimit(std::size_t bytes) { m_byteLimit = bytes; }
  /// Takes ownership and applies it, as QUndoStack::push; then bounds the history.
  void add(Command* command);
  std::size_t bytes() const;

 private:
  void bound();

  std::size_t m_byteLimit = defaultByteLimit;
};

}  // namespace gonio::app
