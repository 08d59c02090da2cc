// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <embree3/rtcore.h>

namespace gonio {

/// One for the process: it lives as long as any thread may trace.
RTCDevice embreeDevice();

/// @throws Error with Embree's number where its last call on this thread failed.
void throwIfEmbreeFailed();

}  // namespace gonio
