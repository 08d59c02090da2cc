// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_materials.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gonio/comparison/reference_dialog.h"
#include "app/gonio/document/document.h"
#include "app/gonio/document/material_files.h"
#include "widgets/figures/entry_list.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/library/library_model.h"
#include "widgets/library/material_drag.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

using figures::FigureDescription;
using figures::FigureRepresentation;

namespace {

/// Removes, moves and renames entries as the user does in their list. @param changed called after each change.
template <typename Entry, typename Changed>
void followList(widgets::EntryList& list, std::vector<Entry>& entries, QObject* owner, const Changed& changed) {
  QObject::connect(&list, &widgets::EntryList::removeRequested, owner, [&entries, changed](int row) {
    entries.erase(entries.begin() + row);
    changed();
  });
  QObject::connect(&list, &widgets::EntryList::moveRequested, owner, [&entries, changed](int from, int to) {
    std::swap(entries[std::size_t(from)], entries[std::size_t(to)]);
    changed();
  });
  QObject::connect(&list.model(), &widgets::EntryListModel::labelEdited, owner,
                   [&entries, changed](int row, const QString& label) {
                     entries[std::size_t(row)].label = label.toStdString();
                     changed();
                   });
}

/// The model of the edit shown in the panels; null if there is none.
const models::Model* modelInUse(const Document& document) {
  const auto* edit = document.active<editing::DifferentialEdit>();
  return edit ? edit->model : nullptr;
}

QString budgetAction(const study::Representation& one) {
  return QString::fromStdString(one.kind->hasBudget() ? one.budgetText() : one.label());
}

/// Whether no other row has its family.
bool isAlone(const study::RepresentationKind& kind) {
  return std::ranges::count(study::representationKinds(), kind.family, &study::RepresentationKind::family) == 1;
}

}  // namespace

FigureRepresentations::FigureRepresentations(const Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_list(new widgets::EntryList(tr("Representation"), true)) {
  m_list->setEmptyText(tr("Add representations: one for each column of the figure."));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_list);
  connectList();
}

void FigureRepresentations::connectList() {
  connect(&m_list->addMenu(), &QMenu::aboutToShow, this, &FigureRepresentations::fillMenu);
  followList(*m_list, m_representations, this, [this] {
    show();
    Q_EMIT changed();
  });
  connect(&m_list->model(), &widgets::EntryListModel::budgetEdited, this,
          [this](int row, int budget) { setBudget(std::size_t(row), budget); });
}

void FigureRepresentations::setRepresentations(std::vector<FigureRepresentation> representations) {
  m_representations = std::move(representations);
  show();
}

void FigureRepresentations::setDefaults() {
  const models::Model* model = modelInUse(m_document);
  setRepresentations({{study::representationById(model ? model->spec().id : "ggx")},
                      {study::representationById("factors-3d", 10)},
                      {study::representationById("code", 256)}});
}

void FigureRepresentations::fillMenu() {
  QMenu& menu = m_list->addMenu();
  menu.clear();
  qDeleteAll(menu.findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly));
  const models::Model* model = modelInUse(m_document);
  QAction* fit =
      menu.addAction(model ? tr("Current Fit (%1)").arg(widgets::toQString(model->spec().name)) : tr("Current Fit"),
                     this, [this, model] {
                       if (model) add(study::representationById(model->spec().id));
                     });
  fit->setEnabled(model != nullptr);
  menu.addSeparator();
  // One submenu per family; representations with a budget have one per id, with the budgets.
  QMenu* part = nullptr;
  QString title;
  for (const study::Representation& one : study::representationsOf({.names = study::familiesWithoutFurtherData()})) {
    const QString wanted = widgets::toQString(one.kind->hasBudget() ? one.kind->label : one.kind->family->name);
    if (isAlone(*one.kind) && !one.kind->hasBudget()) {
      menu.addAction(budgetAction(one), this, [this, one] { add(one); });
      continue;
    }
    if (wanted != title) {
      title = wanted;
      part = menu.addMenu(QString(title).replace(0, 1, title.at(0).toUpper()));
    }
    part->addAction(budgetAction(one), this, [this, one] { add(one); });
  }
}

void FigureRepresentations::add(const study::Representation& representation) {
  m_representations.push_back({representation});
  show();
  m_list->select(int(m_representations.size()) - 1);
  Q_EMIT changed();
}

void FigureRepresentations::setBudget(std::size_t row, int budget) {
  study::Representation& shown = m_representations[row].representation;
  shown.budget = budget;
  show();
  Q_EMIT changed();
}

void FigureRepresentations::show() {
  std::vector<widgets::ListEntry> entries;
  for (const FigureRepresentation& one : m_representations) {
    const study::Representation& shown = one.representation;
    widgets::ListEntry entry{.name = QString::fromStdString(shown.label()),
                             .toolTip = QString::fromStdString(shown.fullLabel()),
                             .label = QString::fromStdString(one.label),
                             .usualLabel = QString::fromStdString(FigureRepresentation{shown}.shownLabel())};
    if (shown.kind->hasBudget()) {
      entry.budget = int(shown.budget);
      entry.maxBudget = shown.kind->maxBudget;
    }
    entries.push_back(std::move(entry));
  }
  m_list->setEntries(std::move(entries), m_representations.size() >= FigureDescription::maxRepresentations);
}

