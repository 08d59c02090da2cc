// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gonio::tool {

/// The text of a page of the documentation, complete: each line "<!-- options: NAME -->" is replaced by the table of
/// the options of a subcommand (of goniotool itself, with its name), each line "<!-- table: NAME -->" by a table of
/// records of core: "models", "metrics", "image-metrics", "baselines", "targets", "scenes" or "figures". The build
/// writes the pages of the guide so (cmake/Pages.cmake). @throws Error for a name that does not exist.
std::string completePage(const CLI::App& app, const std::string& text);

/// The figures that goniotool reproduce makes, with their printed values and times.
std::string figureTable();
/// The bundled scenes with the effects that they need.
std::string sceneTable();

}  // namespace gonio::tool
