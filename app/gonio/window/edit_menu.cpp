// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/edit_menu.h"

#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QMimeData>
#include <QSettings>
#include <QSpinBox>

#include "app/gonio/document/document_controller.h"
#include "app/gonio/document/edit_steps.h"
#include "app/gonio/document/edit_transfer.h"
#include "app/gonio/inspector/inspector.h"
#include "widgets/parameters/control_panel.h"
#include "widgets/parameters/parameter_panel.h"

namespace gonio::app {

namespace {
const QString historyLimitKey = QStringLiteral("history/megabytes");
constexpr int defaultHistoryMegabytes = int(History::defaultByteLimit >> 20);
}  // namespace

EditMenu::EditMenu(Document& document, DocumentController& controller, const Inspector& inspector, QSettings& settings,
                   QAction* showHistory, QWidget* window)
    : QMenu(tr("&Edit"), window),
      m_document(document),
      m_controller(controller),
      m_inspector(inspector),
      m_settings(settings) {
  addHistory(showHistory);
  addSeparator();
  addEdits();
  addSeparator();
  addAction(tr("&Preferences..."), QKeySequence(Qt::CTRL | Qt::Key_Comma), this, &EditMenu::showPreferences);
  applyHistoryLimit();
}

int EditMenu::historyMegabytes() const {
  return std::max(1, m_settings.value(historyLimitKey, defaultHistoryMegabytes).toInt());
}

void EditMenu::applyHistoryLimit() { m_document.history().setByteLimit(std::size_t(historyMegabytes()) << 20); }

void EditMenu::addHistory(QAction* showHistory) {
  History& history = m_document.history();
  QAction* undo = history.createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = history.createRedoAction(this, tr("&Redo"));
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  addActions({undo, redo, showHistory});
}

void EditMenu::addEdits() {
  Document& document = m_document;
  QAction* copy = addAction(tr("&Copy Edits"), QKeySequence::Copy, this, [&document] {
    QApplication::clipboard()->setMimeData(toClipboard(document.toEditDocument()));
  });
  QAction* paste = addAction(tr("&Paste Edits"), QKeySequence::Paste, this,
                             [this] { m_controller.paste(editsFromClipboard(QApplication::clipboard()->mimeData())); });
  addSeparator();
  QAction* reset = addAction(tr("Reset Pa&rameter"), QKeySequence(Qt::Key_Backspace), this, [this, &document] {
    if (const auto control = m_inspector.controls()->currentControl()) return resetControl(document, *control);
    const int parameter = m_inspector.parameters()->currentParameter();
    if (parameter >= 0) resetParameter(document, parameter);
  });
  reset->setToolTip(tr("Resets the parameter under the pointer or with the focus"));
  QAction* resetAll = addAction(tr("Reset &All"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Backspace), this,
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
  QDialog dialog(parentWidget());
  dialog.setWindowTitle(tr("Preferences"));
  auto* megabytes = new QSpinBox(&dialog);
  megabytes->setRange(1, 1 << 14);
  megabytes->setSuffix(tr(" MB"));
  megabytes->setValue(historyMegabytes());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* form = new QFormLayout(&dialog);
  form->addRow(tr("Undo &memory"), megabytes);
  form->addRow(buttons);
  if (dialog.exec() != QDialog::Accepted) return;
  m_settings.setValue(historyLimitKey, megabytes->value());
  applyHistoryLimit();
}

}  // namespace gonio::app

#include "moc_edit_menu.cpp"
