// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_selection.h"

#include <QInputDialog>
#include <QKeyEvent>
#include <QListView>
#include <algorithm>
#include <utility>

#include "widgets/inputs/menu_text.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/library/library_model.h"
#include "widgets/library/quick_look.h"

namespace gonio::widgets {

namespace {

void addForOne(QMenu& menu, const QString& id, const LibraryActions& actions) {
  const auto add = [&](const QString& text, const QKeySequence& key, const LibraryActions::One& work) {
    if (work) menu.addAction(text, key, &menu, [work, id] { work(id); });
  };
  add(QMenu::tr("&Open"), Qt::Key_Return, actions.open);
  add(QMenu::tr("&Quick Look"), Qt::Key_Space, actions.look);
  add(QMenu::tr("&Compare with This"), Qt::CTRL | Qt::Key_Return, actions.compare);
  if (actions.qualities.size() < 2) return;
  QMenu* qualities = menu.addMenu(QMenu::tr("Open &Quality"));
  for (const auto& [other, name] : actions.qualities)
    qualities->addAction(menuText(name), qualities, [work = actions.open, other = other] { work(other); });
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
    menu->addAction(single ? QMenu::tr("&Blend with This") : QMenu::tr("&Blend These %1").arg(count),
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

LibrarySelection::LibrarySelection(QListView& list, LibraryModel& model, QWidget& library)
    : QObject(&library), m_list(list), m_model(model), m_look(new QuickLook(&library)) {
  m_list.setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_list.setContextMenuPolicy(Qt::CustomContextMenu);
  m_list.installEventFilter(this);
  connect(&m_list, &QListView::customContextMenuRequested, this, &LibrarySelection::showMenu);
  connect(&m_list, &QListView::doubleClicked, this, &LibrarySelection::openCurrent);
  connect(m_list.selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    if (m_look->isVisible()) showLook();
  });
  connect(m_list.model(), &QAbstractItemModel::modelAboutToBeReset, this, [this] {
    if (const QStringList selected = ids(); !selected.isEmpty()) m_kept = selected;
  });
  connect(m_list.model(), &QAbstractItemModel::modelReset, this, &LibrarySelection::restore);
}

void LibrarySelection::select(const QString& id) {
  m_list.clearSelection();
  m_kept = {id};
  restore();
}

void LibrarySelection::restore() {
  const QStringList wanted = std::exchange(m_kept, {});
  QStringList missing = wanted;
  const QAbstractItemModel& model = *m_list.model();
  for (int row = 0; row < model.rowCount(); ++row) {
    const QModelIndex index = model.index(row, 0);
    const QString id = index.data(LibraryModel::IdRole).toString();
    // The entry of a material stands for all its qualities.
    const QStringList shown = m_model.qualitiesOf(id);
    if (missing.removeIf([&](const QString& one) { return shown.contains(one); }) == 0) continue;
    m_list.selectionModel()->select(index, QItemSelectionModel::Select);
    if (!shown.contains(wanted.front())) continue;
    m_list.selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    m_list.scrollTo(index);
  }
  m_kept = missing;
}

void LibrarySelection::setSingle() {
  m_single = true;
  m_list.setSelectionMode(QAbstractItemView::SingleSelection);
}

QString LibrarySelection::current() const { return m_list.currentIndex().data(LibraryModel::IdRole).toString(); }

void LibrarySelection::openCurrent() {
  if (m_list.currentIndex().isValid()) Q_EMIT openRequested(current());
}

void LibrarySelection::setFavourites(const QStringList& ids, bool favourite) {
  m_model.changeNotes(ids, [&](LibraryNote& note) { note.favourite = favourite; });
}

void LibrarySelection::setRating(const QStringList& ids, int rating) {
  m_model.changeNotes(ids, [&](LibraryNote& note) { note.rating = rating; });
}

void LibrarySelection::editTags(const QStringList& ids) {
  QStringList shared = m_model.note(ids.front()).tags;
  for (const QString& id : ids)
    shared.removeIf([&, own = m_model.note(id).tags](const QString& tag) { return !own.contains(tag); });
  bool accepted = false;
  const QString text = QInputDialog::getText(
      &m_list, tr("Tags"),
      ids.size() == 1 ? tr("Tags of %1, separated by commas:").arg(m_list.currentIndex().data().toString())
                      : tr("Tags common to all %1 materials, separated by commas:").arg(ids.size()),
      QLineEdit::Normal, shared.join(QStringLiteral(", ")), &accepted);
  if (!accepted) return;
  const QStringList wanted = tagsOf(text);
  m_model.changeNotes(ids, [&](LibraryNote& note) {
    note.tags.removeIf([&](const QString& tag) { return shared.contains(tag) || wanted.contains(tag); });
    note.tags << wanted;
  });
}

CommonNotes LibrarySelection::common(const QStringList& ids) const {
  const auto note = [this](const QString& id) { return m_model.note(id); };
  const int rating = note(ids.front()).rating;
  return {std::ranges::all_of(ids, [&](const QString& id) { return note(id).favourite; }),
          std::ranges::all_of(ids, [&](const QString& id) { return note(id).rating == rating; }) ? rating : 0};
}

QStringList LibrarySelection::ids() const {
  QModelIndexList indexes = m_list.selectionModel()->selectedIndexes();
  std::ranges::sort(indexes, {}, &QModelIndex::row);
  QStringList ids;
  for (const QModelIndex& index : indexes) ids << index.data(LibraryModel::IdRole).toString();
  return ids;
}

void LibrarySelection::showMenu(const QPoint& position) {
  const QModelIndex index = m_list.indexAt(position);
  if (!(index.flags() & Qt::ItemIsEnabled)) return;
  if (!m_list.selectionModel()->isSelected(index)) m_list.setCurrentIndex(index);
  const QStringList ids = this->ids();
  LibraryActions actions{.open = [this](const QString& id) { Q_EMIT openRequested(id); },
                         .look = [this](const QString&) { toggleLook(); },
                         .compare = [this](const QString& id) { Q_EMIT referenceRequested(id); },
                         .qualities = qualities(ids.front()),
                         .favour = [this](const QStringList& all, bool on) { setFavourites(all, on); },
                         .rate = [this](const QStringList& all, int rating) { setRating(all, rating); },
                         .tag = [this](const QStringList& all) { editTags(all); }};
  if (!m_single) {
    actions.comparePair = [this](const QStringList& two) { Q_EMIT pairRequested(two[0], two[1]); };
    actions.interpolate = [this](const QStringList& all) { Q_EMIT interpolationRequested(all); };
    actions.study = [this](const QStringList& all) { Q_EMIT studyRequested(all); };
    actions.exportAll = [this](const QStringList& all) { Q_EMIT exportRequested(all); };
  }
  libraryMenu(ids, common(ids), actions, &m_list)->popup(m_list.viewport()->mapToGlobal(position));
}

std::vector<LibraryActions::Quality> LibrarySelection::qualities(const QString& id) const {
  std::vector<LibraryActions::Quality> all;
  for (const QString& other : m_model.qualitiesOf(id)) all.push_back({other, m_model.badge(other)});
  return all;
}

void LibrarySelection::toggleLook() { m_look->isVisible() ? m_look->hide() : showLook(); }

void LibrarySelection::showLook() {
  const QModelIndex index = m_list.currentIndex();
  if (!index.isValid()) return m_look->hide();
  const QString id = index.data(LibraryModel::IdRole).toString();
  const LibraryThumbnail* thumbnail = m_model.thumbnail(id);
  m_look->showMaterial(id, index.data(richToolTipRole).toString(), thumbnail ? thumbnail->image : QImage());
  Q_EMIT largePictureRequested(id);
}

bool LibrarySelection::key(int key, Qt::KeyboardModifiers modifiers) {
  if (key == Qt::Key_Space && !modifiers) {
    toggleLook();
  } else if (key == Qt::Key_Escape && m_look->isVisible()) {
    m_look->hide();
  } else if ((key == Qt::Key_Home || key == Qt::Key_End) && !modifiers) {
    selectOutermost(key == Qt::Key_Home);
  } else {
    const QStringList ids = this->ids();
    return !ids.isEmpty() && keyFor(ids, key, modifiers);
  }
  return true;
}

void LibrarySelection::selectOutermost(bool first) {
  const QAbstractItemModel& model = *m_list.model();
  const int count = model.rowCount();
  for (int i = 0; i < count; ++i) {
    const QModelIndex index = model.index(first ? i : count - 1 - i, 0);
    if (index.flags() & Qt::ItemIsEnabled) return m_list.setCurrentIndex(index);
  }
}

bool LibrarySelection::keyFor(const QStringList& ids, int key, Qt::KeyboardModifiers modifiers) {
  const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
  if (key == Qt::Key_Asterisk) {
    setFavourites(ids, !common(ids).favourites);
  } else if (key >= Qt::Key_0 && key <= Qt::Key_0 + LibraryNote::maxRating) {
    setRating(ids, key - Qt::Key_0);
  } else if (isEnter && modifiers & Qt::ControlModifier) {
    Q_EMIT referenceRequested(current());
  } else if (isEnter && modifiers & Qt::ShiftModifier && !m_single) {
    Q_EMIT interpolationRequested(ids);
  } else if (isEnter) {
    openCurrent();
  } else {
    return false;
  }
  return true;
}

bool LibrarySelection::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut || event->type() == QEvent::Hide) m_look->hide();
  if (event->type() != QEvent::KeyPress) return QObject::eventFilter(watched, event);
  const auto* pressed = static_cast<QKeyEvent*>(event);
  return key(pressed->key(), pressed->modifiers());
}

}  // namespace gonio::widgets

#include "moc_library_selection.cpp"
