// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

/// The checks of the command line that all subcommands share, and what is reported about a wrong one.
namespace gonio::tool {

/// nullopt for NaN, infinities, numbers beyond double precision, and other text.
std::optional<double> finiteNumber(const std::string& text);

/// The check of an option that is parsed when the command runs: rejects the texts for which `parse` throws UsageError.
CLI::Validator parsedBy(const std::function<void(const std::string&)>& parse);

/// Adds a check to every option of `app` and its subcommands that states what was found and what is expected. Those of
/// CLI11 accept NaN in every range, and any number where no range is given. Call it after the options are declared.
void checkValues(CLI::App& app);

/// "edit: --strength: found '2', expected a number from 0 to 1; see goniotool edit --help". @param error of
/// app.parse().
std::string usageMessage(const CLI::App& app, const CLI::ParseError& error);

}  // namespace gonio::tool
