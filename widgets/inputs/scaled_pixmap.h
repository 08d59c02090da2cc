// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPixmap>

namespace gonio::widgets {

/// A picture at a size in its own aspect: averaged over areas, which drawing a large pixmap small is not, and kept, so
/// that it can be drawn at every paint.
QPixmap scaledPixmap(const QPixmap& pixmap, const QSize& size);

}  // namespace gonio::widgets
