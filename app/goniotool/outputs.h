// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gonio::tool {

/// Checks that a parsed subcommand does not overwrite a file that it reads: one of its arguments, or a file used by a
/// document among them. The outputs are the options and arguments of outputGroup, without added suffixes.
/// @throws Error that names the file.
void checkOutputs(const CLI::App& command);

/// For commands that construct the names of their outputs. @throws Error that names the file if it is one of `files`.
void checkOutput(const std::filesystem::path& out, std::span<const std::filesystem::path> files);

}  // namespace gonio::tool
