// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/edit_menu.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>
#include <QSettings>

#include "app/gonio/document/document_controller.h"
#include "app/gonio/document/edit_steps.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/window/preferences.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/parameters/control_panel.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

EditMenu::EditMenu(Document& document, DocumentController& controller, const Inspector& inspector,
                   const widgets::PreviewWidget& preview, QSettings& settings, QAction* showHistory, QWidget* window)
    : QMenu(tr("&Edit"), window),
      m_document(document),
      m_controller(controller),
      m_inspector(inspector),
      m_preview(preview),
      m_settings(settings) {
  addHistory(showHistory);
  addSeparator();
  addEdits();
  addSeparator();
  addAction(tr("&Preferences..."), QKeySequence(Qt::CTRL | Qt::Key_Comma), this, &EditMenu::showPreferences);
  apply(Preferences::read(settings));
}

void EditMenu::apply(const Preferences& preferences) {
  m_document.history().setByteLimit(std::size_t(preferences.historyMegabytes) << 20);
  limitThreads(preferences.threads);
  widgets::setRoughnessDisplay(preferences.roughness);
}

void EditMenu::addHistory(QAction* showHistory) {
  History& history = m_document.history();
  // Qt's own actions take '&' in the name of an edit for the mark of a key.
  QAction* undo = addAction(tr("&Undo"), QKeySequence::Undo, &history, &QUndoStack::undo);
  QAction* redo = addAction(tr("&Redo"), &history, &QUndoStack::redo);
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  const auto show = [=, &history] {
    undo->setText(tr("&Undo %1").arg(widgets::menuText(history.undoText())).trimmed());
    redo->setText(tr("&Redo %1").arg(widgets::menuText(history.redoText())).trimmed());
    undo->setEnabled(history.canUndo());
    redo->setEnabled(history.canRedo());
  };
  for (const auto signal : {&QUndoStack::canUndoChanged, &QUndoStack::canRedoChanged})
    connect(&history, signal, this, show);
  for (const auto signal : {&QUndoStack::undoTextChanged, &QUndoStack::redoTextChanged})
    connect(&history, signal, this, show);
  show();
  addAction(showHistory);
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
    if (const auto diffuse = m_inspector.controls()->currentDiffuseParameter())
      return resetParameter(document, *diffuse);
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
  const Preferences before = Preferences::read(m_settings);
  auto* dialog = new PreferencesDialog(before, m_preview.graphics(), parentWidget());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, before] { adopt(dialog->preferences(), before); });
  dialog->open();
}

void EditMenu::adopt(const Preferences& chosen, const Preferences& before) {
  chosen.write(m_settings);
  apply(chosen);
  if (chosen.theme != before.theme) applyTheme(*qApp, chosen.theme);
  if (chosen.roughness == before.roughness) return;
  for (const QWidget* window : QApplication::topLevelWidgets())
    for (auto* panel : window->findChildren<widgets::ParameterPanel*>()) panel->showUnits();
}

}  // namespace gonio::app

#include "moc_edit_menu.cpp"
