// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/research/baselines/npf_file.h"

#include <charconv>
#include <cmath>
#include <cstring>

#include "core/support/naming_file.h"

namespace gonio::io {

namespace {

using factorization::NonparametricFactors;

constexpr std::size_t columns = 512, rowBytes = columns * 3 * sizeof(float), nodes = NonparametricFactors::nodes;
enum Column : std::size_t { diffuseAt = 0, specularAt = 1, dAt = 2, gAt = 93, fAt = 183 };

/// One row of the table.
class Row {
 public:
  Row(const ByteSource& source, std::size_t row) : row_(row) {
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

std::size_t rowNumber(std::string_view text, std::size_t rows, std::size_t line) {
  std::size_t row = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), row);
  if (error != std::errc() || end != text.data() + text.size() || row >= rows)
    throw Error("the names of the rows, line " + std::to_string(line) + ": found row '" + std::string(text) +
                "', expected 0 to " + std::to_string(rows - 1));
  return row;
}

}  // namespace

const NonparametricFactors* NpfTable::find(std::string_view material) const {
  const auto found = materials.find(material);
  return found == materials.end() ? nullptr : &found->second;
}

NpfTable readNpf(const ByteSource& source, std::string_view rowNames) {
  if (source.size() == 0 || source.size() % rowBytes != 0)
    throw Error("non-parametric factors: found " + std::to_string(source.size()) + " bytes, expected rows of " +
                std::to_string(rowBytes));
  const std::size_t rows = std::size_t(source.size() / rowBytes);
  NpfTable table;
  for (std::size_t line = 1, begin = 0; begin < rowNames.size(); ++line) {
    const std::size_t end = std::min(rowNames.find('\n', begin), rowNames.size());
    std::string_view text = rowNames.substr(begin, end - begin);
    begin = end + 1;
    if (text.ends_with('\r')) text.remove_suffix(1);
    if (line == 1 || text.empty()) continue;
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos)
      throw Error("the names of the rows, line " + std::to_string(line) + ": found no comma, expected row,material");
    const std::size_t row = rowNumber(text.substr(0, comma), rows, line);
    table.materials.emplace(text.substr(comma + 1), factorsOf(Row(source, row)));
  }
  return table;
}

NpfTable readNpf(const std::filesystem::path& path) {
  constexpr std::uint64_t mostNames = 1 << 20;
  const std::filesystem::path namesPath = path.parent_path() / "npf_row_order.csv";
  const std::vector<std::byte> names = namingFile(namesPath, [&] { return FileSource(namesPath).readAll(mostNames); });
  return namingFile(path, [&] {
    return readNpf(FileSource(path), {reinterpret_cast<const char*>(names.data()), names.size()});
  });
}

}  // namespace gonio::io
