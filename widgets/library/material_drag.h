// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

class QMimeData;

namespace gonio::widgets {

/// What a drag of a library's material carries: its id, and its file where it is one, for other programs.
QMimeData* toDrag(const QString& id);

/// What a drag names: the id of a library's material, else the first local file; empty when it is neither.
QString draggedFile(const QMimeData* data);
/// The same where it is a material or a document, by its suffix or its content; else empty.
QString draggedMaterial(const QMimeData* data);

}  // namespace gonio::widgets
