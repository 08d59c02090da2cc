// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDateTime>
#include <QHash>
#include <QString>
#include <QStringList>

namespace gonio::widgets {

/// What the user has noted about a material of a library.
struct LibraryNote {
  static constexpr int highestRating = 5;

  bool favourite = false;
  int rating = 0;  ///< 1 to 5; 0: none
  QStringList tags = {};
  QDateTime opened = {};  ///< at last; null: never

  bool isEmpty() const { return *this == LibraryNote{}; }
  bool operator==(const LibraryNote&) const = default;
};

/// By the id of the material, of any library.
using LibraryNotes = QHash<QString, LibraryNote>;

/// The tags of a text with commas between them, each once, in their order.
QStringList tagsOf(const QString& text);

}  // namespace gonio::widgets
