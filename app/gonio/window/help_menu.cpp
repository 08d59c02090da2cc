// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/help_menu.h"

#include "app/gonio/window/guide.h"
#include "app/gonio/window/help_pages.h"

namespace gonio::app {

HelpMenu::HelpMenu(QWidget* window, const std::function<std::vector<SearchEntry>()>& others)
    : QMenu(tr("&Help"), window) {
  addAction(tr("&Search..."), QKeySequence(Qt::CTRL | Qt::Key_K), this, [window, others] {
    auto* search = new CommandSearch(window, others());
    search->setAttribute(Qt::WA_DeleteOnClose);
    search->show();
  });
  addAction(tr("&Guide"), this, [window] { openGuide(window, guidePages().front().file); });
  QAction* shortcuts =
      addAction(tr("S&hortcuts"), this, [window] { showPage(tr("Shortcuts"), shortcutsPage(window), window); });
  shortcuts->setShortcuts({QKeySequence(Qt::Key_F1), QKeySequence(Qt::Key_Question)});
  addAction(tr("&Formulae"), this, [window] { showPage(tr("Formulae"), formulaePage(), window); });
  addSeparator();
  addAction(tr("&About Gonio"), this, [window] { showPage(tr("About Gonio"), aboutPage(), window); });
}

}  // namespace gonio::app

#include "moc_help_menu.cpp"
