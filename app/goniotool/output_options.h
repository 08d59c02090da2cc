// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>

namespace gonio::tool {

/// The options that name files to write, without dashes, in all subcommands. All other options, and all arguments but
/// OUT, are inputs.
inline constexpr std::array outputOptions{"out", "image", "save", "csv", "latex", "predict", "decode", "uncertainty"};

}  // namespace gonio::tool
