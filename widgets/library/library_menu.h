// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>
#include <functional>

namespace gonio::widgets {

/// Actions for the selected materials of a library: for one, two, or several. Entries without a function are omitted.
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

/// Common properties of the selected materials; false or 0 if they differ.
struct CommonNotes {
  bool favourites = false;
  int rating = 0;
};

/// A menu that deletes itself when it closes.
QMenu* libraryMenu(const QStringList& ids, const CommonNotes& common, const LibraryActions& actions, QWidget* parent);

}  // namespace gonio::widgets
