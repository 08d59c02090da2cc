// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStringList>

namespace gonio::app {

/// What files of materials are called: of what a dialog or a folder of the library shows. Files are told by content.
inline QStringList materialFilePatterns() { return {"*.binary", "*.bsdf", "*.pdv", "*.code"}; }

}  // namespace gonio::app
