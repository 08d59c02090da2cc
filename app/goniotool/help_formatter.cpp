// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/help_formatter.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "core/documents/edit_document.h"
#include "core/materials/material_formats.h"

namespace gonio::tool {

namespace {

constexpr std::size_t helpColumns = 120, maxSetColumns = 100;

struct ValueWord {
  std::string_view option, word;
};

/// Words for texts and for lists of fixed length, by the names of their options in all commands.
constexpr ValueWord valueWords[] = {{"baselines", "ID"},
                                    {"basis", "FILE"},
                                    {"checkpoint", "FILE"},
                                    {"components-from", "FILE|FOLDER"},
                                    {"control", "NAME=VALUE"},
                                    {"csv", "FILE"},
                                    {"decode", "FILE"},
                                    {"dictionary", "FILE"},
                                    {"directions", "FILE"},
                                    {"environment", "NAME|FILE"},
                                    {"exclude", "NAME"},
                                    {"font", "NAME"},
                                    {"forbid", "RANGES"},
                                    {"gamma", "NUMBER|auto"},
                                    {"image", "FILE"},
                                    {"inset", "X Y SIZE"},
                                    {"latex", "FILE"},
                                    {"light", "X Y Z"},
                                    {"material", "MATERIAL"},
                                    {"materials", "MATERIAL"},
                                    {"models", "ID"},
                                    {"npf", "FILE"},
                                    {"numbers", "ID"},
                                    {"out", "FILE"},
                                    {"patches-from", "FILE|FOLDER"},
                                    {"plan", "FILE"},
                                    {"predict", "FILE"},
                                    {"representations", "ID"},
                                    {"ridge", "NUMBER|auto"},
                                    {"save", "FILE"},
                                    {"scene", "NAME|FILE"},
                                    {"set", "NAME=VALUE"},
                                    {"shard", "I/N"},
                                    {"size", "N|WIDTHxHEIGHT"},
                                    {"swap-f1", "MATERIAL"},
                                    {"swap-f2", "MATERIAL"},
                                    {"train", "FILE|FOLDER"},
                                    {"uncertainty", "FILE"},
                                    {"values", "FILE"},
                                    {"weights", "FILE"}};

/// Breaks lines at spaces; only a longer word exceeds `columns`.
std::string filledLines(const std::string& text, std::size_t columns, const std::string& indent = {}) {
  std::string result;
  std::size_t column = 0;
  std::istringstream words(text);
  for (std::string word; words >> word; column += word.size()) {
    if (column > 0 && column + 1 + word.size() > columns) {
      result += "\n" + indent;
      column = 0;
    } else if (column > 0) {
      result += ' ';
      ++column;
    }
    result += word;
  }
  return result;
}

/// The word for one value of an option. @param type CLI11's name of its type.
std::string valueWord(const CLI::Option& option, const std::string& type) {
  if (option.get_description().starts_with("Folder")) return "FOLDER";
  if (type == "TEXT" || option.get_expected_min() > 1) {
    const auto known = std::ranges::find_if(
        valueWords, [&](const ValueWord& one) { return option.check_lname(std::string(one.option)); });
    if (known != std::end(valueWords)) return std::string(known->word);
  }
  return type == "INT" || type == "UINT" ? "N" : type == "FLOAT" ? "NUMBER" : type;
}

/// Where the parentheses with the default begin in the description; npos if there are none.
std::size_t defaultPosition(const CLI::Option& option) {
  const std::string& text = option.get_description();
  if (option.get_required() || option.get_expected_max() == 0 || !text.ends_with(')')) return std::string::npos;
  int depth = 0;
  for (std::size_t i = text.size(); i-- > 0;) {
    if (text[i] == ')') ++depth;
    if (text[i] == '(' && --depth == 0) return text[i + 1] == '.' ? std::string::npos : i;
  }
  return std::string::npos;
}

/// ".binary (MERL file), .bsdf (RGL file, Zemax BSDF, LightTools BSDF), ...".
std::string formatsText() {
  std::vector<std::pair<std::string, std::string>> suffixes;
  for (const materials::MaterialFormat* format : materials::materialFormats())
    for (const std::string_view suffix : format->suffixes) {
      const auto known = std::ranges::find_if(suffixes, [&](const auto& one) { return one.first == suffix; });
      if (known == suffixes.end())
        suffixes.emplace_back(suffix, format->label);
      else
        known->second += ", " + std::string(format->label);
    }
  std::string text;
  for (const auto& [suffix, labels] : suffixes) text += (text.empty() ? "" : ", ") + suffix + " (" + labels + ")";
  return text;
}

std::string materialFooter() {
  return "MATERIAL is one of:\n  " +
         filledLines("a file, recognised by its content: " + formatsText(), helpColumns - 4, "    ") +
         "\n  a row of a table of non-parametric factors, such as npf.bin#chrome\n  a " +
         std::string(editing::documentSuffix) +
         " document, with its edits\n  a bundled material, such as library:merl-copy/chrome or "
         "library:rgl/paper_blue\n";
}

}  // namespace

std::string rangeWords(const std::string& check) {
  static const std::regex range(R"(.* in \[(.+) - (.+)\])"), exponent("e\\+?(-?)0*");
  if (check == "POSITIVE") return "above 0";
  std::smatch limits;
  if (!std::regex_match(check, limits, range)) return check;
  return std::regex_replace(limits[1].str() + " to " + limits[2].str(), exponent, "e$1");
}

std::string valueText(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  const std::string check = colon == std::string::npos ? std::string() : type.substr(colon + 1);
  const bool isSet = check.starts_with('{');
  std::string text;
  if (!option.get_positional()) {
    std::string word = isSet ? filledLines(std::regex_replace(check, std::regex(","), ", "), maxSetColumns, "      ")
                             : valueWord(option, type.substr(0, colon));
    if (option.get_expected_min() == 0) word = "[" + word + "]";
    text = word;
  }
  if (option.get_expected_max() > 1 && option.get_expected_max() != option.get_expected_min())
    text += text.empty() ? "..." : " ...";
  if (!check.empty() && !isSet) text += " (" + rangeWords(check) + ")";
  return text;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  std::ostringstream out;
  CLI::detail::format_help(out, command->get_display_name(true),
                           filledLines(command->get_description(), helpColumns - column_width_), column_width_);
  return out.str();
}

std::string HelpFormatter::make_footer(const CLI::App* command) const {
  const auto isMaterial = [](const CLI::Option* option) {
    const std::string name = option->get_name(true);
    return name == "MATERIAL" || name == "A" || option->check_lname("material") || option->check_lname("materials");
  };
  const bool explains = command->get_parent() == nullptr || !command->get_options(isMaterial).empty();
  return (explains ? materialFooter() : std::string()) + command->get_footer() + "\n";
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  std::string text;
  if (option->get_expected_max() > 0) text = valueText(*option);
  if (!text.empty()) text.insert(0, " ");
  if (option->get_required()) text += " REQUIRED";
  const auto addOthers = [&text](const char* label, const std::set<CLI::Option*>& others) {
    if (others.empty()) return;
    text += label;
    for (const CLI::Option* other : others) text += " " + other->get_name();
  };
  addOthers(" Needs:", option->get_needs());
  addOthers(" Excludes:", option->get_excludes());
  return text;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  if (const std::size_t at = defaultPosition(*option); at != std::string::npos)
    text = text.substr(0, at) + "[default: " + text.substr(at + 1, text.size() - at - 2) + "]";
  return filledLines(text, helpColumns - column_width_);
}

std::string HelpFormatter::make_option_usage(const CLI::Option* option) const {
  const std::string name = option->get_name(true) + (option->get_expected_max() > 1 ? "..." : "");
  return option->get_required() ? name : "[" + name + "]";
}

}  // namespace gonio::tool
