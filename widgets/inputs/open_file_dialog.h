// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFileDialog>
#include <QFileInfo>
#include <functional>

namespace gonio::widgets {

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
