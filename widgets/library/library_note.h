// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDateTime>
#include <QHash>
#include <QString>
#include <QStringList>

namespace gonio::widgets {

/// The user's notes about a library material.
struct LibraryNote {
  static constexpr int maxRating = 5;

  bool favourite = false;
  int rating = 0;  ///< 1 to 5; 0: none
  QStringList tags = {};
  QDateTime opened = {};  ///< last time; null: never

  bool isEmpty() const { return *this == LibraryNote{}; }
  bool operator==(const LibraryNote&) const = default;
};

/// Notes by the id of the material, over all libraries.
using LibraryNotes = QHash<QString, LibraryNote>;

/// The tags of a comma-separated text, each once, in order.
QStringList tagsOf(const QString& text);

}  // namespace gonio::widgets
