// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::test {

using SpreadsheetRows = std::vector<std::vector<std::string>>;

/// The cells of a CSV text as spreadsheets read them (RFC 4180): comment lines are rows like any other.
inline SpreadsheetRows spreadsheetRows(std::string_view text, char separator = ',') {
  SpreadsheetRows rows;
  while (!text.empty()) {
    std::vector<std::string>& row = rows.emplace_back();
    for (bool isRow = true; isRow;) {
      std::string& cell = row.emplace_back();
      if (text.starts_with('"')) {
        text.remove_prefix(1);
        while (!text.empty() && (!text.starts_with('"') || text.starts_with("\"\""))) {
          if (text.starts_with('"')) text.remove_prefix(1);
          cell += text.front();
          text.remove_prefix(1);
        }
        if (!text.empty()) text.remove_prefix(1);
      }
      while (!text.empty() && text.front() != separator && text.front() != '\n' && text.front() != '\r') {
        cell += text.front();
        text.remove_prefix(1);
      }
      isRow = text.starts_with(separator);
      if (!text.empty()) text.remove_prefix(1);
    }
  }
  return rows;
}

/// Whether a spreadsheet calculates a cell: it begins like a formula and is no number.
inline bool isCalculated(const std::string& cell) {
  const auto begin = cell.find_first_not_of(' ');
  if (begin == std::string::npos || std::string_view("=+-@\t\r").find(cell[begin]) == std::string_view::npos)
    return false;
  char* end = nullptr;
  std::strtod(cell.c_str(), &end);
  return end != cell.c_str() + cell.size();
}

inline bool hasCalculatedCell(const SpreadsheetRows& rows) {
  for (const auto& row : rows)
    for (const std::string& cell : row)
      if (isCalculated(cell)) return true;
  return false;
}

}  // namespace gonio::test
