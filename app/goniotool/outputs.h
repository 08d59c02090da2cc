// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <CLI/CLI.hpp>

namespace gonio::tool {

/// Refuses a command that would write over a file that it reads: one that its arguments name, or the measured file of
/// a document among them. Of the parsed subcommand; its outputs are the options `--out`, `--image` and `OUT`.
/// @throws Error naming the file.
void checkOutputs(const CLI::App& command);

}  // namespace gonio::tool
