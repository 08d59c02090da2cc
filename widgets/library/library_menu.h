// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>
#include <functional>

namespace gonio::widgets {

/// What can be done with the materials that are selected in a library: of one, of two, of several. An entry without
/// a function is left out.
struct LibraryActions {
  using One = std::function<void(const QString& id)>;
  using Several = std::function<void(const QStringList& ids)>;

  One open, look, compare;
  Several comparePair;  ///< of two ids
  Several interpolate, exportAll;
  std::function<void(const QStringList& ids, bool favourite)> favour;
};

/// A menu that deletes itself when it closes. @param favourites whether all of the materials are favourites.
QMenu* libraryMenu(const QStringList& ids, bool favourites, const LibraryActions& actions, QWidget* parent);

}  // namespace gonio::widgets
