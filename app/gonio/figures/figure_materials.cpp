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
#include "app/gonio/document/material_files.h"
#include "widgets/figures/entry_list.h"
#include "widgets/inputs/dialog_folder.h"
#include "widgets/library/library_model.h"
#include "widgets/library/material_drag.h"

namespace gonio::app {

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
  connect(m_list, &widgets::EntryList::removeRequested, this, [this](int row) {
    m_materials.erase(m_materials.begin() + row);
    show();
    Q_EMIT changed();
  });
  connect(m_list, &widgets::EntryList::moveRequested, this, [this](int from, int to) {
    std::swap(m_materials[std::size_t(from)], m_materials[std::size_t(to)]);
    show();
    Q_EMIT changed();
  });
  connect(&m_list->model(), &widgets::EntryListModel::labelEdited, this, [this](int row, const QString& label) {
    m_materials[std::size_t(row)].label = label.toStdString();
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
    note = tr("%1 has no file. Save it as a document to add it.").arg(document.name());
  else if (contains(open) && document.isModified())
    note = tr("Unsaved edits of %1 are not in the figure. Save the document%2.")
               .arg(document.name(), document.path().isEmpty() ? tr(" and add it") : QString());
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
