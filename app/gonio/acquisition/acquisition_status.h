// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/acquisition/acquisition_controls.h"

namespace gonio::app {

/// Whether the start button would stop the work in progress. If the settings changed meanwhile, it restarts the work
/// instead.
bool startCancels(const AcquisitionSession& session, const AcquisitionControls& controls);

/// Description of the running step, or of the possible next step.
QString acquisitionStatus(const AcquisitionSession& session, const AcquisitionControls& controls);

}  // namespace gonio::app
