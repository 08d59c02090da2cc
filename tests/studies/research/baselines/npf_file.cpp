// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/research/baselines/npf_file.h"

#include <cmath>
#include <cstring>

#include "core/io/csv_text.h"
#include "core/support/naming_file.h"

namespace gonio::factorization {

namespace {

constexpr std::size_t columns = 512, rowBytes = columns * 3 * sizeof(float), nodes = NonparametricFactors::nodes;
enum Column : std::size_t { diffuseAt = 0, specularAt = 1, dAt = 2, gAt = 93, fAt = 183 };

/// One row of the table.
class Row {
 public:
  Row(const io::ByteSource& source, std::size_t row) : row_(row) {
    source.readAt(row * rowBytes, std::as_writable_bytes(std::span(values_)));
  }

  double number(std::size_t column, std::size_t channel) const {
    const float value = values_[column * 3 + channel];
    if (!(value >= 0) || !std::isfinite(value))
      throw Error("row " + std::to_string(row_) + ", column " + std::to_string(column) + ": found " +
                  std::to_string(value) + ", expected a number that is not negative");
    return double(value);
  }
  std::array<double, nodes> curve(std::size_t first, std::size_t channel) const {
    std::array<double, nodes> result;
    for (std::size_t i = 0; i < nodes; ++i) result[i] = number(first + i, channel);
    return result;
  }

 private:
  std::size_t row_;
  std::array<float, columns * 3> values_;
};

NonparametricFactors factorsOf(const Row& row) {
  NonparametricFactors factors;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    NonparametricFactors::Channel& c = factors.channels[channel];
    c = {.diffuse = row.number(diffuseAt, channel),
         .specular = row.number(specularAt, channel),
         .d = row.curve(dAt, channel),
         .f = row.curve(fAt, channel),
         .g = row.curve(gAt, channel)};
    c.d.back() = c.d[nodes - 2];
    c.f.back() = c.f[nodes - 2];
  }
  return factors;
}

}  // namespace

const NonparametricFactors* NpfTable::find(std::string_view material) const {
  const auto found = materials.find(material);
  return found == materials.end() ? nullptr : &found->second;
}

NpfTable readNpf(const io::ByteSource& source, std::string_view rowNames) {
  if (source.size() == 0 || source.size() % rowBytes != 0)
    throw Error("non-parametric factors: found " + std::to_string(source.size()) + " bytes, expected rows of " +
                std::to_string(rowBytes));
  const std::size_t rows = std::size_t(source.size() / rowBytes);
  NpfTable table;
  const io::CsvText names = namingFile("the names of the rows", [&] { return io::readCsvText(rowNames); });
  const std::size_t rowColumn = names.neededColumn("row"), materialColumn = names.neededColumn("material");
  for (const io::CsvText::Row& line : names.rows) {
    const int row = names.integer(line, rowColumn);
    if (row < 0 || std::size_t(row) >= rows)
      throw Error("the names of the rows, " + io::lineText(line) + ": found row " + std::to_string(row) +
                  ", expected 0 to " + std::to_string(rows - 1));
    table.materials.emplace(line.fields[materialColumn], factorsOf(Row(source, std::size_t(row))));
  }
  return table;
}

NpfTable readNpf(const std::filesystem::path& path) {
  const std::filesystem::path namesPath = path.parent_path() / "npf_row_order.csv";
  const std::string names = namingFile(namesPath, [&] { return io::readText(namesPath); });
  return namingFile(path, [&] { return readNpf(io::FileSource(path), names); });
}

}  // namespace gonio::factorization
