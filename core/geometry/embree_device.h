// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <embree3/rtcore.h>

namespace gonio {

/// The Embree device of the process; it exists until the process ends.
RTCDevice embreeDevice();

/// @throws Error with Embree's error number if its last call on this thread failed.
void throwIfEmbreeFailed();

}  // namespace gonio
