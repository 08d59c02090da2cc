// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

namespace gonio::exports {

/// The field `description` of a written RGL file: origin, incident direction and accuracy. @param snr rendered SNR, dB.
/// @param clipped number of negative values that were set to 0.
std::string describe(const std::string& origin, double snr, std::size_t clipped);

}  // namespace gonio::exports
