// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/document.h"

#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "core/editing/edit_list.h"
#include "widgets/inputs/menu_text.h"

namespace gonio::app {

namespace {

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

}  // namespace

using editing::DifferentialEdit;
using editing::EditList;

namespace {

/// Whether the same models start from the same fits, in the same order.
bool sameFits(const EditList& a, const EditList& b) {
  const auto next = [](const EditList& list, std::size_t& i) -> const DifferentialEdit* {
    while (i < list.size())
      if (const auto* edit = std::get_if<DifferentialEdit>(&list[i++].content)) return edit;
    return nullptr;
  };
  for (std::size_t i = 0, k = 0;;) {
    const DifferentialEdit *one = next(a, i), *other = next(b, k);
    if (!one || !other) return one == other;
    if (one->model != other->model || one->fitted != other->fitted) return false;
  }
}

/// Whether a fit alone made the edit.
bool isUntouched(const editing::Edit& edit) {
  const auto* change = std::get_if<DifferentialEdit>(&edit.content);
  return change && change->isIdentity() && edit.name.empty() && edit.enabled && edit.strength == 1 &&
         change->composition == editing::defaultComposition(*change->model) && change->keepsAlbedo;
}

/// Whether two lists are the same but for untouched edits.
bool changeTheSame(const EditList& a, const EditList& b) {
  const auto next = [](const EditList& list, EditList::const_iterator from) {
    return std::find_if_not(from, list.end(), isUntouched);
  };
  auto one = next(a, a.begin()), other = next(b, b.begin());
  while (one != a.end() && other != b.end() && *one == *other) {
    one = next(a, std::next(one));
    other = next(b, std::next(other));
  }
  return one == a.end() && other == b.end();
}

}  // namespace

DifferentialEdit identityEdit(const fitting::FitResult& fit) {
  return editing::unchangedEdit(*fit.model, fit.parameters);
}

Document::Document(QObject* parent) : QObject(parent) {
  connect(&m_history, &QUndoStack::cleanChanged, this, &Document::titleChanged);
  for (const auto signal : {&Document::stateChanged, &Document::editChanged})
    connect(this, signal, this, &Document::titleChanged);
}

bool Document::isModified() const {
  if (m_history.isClean()) return false;
  // A material from a file, without edits, can be opened again.
  const bool isSource = m_content.path.isEmpty() && material() && !material()->material.source.path.empty();
  if (isSource && state().incident == documents::EditDocument().incident && changeTheSame({}, edits())) return false;
  return !m_saved || m_saved->material != material() || m_saved->state.incident != state().incident ||
         !changeTheSame(m_saved->state.edits, edits());
}

void Document::markUnsaved() {
  m_saved.reset();
  m_history.resetClean();
  Q_EMIT titleChanged();
}

QString Document::name() const {
  if (!m_content.path.isEmpty()) return QFileInfo(m_content.path).completeBaseName();
  return material() ? QString::fromStdString(material()->material.name) : tr("Untitled");
}

materials::EditedMaterial Document::edited() const {
  if (!material()) return {};
  materials::Material base = material()->material;
  if (!base.brdf) base.brdf = material()->base;
  if (auto table = formOf<TabulatedBrdf>(base.brdf)) base.table = std::move(table);
  materials::EditedMaterial edited = materials::unedited(base);
  edited.edits = edits();
  edited.incident = state().incident;
  edited.shown.name = name().toStdString();
  if (!editing::isIdentity(edits())) edited.shown.table = nullptr;
  edited.shown.brdf = editing::isIdentity(edits()) ? this->base() : editing::applyEdits(this->base(), edits());
  return edited;
}

QString Document::folder() const {
  const QString source = material() ? QString::fromStdString(material()->material.source.path.string()) : QString();
  const QFileInfo file(path().isEmpty() ? source : path());
  if (path().isEmpty() && !file.isFile()) return {};
  const QString folder = file.absolutePath();
  // Acquired materials and those saved in the library are files that nobody looks for.
  const QString own = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QLatin1Char('/');
  return folder.startsWith(own) ? QString() : folder;
}

editing::EditList Document::describedEdits() const { return path().isEmpty() ? edits() : editing::EditList(); }

void Document::select(int edit) {
  if (edit == state().selected) return;
  m_content.state.selected = edit;
  Q_EMIT selectionChanged();
}

void Document::setContent(Content content) {
  m_content = std::move(content);
  m_interacting = false;
  Q_EMIT materialChanged();
  Q_EMIT stateChanged();
  Q_EMIT selectionChanged();
  Q_EMIT titleChanged();
}

void Document::startAnew(Content content) {
  m_history.clear();
  m_history.setClean();
  m_saved = Saved{content.material, content.state};
  setContent(std::move(content));
}

void Document::replaceMaterial(LoadedMaterialPtr material, const QString& text) {
  m_history.add(new ReplaceMaterialCommand(*this, std::move(material), text));
}

void Document::setMaterial(LoadedMaterialPtr material) { startAnew({std::move(material), {}, {}, {}}); }

void Document::setMaterial(LoadedMaterialPtr material, const documents::EditDocument& stored, const QString& path) {
  startAnew({std::move(material), {stored.edits, int(stored.edits.size()) - 1, stored.incident}, path, {}});
}

void Document::beginInteraction() {
  ++m_interaction;
  m_interacting = true;
  m_atBegin = state();
}

void Document::addStep(EditState after, const QString& text) {
  if (after.edits == edits() && after.incident == state().incident) return;
  try {
    editing::checkLimits(after.edits);
  } catch (const Error& error) {
    Q_EMIT editChanged();  // the panels show the values as they are
    return Q_EMIT refused(tr("The edit was not changed: %1.").arg(QString::fromUtf8(error.what())));
  }
  after.selected = std::min(after.selected, int(after.edits.size()) - 1);
  m_history.add(new ReplaceEditsCommand(*this, std::move(after), text, m_interaction));
}

void Document::replaceEdits(EditList edits, const QString& text, std::optional<int> selected) {
  if (!m_interacting) ++m_interaction;
  addStep({std::move(edits), selected.value_or(state().selected), state().incident}, text);
}

void Document::installEdits(EditList edits, const QString& text, std::optional<int> selected) {
  ++m_interaction;
  addStep({std::move(edits), selected.value_or(state().selected), state().incident}, text);
  // What is dragged goes on as another step.
  ++m_interaction;
  m_atBegin = state();
}

void Document::setIncident(IncidentDirection incident) {
  ++m_interaction;
  EditState after = state();
  after.incident = incident;
  addStep(std::move(after), tr("Incident direction"));
  ++m_interaction;
}

std::shared_ptr<const Brdf> Document::base() const {
  if (!material()) return nullptr;
  const std::shared_ptr<const Brdf>& own = material()->base;
  if (!own->incidentDirection()) return own;
  if (m_baseSource != own || m_base->incidentDirection() != state().incident)
    m_base = withIncident(own, state().incident);
  m_baseSource = own;
  return m_base;
}

void Document::rememberFit(fitting::FitResult fit) {
  std::erase_if(m_content.fits, [&](const fitting::FitResult& known) {
    return known.model == fit.model && known.parameters == fit.parameters;
  });
  m_content.fits.push_back(std::move(fit));
}

const fitting::FitResult* Document::knownFit(const models::Model& model) const {
  const auto& fits = m_content.fits;
  const auto found = std::find_if(fits.rbegin(), fits.rend(), [&](const auto& fit) { return fit.model == &model; });
  return found == fits.rend() ? nullptr : &*found;
}

const fitting::FitResult* Document::fitOf(const DifferentialEdit& edit) const {
  const auto& fits = m_content.fits;
  const auto found = std::find_if(fits.rbegin(), fits.rend(), [&](const auto& fit) {
    return fit.model == edit.model && fit.parameters == edit.fitted;
  });
  return found == fits.rend() ? nullptr : &*found;
}

void Document::adoptFit(const fitting::FitResult& fit) {
  rememberFit(fit);
  const editing::Edit edit{identityEdit(fit)};
  const auto append = [&](int step) {
    auto* command = dynamic_cast<ReplaceEditsCommand*>(const_cast<QUndoCommand*>(m_history.command(step)));
    if (command) command->append(edit);
    return command != nullptr;
  };
  // Of this material, before and after the present state; those of another lie behind a ReplaceMaterialCommand.
  for (int i = m_history.index() - 1; i >= 0 && append(i); --i) {
  }
  for (int i = m_history.index(); i < m_history.count() && append(i); ++i) {
  }
  EditState after = state();
  after.edits.push_back(edit);
  if (after.selected < 0) after.selected = int(after.edits.size()) - 1;
  m_atBegin.edits.push_back(edit);
  setState(after);
}

void Document::chooseFit(fitting::FitResult fit) {
  rememberFit(fit);
  const QString text = tr("Fit %1").arg(QString::fromUtf8(fit.model->spec().name.data()));
  const int active = activeIndex<DifferentialEdit>(state());
  if (active < 0)
    return installEdits(editing::inserted(edits(), edits().size(), {identityEdit(fit)}), text, int(edits().size()));
  const auto anew = [&](editing::Edit& edit) { edit = {identityEdit(fit), edit.name}; };
  installEdits(editing::withEdit(edits(), std::size_t(active), anew), text);
}

documents::EditDocument Document::toEditDocument() const {
  documents::EditDocument document;
  if (material()) {
    document.sourcePath = material()->material.source.path.string();
    document.sourceSha256 = material()->material.source.sha256;
    document.blend = material()->blend;
  }
  document.incident = state().incident;
  document.edits = edits();
  return document;
}

void Document::markSaved(const QString& path) {
  m_content.path = path;
  m_saved = Saved{material(), state()};
  m_history.setClean();
  Q_EMIT titleChanged();
}

void Document::setState(const EditState& state) {
  const bool fits = sameFits(state.edits, edits()), selection = state.selected == m_content.state.selected;
  m_content.state = state;
  Q_EMIT(fits ? editChanged() : stateChanged());
  if (!selection) Q_EMIT selectionChanged();
}

}  // namespace gonio::app

#include "moc_document.cpp"
