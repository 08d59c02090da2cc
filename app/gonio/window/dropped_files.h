// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

namespace gonio::app {

/// Whether a file is meant as an environment, by its name.
bool isPicture(const QString& path);
/// Whether a file is meant as a scene or a mesh, by its name.
bool isScene(const QString& path);
/// What dropping a file will do; a material is taken as the reference of comparisons where `asReference` says so.
QString dropDescription(const QString& path, bool asReference = false);

}  // namespace gonio::app
