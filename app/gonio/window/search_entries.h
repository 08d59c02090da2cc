// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/window/command_search.h"

class QWidget;

namespace gonio::app {

class DocumentFiles;
struct EditorParts;

/// Entries of the search in addition to the commands: sliders, models, scenes, lights, the current materials of the
/// library, and the pages of the guide.
std::vector<SearchEntry> searchEntries(EditorParts& parts, DocumentFiles& files, QWidget& window);

}  // namespace gonio::app
