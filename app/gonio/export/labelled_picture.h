// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/file_exports.h"

namespace gonio::app {

class ComparisonController;

/// A function that measures the numbers of the current comparison, for a line below a picture: "gold-paint, Edited
/// against Measured: BRDF SNR 23.4 dB; ...". The function takes about a second; call it outside the GUI thread.
FileExports::Caption comparisonCaption(const ComparisonController& comparison, const QString& material);

}  // namespace gonio::app
