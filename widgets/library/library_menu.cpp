// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_menu.h"

#include "widgets/library/library_note.h"

namespace gonio::widgets {

namespace {

void addForOne(QMenu& menu, const QString& id, const LibraryActions& actions) {
  const auto add = [&](const QString& text, const QKeySequence& key, const LibraryActions::One& work) {
    if (work) menu.addAction(text, key, &menu, [work, id] { work(id); });
  };
  add(QMenu::tr("&Open"), Qt::Key_Return, actions.open);
  add(QMenu::tr("&Quick Look"), Qt::Key_Space, actions.look);
  add(QMenu::tr("&Compare with This"), Qt::CTRL | Qt::Key_Return, actions.compare);
}

void addRatings(QMenu& menu, const QStringList& ids, int rating, const LibraryActions& actions) {
  QMenu* ratings = menu.addMenu(QMenu::tr("&Rating"));
  for (int stars = 0; stars <= LibraryNote::maxRating; ++stars) {
    QAction* action = ratings->addAction(stars == 0 ? QMenu::tr("None") : QString(stars, QChar(0x2605)),
                                         Qt::Key(Qt::Key_0 + stars), ratings, [=] { actions.rate(ids, stars); });
    action->setCheckable(true);
    action->setChecked(stars == rating);
  }
}

}  // namespace

QMenu* libraryMenu(const QStringList& ids, const CommonNotes& common, const LibraryActions& actions, QWidget* parent) {
  auto* menu = new QMenu(parent);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const bool single = ids.size() == 1;
  const QString count = QString::number(ids.size());
  if (single) addForOne(*menu, ids.front(), actions);
  if (ids.size() == 2 && actions.comparePair)
    menu->addAction(QMenu::tr("&Compare These 2"), menu, [=] { actions.comparePair(ids); });
  if (actions.interpolate)
    menu->addAction(single ? QMenu::tr("&Interpolate with This") : QMenu::tr("&Interpolate These %1").arg(count),
                    Qt::SHIFT | Qt::Key_Return, menu, [=] { actions.interpolate(ids); });
  if (!single && actions.study)
    menu->addAction(QMenu::tr("&Measure Representations of These %1...").arg(count), menu, [=] { actions.study(ids); });
  if (actions.exportAll)
    menu->addAction(single ? QMenu::tr("&Export...") : QMenu::tr("&Export These %1...").arg(count), menu,
                    [=] { actions.exportAll(ids); });
  menu->addSeparator();
  QAction* favourite = menu->addAction(single ? QMenu::tr("&Favourite") : QMenu::tr("&Favourites"), Qt::Key_Asterisk,
                                       menu, [=] { actions.favour(ids, !common.favourites); });
  favourite->setCheckable(true);
  favourite->setChecked(common.favourites);
  if (actions.rate) addRatings(*menu, ids, common.rating, actions);
  if (actions.tag) menu->addAction(QMenu::tr("&Tags..."), menu, [=] { actions.tag(ids); });
  return menu;
}

}  // namespace gonio::widgets
