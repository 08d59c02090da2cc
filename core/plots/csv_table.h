// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

namespace gonio::plots {

struct CsvColumn {
  std::string title;                    ///< name and unit, e.g. "measured [1/sr]"
  std::vector<double> values;           ///< NaN becomes an empty field
  std::vector<std::string> texts = {};  ///< if not empty, used instead of `values`
  std::size_t rows() const { return texts.empty() ? values.size() : texts.size(); }
};

/// A table for other programs. The CSV text has comment lines that begin with "# ", a line of titles, then one line per
/// row. Numbers have a decimal point and the fewest digits that read back to the same double; line ends are "\n";
/// texts are written by io::csvField().
struct CsvTable {
  std::vector<std::string> comments;
  std::vector<CsvColumn> columns;  ///< all with the same number of rows
};

std::string toCsv(const CsvTable& table);

}  // namespace gonio::plots
