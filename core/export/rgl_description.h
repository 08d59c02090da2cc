// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

namespace gonio::exports {

/// The field `description` of a file that was written: its origin, the slot of the directions, how near it is.
std::string describe(const std::string& origin, double snr, std::size_t clipped);

}  // namespace gonio::exports
