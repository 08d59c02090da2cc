// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/usage.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "app/goniotool/tool.h"
#include "core/documents/edit_document.h"
#include "core/materials/material_formats.h"
#include "core/support/text.h"

namespace gonio::tool {

namespace {

constexpr std::size_t helpColumns = 120, maxSetColumns = 100;

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

/// The word for one value of an option, or for all of a fixed number, which its description names: "X Y Z". @param type
/// type_name() of the option, or CLI11's name of its type.
std::string valueWord(const CLI::Option& option, const std::string& type) {
  if (option.get_description().starts_with("Folder")) return "FOLDER";
  if (option.get_group() == outputGroup) return "FILE";
  static const std::regex namedValues("X Y [A-Z]+");
  std::smatch names;
  if (option.get_expected_min() > 1 && std::regex_search(option.get_description(), names, namedValues))
    return names.str();
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
         std::string(documents::documentSuffix) +
         " document, with its edits\n  a bundled material, such as library:merl-copy/chrome or "
         "library:rgl/paper_blue\n";
}

/// "1 to 1e6" for "FLOAT in [1 - 1e+06]", CLI11's description of a range.
std::string rangeWords(const std::string& check) {
  static const std::regex range(R"(.* in \[(.+) - (.+)\])"), exponent("e\\+?(-?)0*");
  if (check == "POSITIVE") return "above 0";
  std::smatch limits;
  if (!std::regex_match(check, limits, range)) return check;
  return std::regex_replace(limits[1].str() + " to " + limits[2].str(), exponent, "e$1");
}

/// What follows an option in its help: "N ... (1 to 20)", "{clamp, filmic}"; for an argument without a dash, "...".
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

}  // namespace

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

namespace {

using Names = std::vector<std::string>;

std::string listText(const Names& names) { return CLI::detail::join(names, ", "); }

/// Edits of one character, or exchanges of two neighbours, that turn one text into the other.
std::size_t typingErrors(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> errors(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      errors[i][j] = std::max(i, j);
      if (i == 0 || j == 0) continue;
      errors[i][j] = std::min(
          {errors[i - 1][j] + 1, errors[i][j - 1] + 1, errors[i - 1][j - 1] + std::size_t(a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        errors[i][j] = std::min(errors[i][j], errors[i - 2][j - 2] + 1);
    }
  return errors[a.size()][b.size()];
}

/// " (did you mean fit?)"; "" if no name is similar.
std::string suggestion(const std::string& found, const Names& names) {
  constexpr std::size_t longestName = 64;
  if (names.empty() || found.size() > longestName) return {};
  const auto nearest = std::ranges::min_element(
      names, {}, [&](const std::string& name) { return typingErrors(lowerCase(found), lowerCase(name)); });
  const std::size_t errors = typingErrors(lowerCase(found), lowerCase(*nearest));
  return 3 * errors > found.size() ? std::string() : " (did you mean " + *nearest + "?)";
}

bool isInteger(const std::string& text, const std::string& type) {
  constexpr int anyBase = 0;  // as CLI11
  char* end = nullptr;
  errno = 0;
  if (type == "UINT") {
    std::strtoull(text.c_str(), &end, anyBase);
    if (text.find('-') != std::string::npos) return false;  // would become a large number
  } else {
    using Limits = std::numeric_limits<int>;
    const long long value = std::strtoll(text.c_str(), &end, anyBase);
    if (value < Limits::min() || value > Limits::max()) return false;
  }
  return !text.empty() && *end == 0 && errno == 0;
}

/// What the values of an option may be.
struct ValueCheck {
  std::string type;       ///< CLI11's name of it
  Names names;            ///< the texts that are allowed; empty: others
  std::string range;      ///< "0 to 1", "above 0"; "": any
  CLI::Validator inside;  ///< of CLI11, for the names or the range

  explicit ValueCheck(CLI::Option& option) : type(option.get_type_name()) {
    const std::size_t colon = type.find(':');
    if (colon == std::string::npos) return;
    const std::string check = type.substr(colon + 1);
    type.resize(colon);
    inside = *option.get_validator(0);
    if (check.starts_with('{'))
      names = CLI::detail::split(check.substr(1, check.size() - 2), ',');
    else
      range = rangeWords(check);
  }

  bool isNumber() const { return type == "FLOAT" || type == "INT" || type == "UINT"; }
  bool accepts(const std::string& text) const {
    if (type == "FLOAT" && !finiteNumber(text)) return false;
    if (type != "FLOAT" && isNumber() && !isInteger(text, type)) return false;
    return inside(text).empty();
  }
  std::string expected() const {
    if (!names.empty()) return listText(names);
    if (!isNumber()) return "a value";
    if (range.empty())
      return type == "FLOAT" ? "a finite number" : type == "INT" ? "an integer" : "an integer, 0 or more";
    return (type == "FLOAT" ? "a number " : "an integer ") + (range.starts_with("above") ? range : "from " + range);
  }
};

/// What is wrong with one value; "" if nothing is.
std::string problemOf(const std::string& text, const ValueCheck& check, const CLI::App& app, bool mayBeEmpty) {
  const auto isOption = [&](const CLI::App* one) { return one && one->get_option_no_throw(text); };
  if (text.starts_with("--") && (isOption(&app) || isOption(app.get_parent())))
    return "found the option " + text + ", expected " + check.expected();
  if (text.empty() && !mayBeEmpty) return "found an empty text, expected " + check.expected();
  if (check.accepts(text)) return {};
  return "found '" + text + "'" + suggestion(text, check.names) + ", expected " + check.expected();
}

Names subcommandNames(const CLI::App& app) {
  Names names;
  for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(one->get_name());
  return names;
}

/// The innermost subcommand on the command line.
const CLI::App& commandOf(const CLI::App& app) {
  return app.get_subcommands().empty() ? app : commandOf(*app.get_subcommands().front());
}

std::string noSubcommand(const CLI::App& command, const Names& left) {
  const Names names = subcommandNames(command);
  const auto word = std::ranges::find_if(left, [](const std::string& one) { return !one.starts_with('-'); });
  if (word == left.end()) return "found no subcommand, expected " + listText(names);
  return "found the subcommand '" + *word + "'" + suggestion(*word, names) + ", expected " + listText(names);
}

/// An option that the command does not have, or an argument too many.
std::string notExpected(const CLI::App& command, const Names& left) {
  const auto option =
      std::ranges::find_if(left, [](const std::string& one) { return one.starts_with('-') && one != "--"; });
  if (option == left.end()) return "found '" + left.front() + "', expected no further argument";
  Names known;
  for (const CLI::App* app = &command; app != nullptr; app = app->get_parent())
    for (const CLI::Option* one : app->get_options())
      for (const std::string& name : one->get_lnames()) known.push_back("--" + name);
  const std::string name = option->substr(0, option->find('='));
  if (std::ranges::find(known, name) != known.end()) return "the option " + name + " belongs behind the subcommand";
  return "unknown option " + name + suggestion(name, known);
}

/// A number of values that the option does not take.
std::string wrongCount(const CLI::Option& option) {
  const auto found = int(option.results().size());
  const int least = option.get_items_expected_min(), most = option.get_items_expected_max();
  if (most == 1 && found > 1) return option.get_name() + " is given " + std::to_string(found) + " times, expected once";
  std::string expected = std::to_string(least);
  if (most > least) expected = most < 1000 ? expected + " to " + std::to_string(most) : "at least " + expected;
  const std::string words = valueText(option);
  return option.get_name() + ": found " + std::to_string(found) + (found == 1 ? " value" : " values") + ", expected " +
         expected + (option.get_positional() ? "" : ": " + words);
}

}  // namespace

std::optional<double> finiteNumber(const std::string& text) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value)) return std::nullopt;
  return value;
}

CLI::Validator parsedBy(const std::function<void(const std::string&)>& parse) {
  return {[parse](std::string& text) {
            try {
              parse(text);
            } catch (const UsageError& error) {
              return std::string(error.what());
            }
            return std::string();
          },
          ""};
}

void checkValues(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_expected_max() == 0) continue;
    const ValueCheck check(*option);
    const bool mayBeEmpty = !option->get_positional() && valueText(*option).starts_with("TEXT");
    option->transform(CLI::Validator(
        [check, &app, mayBeEmpty](std::string& text) { return problemOf(text, check, app, mayBeEmpty); }, ""));
  }
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) checkValues(*command);
}

std::string usageMessage(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = commandOf(app);
  const Names left = app.remaining(true);
  const auto kind = CLI::ExitCodes(error.get_exit_code());
  const bool isAboutValues = kind == CLI::ExitCodes::ValidationError || kind == CLI::ExitCodes::ArgumentMismatch;
  std::string text = error.what();
  const CLI::Option* option = command.get_option_no_throw(text.substr(0, text.find(':')));
  if (kind == CLI::ExitCodes::ArgumentMismatch && option != nullptr)
    text = wrongCount(*option);
  else if (!isAboutValues && !subcommandNames(command).empty())
    text = noSubcommand(command, left);
  else if (kind == CLI::ExitCodes::ExtrasError || (kind == CLI::ExitCodes::RequiredError && !left.empty()))
    text = notExpected(command, left);
  std::string name;
  for (const CLI::App* one = &command; one->get_parent() != nullptr; one = one->get_parent())
    name = one->get_name() + (name.empty() ? "" : " ") + name;
  return (name.empty() ? "" : name + ": ") + text + "; see goniotool " + (name.empty() ? "" : name + " ") + "--help";
}

}  // namespace gonio::tool
