// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

/// What all subcommands share: the help, the checks of values, and what is reported about a wrong command line.
namespace gonio::tool {

/// The help of all commands. Values are named by words such as FILE instead of CLI11's types, and ranges are written as
/// "(1 to 20)". Parentheses at the end of the description of an option contain its default, which is printed as
/// "[default: 40]", unless the option is required or they start with a file suffix. Lines are broken at 120 columns.
/// The footer explains MATERIAL if the command has such an argument.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_footer(const CLI::App* command) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_option_usage(const CLI::Option* option) const override;
};

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
