// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/formats/merl.h"
#include "core/io/atomic_file.h"

namespace gonio::test {

/// Writes a table as a MERL file, without measuring what that loses.
inline void writeTable(const TabulatedBrdf& table, const std::filesystem::path& path) {
  io::writeFileAtomically(path, formats::encodeMerl(table));
}

}  // namespace gonio::test
