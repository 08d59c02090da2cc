// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/outputs.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/goniotool/materials.h"
#include "core/editing/blend_source.h"

namespace gonio::tool {

namespace {

namespace fs = std::filesystem;

bool isOutput(const CLI::Option& option) {
  constexpr std::array names{"out", "image"};
  return option.get_name(true) == "OUT" ||
         std::ranges::any_of(names, [&](const char* name) { return option.check_lname(name); });
}

/// The files of an argument: its own, and where it is a document those that it edits. A document that cannot be read
/// is refused by the command itself.
std::vector<fs::path> filesOf(const std::string& argument) {
  std::error_code ignored;
  if (!fs::is_regular_file(argument, ignored)) return {};
  std::vector<fs::path> files{argument};
  if (!isDocument(argument)) return files;
  try {
    const editing::EditDocument document = editing::resolved(editing::readDocument(argument), argument);
    for (const fs::path& source : editing::sourceFiles(document)) files.push_back(source);
  } catch (const Error&) {
  }
  return files;
}

}  // namespace

void checkOutputs(const CLI::App& command) {
  std::vector<fs::path> read, written;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& argument : option->results()) {
      if (isOutput(*option))
        written.emplace_back(argument);
      else
        std::ranges::copy(filesOf(argument), std::back_inserter(read));
    }
  std::error_code ignored;
  for (const fs::path& out : written)
    for (const fs::path& in : read)
      if (fs::equivalent(out, in, ignored))
        throw Error(out.string() + ": the command reads this file, expected another name (or --force)");
}

}  // namespace gonio::tool
