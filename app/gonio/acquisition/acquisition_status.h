// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/acquisition/acquisition_controls.h"

namespace gonio::app {

/// Whether a start would stop the work in progress: with other settings than those at work it starts anew instead.
bool startCancels(const AcquisitionSession& session, const AcquisitionControls& controls);

/// What an acquisition does, or what can be done next.
QString acquisitionStatus(const AcquisitionSession& session, const AcquisitionControls& controls);

}  // namespace gonio::app
