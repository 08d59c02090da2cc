// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

class QMimeData;

namespace gonio::widgets {

/// The data of a dragged library material: its id, and for other programs its file, if it has one.
QMimeData* toDrag(const QString& id);

/// The content of a drag: the id of a library material, else the first local file; empty if there is neither.
QString draggedFile(const QMimeData* data);
/// All files of a drag from another program; empty for a material of the library.
QStringList draggedFiles(const QMimeData* data);
/// The same if it is a material or a document, by suffix or content; else empty.
QString draggedMaterial(const QMimeData* data);

}  // namespace gonio::widgets
