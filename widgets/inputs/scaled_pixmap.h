// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPixmap>

namespace gonio::widgets {

/// A pixmap scaled to a size with the same aspect ratio, averaged over areas (unlike painting a large pixmap small).
/// Cached, so that it can be called in every paint event.
QPixmap scaledPixmap(const QPixmap& pixmap, const QSize& size);

}  // namespace gonio::widgets
