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
  Several comparePair;                    ///< of two ids
  Several interpolate, study, exportAll;  ///< study: of two or more ids
  std::function<void(const QStringList& ids, bool favourite)> favour;
  std::function<void(const QStringList& ids, int rating)> rate;
  Several tag;
};

/// What all of the selected materials have: false, and 0, where they differ.
struct LibraryCommon {
  bool favourites = false;
  int rating = 0;
};

/// A menu that deletes itself when it closes.
QMenu* libraryMenu(const QStringList& ids, const LibraryCommon& common, const LibraryActions& actions, QWidget* parent);

}  // namespace gonio::widgets
