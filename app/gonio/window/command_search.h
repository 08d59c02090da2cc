// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>

class QAction;
class QLineEdit;
class QListWidget;

namespace gonio::app {

/// Every action of a window that has a text, by menu: path is "File > Open Recent > a.binary".
struct NamedAction {
  QString path;
  QAction* action;
};
QList<NamedAction> allActions(const QWidget* window);

/// Finds an action by typing parts of its name, and runs it.
class CommandSearch : public QDialog {
  Q_OBJECT

 public:
  explicit CommandSearch(QWidget* window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void filter(const QString& text);
  void runCurrent();

  QList<NamedAction> m_actions;
  QLineEdit* m_text;
  QListWidget* m_list;
};

}  // namespace gonio::app
