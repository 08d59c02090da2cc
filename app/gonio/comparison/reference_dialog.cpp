// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/comparison/reference_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QListView>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gonio/document/material_files.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/library/library_model.h"
#include "widgets/library/library_selection.h"
#include "widgets/library/library_view.h"

namespace gonio::app {

ReferenceDialog::ReferenceDialog(widgets::LibraryModel& library, QWidget* parent)
    : QDialog(parent), m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
  setPurpose(tr("Compare with Another Material"), tr("&Compare"));
  const int em = fontMetrics().height();
  resize(em * 34, em * 30);
  auto* view = new widgets::LibraryView(&library, this);
  view->selection().setSingle();
  view->setEmptyText(tr("There are no materials in this folder."));
  QPushButton* file = m_buttons->addButton(tr("From a &File..."), QDialogButtonBox::ActionRole);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(view, 1);
  layout->addWidget(m_buttons);
  const auto choose = [this](const QString& id) {
    accept();
    Q_EMIT chosen(id);
  };
  connect(&view->selection(), &widgets::LibrarySelection::openRequested, this, choose);
  connect(&view->selection(), &widgets::LibrarySelection::referenceRequested, this, choose);
  connect(m_buttons, &QDialogButtonBox::accepted, this, [=] {
    const QModelIndex index = view->list()->currentIndex();
    if (index.isValid()) choose(index.data(widgets::LibraryModel::IdRole).toString());
  });
  connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(file, &QPushButton::clicked, this, &ReferenceDialog::chooseFile);
}

void ReferenceDialog::setPurpose(const QString& title, const QString& button) {
  setWindowTitle(title);
  m_buttons->button(QDialogButtonBox::Ok)->setText(button);
}

void ReferenceDialog::chooseFile() {
  const QString purpose = QStringLiteral("open");
  auto* dialog = new QFileDialog(this, windowTitle(), widgets::dialogFolder(purpose),
                                 tr("Measured materials (%1);;All files (*)").arg(materialFilePatterns().join(' ')));
  dialog->setFileMode(QFileDialog::ExistingFile);
  widgets::openFileDialog(dialog, [this, purpose](const QString& path) {
    widgets::rememberDialogFolder(purpose, path);
    accept();
    Q_EMIT chosen(path);
  });
}

}  // namespace gonio::app

#include "moc_reference_dialog.cpp"
