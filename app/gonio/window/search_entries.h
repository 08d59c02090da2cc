// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/window/command_search.h"

class QWidget;

namespace gonio::app {

class DocumentFiles;
struct EditorParts;

/// What the search finds beside the commands: the materials of the library, the sliders, the scenes and the lights, as
/// they are now, and the pages of the guide.
std::vector<SearchEntry> searchEntries(EditorParts& parts, DocumentFiles& files, QWidget& window);

}  // namespace gonio::app
