// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/file_exports.h"

namespace gonio::app {

class ComparisonController;

/// The numbers of the current comparison as a line below a picture: "gold-paint, Edited against Measured: BRDF SNR 23.4
/// dB, ...".
/// They are measured when the caption is called, in about a second. Not for the GUI thread.
FileExports::Caption comparisonCaption(const ComparisonController& comparison, const QString& material);

}  // namespace gonio::app
