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
  /// Curves in both lists do not count, because other steps or the document share them.
  std::size_t bytes() const override;
  /// Appends an edit to both lists of this step.
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

/// Replaces the document's material. Edits, fits and the file belong to the material and are restored together with it.
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
