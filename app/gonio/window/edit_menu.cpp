// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/edit_menu.h"

#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFormLayout>
#include <QMenuBar>
#include <QMimeData>
#include <QSpinBox>

#include "app/gonio/document/edit_steps.h"
#include "app/gonio/document/edit_transfer.h"
#include "app/gonio/window/main_window.h"
#include "widgets/parameters/parameter_panel.h"

namespace gonio::app {

namespace {
const QString historyLimitKey = QStringLiteral("history/megabytes");
constexpr int defaultHistoryMegabytes = int(History::defaultByteLimit >> 20);

void applyHistoryLimit(MainWindow& window) {
  const int megabytes = window.settings().value(historyLimitKey, defaultHistoryMegabytes).toInt();
  window.document().history().setByteLimit(std::size_t(std::max(1, megabytes)) << 20);
}
}  // namespace

EditMenu::EditMenu(MainWindow& window) : QObject(&window), m_window(window) {
  QMenu* menu = window.menuBar()->addMenu(tr("&Edit"));
  addHistory(menu);
  menu->addSeparator();
  addEdits(menu);
  menu->addSeparator();
  menu->addAction(tr("&Preferences..."), QKeySequence(Qt::CTRL | Qt::Key_Comma), this, &EditMenu::showPreferences);
  applyHistoryLimit(window);
}

void EditMenu::addHistory(QMenu* menu) {
  History& history = m_window.document().history();
  QAction* undo = history.createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = history.createRedoAction(this, tr("&Redo"));
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  menu->addActions({undo, redo});
  for (QDockWidget* dock : m_window.docks())
    if (dock->objectName() == "history") menu->addAction(dock->toggleViewAction());
}

void EditMenu::addEdits(QMenu* menu) {
  Document& document = m_window.document();
  QAction* copy = menu->addAction(tr("&Copy Edits"), QKeySequence::Copy, this, [&document] {
    QApplication::clipboard()->setMimeData(toClipboard(document.toEditDocument()));
  });
  QAction* paste = menu->addAction(tr("&Paste Edits"), QKeySequence::Paste, this, [this] {
    m_window.controller().paste(editsFromClipboard(QApplication::clipboard()->mimeData()));
  });
  menu->addSeparator();
  QAction* reset = menu->addAction(tr("Reset Pa&rameter"), QKeySequence(Qt::Key_Backspace), this, [this, &document] {
    const int parameter = m_window.inspector().parameters()->currentParameter();
    if (parameter >= 0) resetParameter(document, parameter);
  });
  reset->setToolTip(tr("Resets the parameter under the pointer or with the focus"));
  QAction* resetAll = menu->addAction(tr("Reset &All"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Backspace), this,
                                      [&document] { resetParameters(document); });
  const auto update = [=, this, &document] {
    const auto* edit = document.active<editing::DifferentialEdit>();
    copy->setEnabled(!document.edits().empty());
    paste->setEnabled(document.material() && m_pasteable);
    reset->setEnabled(edit);
    resetAll->setEnabled(edit && !edit->isIdentity());
  };
  connect(&document, &Document::stateChanged, this, update);
  connect(&document, &Document::selectionChanged, this, update);
  connect(&document, &Document::editChanged, this, update);
  const auto look = [this, update] {
    m_pasteable = !editsFromClipboard(QApplication::clipboard()->mimeData()).empty();
    update();
  };
  connect(QApplication::clipboard(), &QClipboard::dataChanged, this, look);
  look();
}

void EditMenu::showPreferences() {
  QDialog dialog(&m_window);
  dialog.setWindowTitle(tr("Preferences"));
  auto* megabytes = new QSpinBox(&dialog);
  megabytes->setRange(1, 1 << 14);
  megabytes->setSuffix(tr(" MB"));
  megabytes->setValue(m_window.settings().value(historyLimitKey, defaultHistoryMegabytes).toInt());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* form = new QFormLayout(&dialog);
  form->addRow(tr("&Memory of the undo history"), megabytes);
  form->addRow(buttons);
  if (dialog.exec() != QDialog::Accepted) return;
  m_window.settings().setValue(historyLimitKey, megabytes->value());
  applyHistoryLimit(m_window);
}

}  // namespace gonio::app

#include "moc_edit_menu.cpp"
