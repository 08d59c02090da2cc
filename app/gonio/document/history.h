// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QUndoStack>
#include <cstddef>

namespace gonio::app {

/// An undo step that reports its memory and can free its content.
class Command : public QUndoCommand {
 public:
  using QUndoCommand::QUndoCommand;

  /// Memory that this step holds.
  virtual std::size_t bytes() const = 0;
  /// Frees the content. Undo and redo of this step then have no effect.
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

/// The undo history of a document, limited in bytes, not in number of steps. Above the limit the oldest steps forget
/// their content, and undo stops at the oldest state that is still known.
class History : public QUndoStack {
  Q_OBJECT

 public:
  static constexpr std::size_t defaultByteLimit = std::size_t(256) << 20;

  explicit History(QObject* parent = nullptr) : QUndoStack(parent) {}

  void setByteLimit(std::size_t bytes) { m_byteLimit = bytes; }
  /// Takes ownership of a command and applies it, as QUndoStack::push(), then enforces the limit.
  void add(Command* command);
  std::size_t bytes() const;

 private:
  void bound();

  std::size_t m_byteLimit = defaultByteLimit;
};

}  // namespace gonio::app
