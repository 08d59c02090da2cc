// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <vector>

#include "core/formats/code.h"

/// Sparse codes over the bundled dictionary of measured RGL materials (CC0), in tests/data.
namespace gonio::test {

inline std::filesystem::path codeFile(const std::string& name) {
  return std::filesystem::path(GONIO_CODES_DIR) / (name + ".code");
}

inline std::vector<std::filesystem::path> codeFiles() {
  std::vector<std::filesystem::path> files;
  for (const char* name : {"cc_ibiza_sunset", "chm_light_blue", "ilm_solo_m_68", "paper_blue", "vch_golden_yellow"})
    files.push_back(codeFile(name));
  return files;
}

inline dictionary::SparseCode readCodeFile(const std::string& name) { return formats::readCode(codeFile(name)).code; }

}  // namespace gonio::test
