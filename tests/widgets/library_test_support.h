// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QListView>

#include "widgets/library/library_model.h"
#include "widgets/library/library_view.h"

namespace gonio::test {
using widgets::LibraryItem, widgets::LibraryThumbnail, widgets::LibraryModel, widgets::LibraryView;

inline std::vector<LibraryItem> threeMaterials() {
  return {{"a", "gold", "MERL file"}, {"b", "chrome", "MERL file"}, {"c", "felt", "RGL file"}};
}
inline LibraryThumbnail makeThumbnail(double hue, double roughness) {
  QImage image(8, 8, QImage::Format_RGBA8888);
  image.fill(Qt::gray);
  return {image, hue, roughness};
}
/// Of the materials that are shown, in order.
inline QStringList idsOf(const LibraryView& view) {
  QStringList ids;
  for (int row = 0; row < view.list()->model()->rowCount(); ++row)
    if (const QModelIndex index = view.list()->model()->index(row, 0); index.flags() & Qt::ItemIsEnabled)
      ids << index.data(LibraryModel::IdRole).toString();
  return ids;
}

}  // namespace gonio::test
