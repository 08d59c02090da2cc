// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

namespace gonio::plots {

struct CsvColumn {
  std::string title;                    ///< name and unit: "measured [1/sr]"
  std::vector<double> values;           ///< NaN becomes an empty field
  std::vector<std::string> texts = {};  ///< instead of values, where there are some
  std::size_t rows() const { return texts.empty() ? values.size() : texts.size(); }
};

/// Numbers, and texts where a column has them, for other programs: comment lines that begin with "# " say what they
/// are, one line of titles, then one line a row. Decimal point, shortest digits that read back to the same double, "\n"
/// at line ends (RFC 4180 quoting).
struct CsvTable {
  std::vector<std::string> comments;
  std::vector<CsvColumn> columns;  ///< all of one length
};

std::string toCsv(const CsvTable& table);

}  // namespace gonio::plots
