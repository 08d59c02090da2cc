// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/commands.h"

#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

ChangeParameterCommand::ChangeParameterCommand(Document& document, int parameter, const Rgb& value, int interaction,
                                               bool reset)
    : m_document(document),
      m_parameter(parameter),
      m_interaction(interaction),
      m_reset(reset),
      m_before(document.edit()->edited.values[std::size_t(parameter)]),
      m_after(value) {
  describe();
}

void ChangeParameterCommand::describe() {
  const models::ParameterSpec& spec = m_document.edit()->model->spec().parameters[std::size_t(m_parameter)];
  const QString label = widgets::fromView(spec.label).toLower();
  setText(m_reset ? QObject::tr("Reset %1").arg(label)
                  : QObject::tr("Change %1 %2 to %3")
                        .arg(label, widgets::displayValue(spec, m_before), widgets::displayValue(spec, m_after)));
}

bool ChangeParameterCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const ChangeParameterCommand*>(other);
  if (isForgotten() || next->m_interaction != m_interaction || next->m_parameter != m_parameter) return false;
  m_after = next->m_after;
  if (m_after == m_before)
    setObsolete(true);
  else
    describe();
  return true;
}

ChangeFactorsCommand::ChangeFactorsCommand(Document& document, const Factors& after, int interaction,
                                           const QString& text)
    : m_document(document), m_interaction(interaction), m_before(document.factors()), m_after(after) {
  setText(text);
}

bool ChangeFactorsCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const ChangeFactorsCommand*>(other);
  if (isForgotten() || next->m_interaction != m_interaction) return false;
  m_after = next->m_after;
  setText(next->text());
  if (m_after == m_before) setObsolete(true);
  return true;
}

std::size_t ChangeFactorsCommand::bytes() const {
  return sizeof(*this) + (m_before ? m_before->bytes() : 0) + (m_after ? m_after->bytes() : 0);
}

ChangeEditShareCommand::ChangeEditShareCommand(Document& document, double strength, bool enabled, int interaction,
                                               const QString& text)
    : m_document(document),
      m_interaction(interaction),
      m_before{document.edit()->strength, document.edit()->enabled},
      m_after{strength, enabled} {
  setText(text);
}

bool ChangeEditShareCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const ChangeEditShareCommand*>(other);
  if (isForgotten() || next->m_interaction != m_interaction) return false;
  m_after = next->m_after;
  setText(next->text());
  if (m_after == m_before) setObsolete(true);
  return true;
}

ReplaceStateCommand::ReplaceStateCommand(Document& document, EditState after, const QString& text)
    : m_document(document), m_before(document.state()), m_after(std::move(after)) {
  setText(text);
}

std::size_t ReplaceStateCommand::bytes() const {
  const auto of = [](const EditState& state) {
    std::size_t sum = 0;
    if (state.fit) sum += state.fit->parameters.values.size() * sizeof(Rgb) + state.fit->errors.size() * sizeof(double);
    if (state.edit) sum += (state.edit->fitted.values.size() + state.edit->edited.values.size()) * sizeof(Rgb);
    if (state.factors) sum += state.factors->bytes();
    return sum;
  };
  return sizeof(*this) + of(m_before) + of(m_after);
}

void ReplaceStateCommand::release() { m_before = m_after = {}; }

ReplaceMaterialCommand::ReplaceMaterialCommand(Document& document, LoadedMaterialPtr after, const QString& text)
    : m_document(document), m_before(current()), m_after{std::move(after), {}, {}} {
  setText(text);
}

ReplaceMaterialCommand::Content ReplaceMaterialCommand::current() const {
  return {m_document.material(), m_document.state(), m_document.path()};
}

void ReplaceMaterialCommand::show(const Content& content) {
  m_document.setContent(content.material, content.state, content.path);
  Q_EMIT m_document.materialReplaced();
}

void ReplaceMaterialCommand::apply() {
  m_before = current();
  show(m_after);
}

void ReplaceMaterialCommand::revert() {
  // With the automatic fit and the file that it has got meanwhile.
  m_after = current();
  show(m_before);
}

void ReplaceMaterialCommand::release() { m_before = m_after = {}; }

std::size_t ReplaceMaterialCommand::bytes() const {
  const auto of = [](const Content& content) { return content.material ? content.material->table->bytes() : 0; };
  return sizeof(*this) + of(m_before) + of(m_after);
}

}  // namespace gonio::app
