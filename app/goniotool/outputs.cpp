// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/outputs.h"

#include <algorithm>
#include <filesystem>

#include "app/goniotool/tool.h"
#include "core/documents/open_material.h"
#include "core/io/atomic_file.h"

namespace gonio::tool {

namespace {

namespace fs = std::filesystem;

}  // namespace

void checkOutput(const fs::path& out, std::span<const fs::path> files) {
  if (io::isOneOf(out, files))
    throw Error(out.string() + ": the command reads this file, expected another name (or --force)");
}

void checkOutputs(const CLI::App& command) {
  std::vector<fs::path> read, written;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& argument : option->results()) {
      if (option->get_group() == outputGroup)
        written.emplace_back(argument);
      else
        std::ranges::copy(documents::filesOf(argument), std::back_inserter(read));
    }
  for (const fs::path& out : written) checkOutput(out, read);
}

}  // namespace gonio::tool
