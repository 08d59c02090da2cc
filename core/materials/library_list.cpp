// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/library_list.h"

#include <algorithm>

#include "core/io/csv_text.h"

namespace gonio::materials {

const std::vector<LibraryRow>& libraryRows() {
  static const std::vector<LibraryRow> rows = [] {
    const io::CsvText csv = io::readCsvText(libraryListText());
    const std::size_t source = csv.requiredColumn("source"), name = csv.requiredColumn("name"),
                      kind = csv.requiredColumn("kind"), snr = csv.requiredColumn("rendered_snr");
    std::vector<LibraryRow> result;
    for (const io::CsvText::Row& row : csv.rows) {
      LibraryRow& read = result.emplace_back(LibraryRow{row.fields[source], row.fields[name], row.fields[kind], {}});
      if (!row.fields[snr].empty()) read.renderedSnr = csv.number(row, snr);
    }
    return result;
  }();
  return rows;
}

std::string libraryKind(std::string_view source, std::string_view name) {
  const auto& rows = libraryRows();
  const auto found =
      std::ranges::find_if(rows, [&](const LibraryRow& row) { return row.source == source && row.name == name; });
  return found == rows.end() ? std::string() : found->kind;
}

}  // namespace gonio::materials
