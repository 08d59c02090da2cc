// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/embree_device.h"

#include <string>

#include "core/support/error.h"

namespace gonio {

RTCDevice embreeDevice() {
  static const RTCDevice shared = rtcNewDevice(nullptr);
  return shared;
}

void throwIfEmbreeFailed() {
  if (const RTCError error = rtcGetDeviceError(embreeDevice()); error != RTC_ERROR_NONE)
    throw Error("mesh: the bounding volumes could not be built (Embree's error " + std::to_string(int(error)) +
                (error == RTC_ERROR_OUT_OF_MEMORY ? ", out of memory)" : ")"));
}

}  // namespace gonio
