// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/commands.h"

#include "core/editing/edit_list.h"
#include "widgets/inputs/menu_text.h"

namespace gonio::app {

ReplaceEditsCommand::ReplaceEditsCommand(Document& document, EditState after, const QString& text, int interaction)
    : m_document(document), m_interaction(interaction), m_before(document.state()), m_after(std::move(after)) {
  setText(widgets::oneLine(text));  // Qt takes a second line for the text of the menu
}

bool ReplaceEditsCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const ReplaceEditsCommand*>(other);
  if (isForgotten() || next->m_interaction != m_interaction) return false;
  m_after = next->m_after;
  setText(next->text());
  if (m_after.edits == m_before.edits && m_after.incident == m_before.incident) setObsolete(true);
  return true;
}

std::size_t ReplaceEditsCommand::bytes() const {
  return sizeof(*this) + editing::unsharedBytes(m_before.edits, m_after.edits) +
         editing::unsharedBytes(m_after.edits, m_before.edits);
}

void ReplaceEditsCommand::append(const editing::Edit& edit) {
  for (EditState* state : {&m_before, &m_after}) {
    state->edits.push_back(edit);
    if (state->selected < 0) state->selected = int(state->edits.size()) - 1;
  }
}

ReplaceMaterialCommand::ReplaceMaterialCommand(Document& document, LoadedMaterialPtr after, const QString& text)
    : m_document(document), m_before(document.content()), m_after{std::move(after), {}, {}, {}} {
  setText(widgets::oneLine(text));
}

void ReplaceMaterialCommand::show(const Document::Content& content) {
  m_document.setContent(content);
  Q_EMIT m_document.materialReplaced();
}

void ReplaceMaterialCommand::apply() {
  m_before = m_document.content();
  show(m_after);
}

void ReplaceMaterialCommand::revert() {
  // With the automatic fit and the file that it has got meanwhile.
  m_after = m_document.content();
  show(m_before);
}

std::size_t ReplaceMaterialCommand::bytes() const {
  const auto of = [](const Document::Content& content) { return content.material ? content.material->bytes() : 0; };
  return sizeof(*this) + of(m_before) + of(m_after);
}

}  // namespace gonio::app
