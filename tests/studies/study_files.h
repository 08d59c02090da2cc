// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::study {

/// The files of folders by their extension, folder after folder, those of each in the order of their names: the order
/// in which folds are dealt out.
inline std::vector<std::filesystem::path> filesIn(const std::vector<std::filesystem::path>& folders,
                                                  std::initializer_list<std::string_view> extensions) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& folder : folders) {
    const auto first = std::ptrdiff_t(files.size());
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (std::ranges::find(extensions, entry.path().extension().string()) != extensions.end())
        files.push_back(entry.path());
    std::ranges::sort(files.begin() + first, files.end(), {}, [](const auto& file) { return file.stem(); });
  }
  return files;
}

/// The parts between the commas.
inline std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

}  // namespace gonio::study