using figures::FigureDescription;
using figures::FigureMaterial;

FigureMaterials::FigureMaterials(const Parts& parts, QWidget* parent)
    : QWidget(parent), m_parts(parts), m_list(new widgets::EntryList(tr("Material"), false)), m_note(new QLabel) {
  setAcceptDrops(true);
  m_list->setEmptyText(tr("Add materials or drop them here, one for each row of the figure."));
  m_note->setWordWrap(true);
  m_note->setTextFormat(Qt::PlainText);
  m_note->setForegroundRole(QPalette::PlaceholderText);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_list, 1);
  layout->addWidget(m_note);
  connectList();
  show();
}

void FigureMaterials::connectList() {
  connect(&m_list->addMenu(), &QMenu::aboutToShow, this, &FigureMaterials::fillMenu);
  followList(*m_list, m_materials, this, [this] {
    show();
    Q_EMIT changed();
  });
  connect(&m_parts.document, &Document::titleChanged, this, &FigureMaterials::showNote);
}

QString FigureMaterials::openId() const {
  const Document& document = m_parts.document;
  if (!document.path().isEmpty()) return document.path();
  return document.material() ? QString::fromStdString(document.material()->material.source.path.string()) : QString();
}

void FigureMaterials::setMaterials(std::vector<FigureMaterial> materials) {
  m_materials = std::move(materials);
  show();
}

void FigureMaterials::add(const QStringList& ids) {
  const std::size_t before = m_materials.size();
  for (const QString& id : ids) {
    if (id.isEmpty() || contains(id) || m_materials.size() >= FigureDescription::maxMaterials) continue;
    m_materials.push_back({id.toStdString()});
  }
  if (m_materials.size() == before) return;
  show();
  m_list->select(int(m_materials.size()) - 1);
  Q_EMIT changed();
}

bool FigureMaterials::contains(const QString& id) const {
  return std::ranges::count(m_materials, id.toStdString(), &FigureMaterial::path) > 0;
}

void FigureMaterials::fillMenu() {
  QMenu& menu = m_list->addMenu();
  menu.clear();
  const QString open = openId();
  menu.addAction(tr("The &Open Material"), this, [this, open] { add({open}); })
      ->setEnabled(!open.isEmpty() && !contains(open));
  QStringList selected = m_parts.selectedIds();
  selected.removeIf([this](const QString& id) { return contains(id); });
  menu.addAction(tr("Library &Selection (%1)").arg(selected.size()), this, [this, selected] { add(selected); })
      ->setEnabled(!selected.isEmpty());
  menu.addAction(tr("From the &Library..."), this, &FigureMaterials::chooseFromLibrary);
  menu.addAction(tr("&Files..."), this, &FigureMaterials::chooseFiles);
}

void FigureMaterials::chooseFromLibrary() {
  auto* dialog = new ReferenceDialog(m_parts.library, this);
  dialog->setPurpose(tr("Add Material"), tr("&Add"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ReferenceDialog::chosen, this, [this](const QString& id) { add({id}); });
  dialog->open();
}

void FigureMaterials::chooseFiles() {
  const QString purpose = QStringLiteral("open");
  auto* dialog = new QFileDialog(this, tr("Add Materials"), widgets::dialogFolder(purpose), openFilter());
  dialog->setFileMode(QFileDialog::ExistingFiles);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QFileDialog::filesSelected, this, [this, purpose](const QStringList& files) {
    widgets::rememberDialogFolder(purpose, files.value(0));
    add(files);
  });
  dialog->open();
}

void FigureMaterials::show() {
  std::vector<widgets::ListEntry> entries;
  for (const FigureMaterial& one : m_materials) {
    const QString path = QString::fromStdString(one.path), name = materialName(path);
    entries.push_back({.name = name, .toolTip = path, .label = QString::fromStdString(one.label), .usualLabel = name});
  }
  m_list->setEntries(std::move(entries), m_materials.size() >= FigureDescription::maxMaterials);
  showNote();
}

void FigureMaterials::showNote() {
  const Document& document = m_parts.document;
  const QString open = openId();
  QString note;
  if (document.material() && open.isEmpty())
    note = tr("%1 has no file. Save it as a document to add it.").arg(widgets::spacedName(document.name()));
  else if (contains(open) && document.isModified())
    note = tr("Unsaved edits of %1 are not in the figure. Save the document%2.")
               .arg(widgets::spacedName(document.name()), document.path().isEmpty() ? tr(" and add it") : QString());
  m_note->setText(note);
  m_note->setVisible(!note.isEmpty());
}

void FigureMaterials::dragEnterEvent(QDragEnterEvent* event) {
  if (!widgets::draggedMaterial(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void FigureMaterials::dropEvent(QDropEvent* event) {
  add({widgets::draggedMaterial(event->mimeData())});
  event->acceptProposedAction();
}

}  // namespace gonio::app

#include "moc_figure_materials.cpp"
