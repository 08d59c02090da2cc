// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/editing/differential_edit.h"

namespace gonio::app {

/// What an edit changes as arguments of `goniotool edit`: "--model ggx --set roughness=0.4 --control tint=1,0.5,0.2
/// --compose lobes". Numbers keep every bit, with a point in every language.
QString editArguments(const editing::DifferentialEdit& edit);

}  // namespace gonio::app
