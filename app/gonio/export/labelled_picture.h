// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/file_exports.h"

namespace gonio::app {

class ComparisonController;

/// The numbers of what is compared now, as a line below a picture: "gold-paint, Edited
/// against Measured: BRDF SNR 23.4 dB, ...".
/// They are measured when the caption is asked for, not on the GUI thread, in about a second.
FileExports::Caption comparisonCaption(const ComparisonController& comparison, const QString& material);

}  // namespace gonio::app
