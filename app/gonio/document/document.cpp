// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/document.h"

#include <QFileInfo>

#include "app/gonio/document/commands.h"

namespace gonio::app {

editing::DifferentialEdit identityEdit(const fitting::FitResult& fit) {
  editing::DifferentialEdit edit;
  edit.model = fit.model;
  edit.fitted = edit.edited = fit.parameters;
  return edit;
}

Document::Document(QObject* parent) : QObject(parent) {
  connect(&m_history, &QUndoStack::cleanChanged, this, &Document::titleChanged);
}

QString Document::name() const {
  if (!m_path.isEmpty()) return QFileInfo(m_path).completeBaseName();
  return m_material ? QString::fromStdString(m_material->material.name) : tr("Untitled");
}

void Document::setContent(LoadedMaterialPtr material, const EditState& state, const QString& path) {
  m_material = std::move(material);
  m_state = state;
  m_path = path;
  m_interacting = false;
  Q_EMIT materialChanged();
  Q_EMIT stateChanged();
  Q_EMIT titleChanged();
}

void Document::startAnew(LoadedMaterialPtr material, const EditState& state, const QString& path) {
  m_history.clear();
  m_history.setClean();
  setContent(std::move(material), state, path);
}

void Document::replaceMaterial(LoadedMaterialPtr material, const QString& text) {
  m_history.add(new ReplaceMaterialCommand(*this, std::move(material), text));
}

void Document::setMaterial(LoadedMaterialPtr material) { startAnew(std::move(material), {}, {}); }

void Document::setMaterial(LoadedMaterialPtr material, const editing::EditDocument& stored, const QString& path) {
  EditState state;
  for (const editing::Edit& edit : stored.edits) {
    const auto* differential = std::get_if<editing::DifferentialEdit>(&edit);
    if (differential ? state.edit.has_value() : state.factors || state.edit)
      throw Error(path.toStdString() + ": holds " + std::to_string(stored.edits.size()) +
                  " edits; this version of the editor opens documents with one of factors, then one of a model");
    if (differential)
      state.edit = *differential;
    else
      state.factors = std::get<editing::FactorEdit>(edit);
  }
  startAnew(std::move(material), state, path);
}

void Document::adoptFit(const fitting::FitResult& fit) { setState({fit, identityEdit(fit), m_state.factors}); }

void Document::chooseFit(const fitting::FitResult& fit) {
  const QString text = tr("Fit %1").arg(QString::fromUtf8(fit.model->spec().name.data()));
  m_history.add(new ReplaceStateCommand(*this, {fit, identityEdit(fit), m_state.factors}, text));
}

void Document::beginInteraction() {
  ++m_interaction;
  m_interacting = true;
}

void Document::endInteraction() { m_interacting = false; }

void Document::setParameter(int parameter, const Rgb& value) {
  if (!m_state.edit || m_state.edit->edited.values[std::size_t(parameter)] == value) return;
  if (!m_interacting) ++m_interaction;
  m_history.add(new ChangeParameterCommand(*this, parameter, value, m_interaction));
}

void Document::resetParameter(int parameter) {
  if (!m_state.edit) return;
  const Rgb fitted = m_state.edit->fitted.values[std::size_t(parameter)];
  if (m_state.edit->edited.values[std::size_t(parameter)] == fitted) return;
  m_history.add(new ChangeParameterCommand(*this, parameter, fitted, ++m_interaction, true));
}

void Document::resetAll() {
  if (!m_state.edit || m_state.edit->edited == m_state.edit->fitted) return;
  editing::DifferentialEdit edit = *m_state.edit;
  edit.edited = edit.fitted;
  m_history.add(new ReplaceStateCommand(*this, {m_state.fit, edit, m_state.factors}, tr("Reset all parameters")));
}

void Document::changeEditShare(double strength, bool enabled, const QString& text) {
  if (!m_state.edit || (m_state.edit->strength == strength && m_state.edit->enabled == enabled)) return;
  if (!m_interacting) ++m_interaction;
  m_history.add(new ChangeEditShareCommand(*this, strength, enabled, m_interaction, text));
}

void Document::setEditStrength(double strength) {
  if (m_state.edit)
    changeEditShare(strength, m_state.edit->enabled,
                    tr("Strength of the model's edit %1 %").arg(100 * strength, 0, 'f', 0));
}

void Document::setEditEnabled(bool enabled) {
  if (m_state.edit)
    changeEditShare(m_state.edit->strength, enabled,
                    enabled ? tr("Show the model's edit") : tr("Hide the model's edit"));
}

void Document::deleteEdit() {
  if (!m_state.edit) return;
  editing::DifferentialEdit edit = *m_state.edit;
  edit.edited = edit.fitted;
  edit.strength = 1;
  edit.enabled = true;
  m_history.add(new ReplaceStateCommand(*this, {m_state.fit, edit, m_state.factors}, tr("Delete the model's edit")));
}

void Document::paste(const std::optional<editing::FactorEdit>& factors,
                     const std::optional<editing::DifferentialEdit>& edit,
                     const std::optional<fitting::FitResult>& fit) {
  if (!edit) return factors ? setFactors(factors, tr("Paste factor curves")) : void();
  EditState state = m_state;
  state.edit = edit;
  if (factors) state.factors = factors;
  if (fit) state.fit = fit;
  if (!fit && state.factors == m_state.factors && state.edit == m_state.edit) return;
  m_history.add(new ReplaceStateCommand(*this, state, tr("Paste edits")));
}

void Document::setFactors(const std::optional<editing::FactorEdit>& factors, const QString& text) {
  if (factors == m_state.factors) return;
  if (!m_interacting) ++m_interaction;
  m_history.add(new ChangeFactorsCommand(*this, factors, m_interaction, text));
}

editing::EditDocument Document::toEditDocument() const {
  editing::EditDocument document;
  if (m_material) {
    document.sourcePath = m_material->material.source.path.string();
    document.sourceSha256 = m_material->material.source.sha256;
    document.blend = m_material->blend;
  }
  document.edits = edits();
  return document;
}

void Document::markSaved(const QString& path) {
  m_path = path;
  m_history.setClean();
  Q_EMIT titleChanged();
}

void Document::setState(const EditState& state) {
  m_state = state;
  Q_EMIT stateChanged();
}

void Document::setEditedValue(int parameter, const Rgb& value) {
  m_state.edit->edited.values[std::size_t(parameter)] = value;
  Q_EMIT editChanged();
}

void Document::setEditShare(double strength, bool enabled) {
  m_state.edit->strength = strength;
  m_state.edit->enabled = enabled;
  Q_EMIT editChanged();
}

void Document::replaceFactors(const std::optional<editing::FactorEdit>& factors) {
  m_state.factors = factors;
  Q_EMIT editChanged();
}

}  // namespace gonio::app

#include "moc_document.cpp"
