// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

namespace gonio::app {

/// Whether a file is an environment image, by its suffix.
bool isEnvironmentFile(const QString& path);
/// Whether a file is a scene or a mesh, by its suffix.
bool isScene(const QString& path);
/// Describes the effect of dropping a file. @param asReference whether a material becomes the reference of comparisons.
QString dropDescription(const QString& path, bool asReference = false);

}  // namespace gonio::app
