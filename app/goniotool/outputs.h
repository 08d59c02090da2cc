// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gonio::tool {

/// Refuses a command that would write over a file that it reads: one that its arguments name, or the measured file of
/// a document among them. Of the parsed subcommand; its outputs are `OUT` and the options `--out`,
/// `--image`, `--save`, `--csv` and `--latex`, as they stand there.
/// @throws Error naming the file.
void checkOutputs(const CLI::App& command);

/// The files of an argument: its own, and where it is a document those that it edits, in its blends too.
std::vector<std::filesystem::path> filesOf(const std::string& argument);
/// For commands that make the names of their outputs themselves. @throws Error naming the file where it is one of
/// `files`.
void checkOutput(const std::filesystem::path& out, std::span<const std::filesystem::path> files);

}  // namespace gonio::tool
