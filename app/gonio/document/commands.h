// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/document.h"

namespace gonio::app {

/// Replaces the list of edits. Steps of one interaction (a drag of a slider or a curve) merge into one; a drag that
/// ends where it began leaves no step.
class ReplaceEditsCommand final : public Command {
 public:
  ReplaceEditsCommand(Document& document, EditState after, const QString& text, int interaction);

  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override;
  /// Curves that both lists hold do not count: other steps or the document hold them too.
  std::size_t bytes() const override;
  /// An edit that exists on both sides of this step, behind all others.
  void append(const editing::Edit& edit);

 protected:
  void apply() override { m_document.setState(m_after); }
  void revert() override { m_document.setState(m_before); }
  void release() override { m_before = m_after = {}; }

 private:
  Document& m_document;
  int m_interaction;
  EditState m_before, m_after;
};

/// Puts another material in the place of the document's. What stands beside the material (edits, the automatic fit, the
/// file) goes and comes back with it.
class ReplaceMaterialCommand final : public Command {
 public:
  ReplaceMaterialCommand(Document& document, LoadedMaterialPtr after, const QString& text);

  std::size_t bytes() const override;

 protected:
  void apply() override;
  void revert() override;
  void release() override { m_before = m_after = {}; }

 private:
  void show(const Document::Content& content);

  Document& m_document;
  Document::Content m_before, m_after;
};

}  // namespace gonio::app
