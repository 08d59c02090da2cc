// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMessageBox>
#include <QPointer>

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

}  // namespace gonio::widgets
