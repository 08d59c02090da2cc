// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/editing/differential_edit.h"

namespace gonio::app {

/// The change of an edit as arguments of `goniotool edit`: "--model ggx --set roughness=0.4 --control tint=1,0.5,0.2
/// --compose lobes". Numbers are exact, with a decimal point in every locale.
QString editArguments(const editing::DifferentialEdit& edit);

}  // namespace gonio::app
