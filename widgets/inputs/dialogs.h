// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPointer>
#include <QString>
#include <functional>

namespace gonio::widgets {

/// Asks a question and waits for the answer. This is safe if the parent is deleted meanwhile; the answer is then No.
/// QMessageBox::question() is not, because its box is on the stack.
inline bool ask(QWidget* parent, const QString& title, const QString& question) {
  const QPointer<QMessageBox> box =
      new QMessageBox(QMessageBox::Question, title, question, QMessageBox::Yes | QMessageBox::No, parent);
  const bool yes = box->exec() == QMessageBox::Yes;
  delete box;
  return yes;
}

/// The start folder of file dialogs for a purpose ("open", "export", "environment"): the last chosen folder, from the
/// settings; the home folder if there is none or it does not exist.
QString dialogFolder(const QString& purpose);
/// The path of a proposed file name in that folder.
QString inDialogFolder(const QString& purpose, const QString& fileName);
/// Stores the folder of a chosen file; no effect for an empty path.
void rememberDialogFolder(const QString& purpose, const QString& chosenFile);

/// Shows a file dialog with a parent, and returns immediately. (The static functions of QFileDialog run an event loop
/// with the dialog on the stack, which fails if the parent is deleted meanwhile.) The dialog deletes itself; `chosen`
/// receives the selected file or folder unless the parent was deleted.
inline void openFileDialog(QFileDialog* dialog, std::function<void(const QString& path)> chosen) {
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &QFileDialog::fileSelected, dialog->parentWidget(), std::move(chosen));
  dialog->open();
}

/// A dialog for the name of a file to write, with a proposed path. It does not ask before replacing files.
inline QFileDialog* newSaveDialog(QWidget* parent, const QString& title, const QString& path) {
  const QFileInfo proposed(path);
  auto* dialog = new QFileDialog(parent, title, proposed.path());
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setOption(QFileDialog::DontConfirmOverwrite);
  dialog->selectFile(proposed.fileName());
  return dialog;
}

/// Asks for the name of a file to write, with a proposed path; `chosen` receives a path with the suffix of `path`.
inline void askForPath(QWidget* parent, const QString& title, const QString& path, const QString& filter,
                       std::function<void(const QString& path)> chosen) {
  const QFileInfo proposed(path);
  auto* dialog = new QFileDialog(parent, title, proposed.path(), filter);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(proposed.suffix());
  dialog->selectFile(proposed.fileName());
  openFileDialog(dialog, [chosen = std::move(chosen), suffix = '.' + proposed.suffix()](const QString& file) {
    chosen(file.endsWith(suffix, Qt::CaseInsensitive) ? file : file + suffix);
  });
}

}  // namespace gonio::widgets
