// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/npf_file.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "core/io/csv_text.h"
#include "core/io/sha256.h"
#include "core/support/error.h"

namespace gonio::materials {

namespace {

using factorization::NonparametricFactors;

constexpr std::size_t npfColumns = 512, npfRowBytes = npfColumns * 3 * sizeof(float),
                      factorNodes = NonparametricFactors::nodes;
constexpr char rowSeparator = '#';
enum Column : std::size_t { diffuseAt = 0, specularAt = 1, dAt = 2, gAt = 93, fAt = 183 };

/// One row of the table.
class NpfRow {
 public:
  NpfRow(const io::ByteSource& source, std::size_t row) : row_(row) {
    source.readAt(row * npfRowBytes, std::as_writable_bytes(std::span(values_)));
  }

  double number(std::size_t column, std::size_t channel) const {
    const float value = values_[column * 3 + channel];
    if (!(value >= 0) || !std::isfinite(value))
      throw Error("row " + std::to_string(row_) + ", column " + std::to_string(column) + ": found " +
                  std::to_string(value) + ", expected a number that is not negative");
    return double(value);
  }
  std::array<double, factorNodes> curve(std::size_t first, std::size_t channel) const {
    std::array<double, factorNodes> result;
    for (std::size_t i = 0; i < factorNodes; ++i) result[i] = number(first + i, channel);
    return result;
  }
  std::size_t row() const { return row_; }
  std::string sha256() const { return io::sha256Hex(io::MemorySource(std::as_bytes(std::span(values_)))); }

 private:
  std::size_t row_;
  std::array<float, npfColumns * 3> values_;
};

NonparametricFactors factorsOf(const NpfRow& row) {
  NonparametricFactors factors;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    NonparametricFactors::Channel& c = factors.channels[channel];
    c = {.diffuse = row.number(diffuseAt, channel),
         .specular = row.number(specularAt, channel),
         .d = row.curve(dAt, channel),
         .f = row.curve(fAt, channel),
         .g = row.curve(gAt, channel)};
    c.d.back() = c.d[factorNodes - 2];
    c.f.back() = c.f[factorNodes - 2];
  }
  if (factors == NonparametricFactors())
    throw Error("row " + std::to_string(row.row()) + " is empty, expected the factors of a material");
  return factors;
}

std::size_t rowCount(const io::ByteSource& source) {
  if (source.size() == 0 || source.size() % npfRowBytes != 0)
    throw Error("non-parametric factors: found " + std::to_string(source.size()) + " bytes, expected rows of " +
                std::to_string(npfRowBytes));
  return std::size_t(source.size() / npfRowBytes);
}

/// The row of each name.
std::map<std::string, std::size_t, std::less<>> namedRows(std::string_view rowNames, std::size_t rows) {
  std::map<std::string, std::size_t, std::less<>> result;
  const io::CsvText names = withFileInErrors("npf_row_order.csv", [&] { return io::readCsvText(rowNames); });
  const std::size_t rowColumn = names.requiredColumn("row"), materialColumn = names.requiredColumn("material");
  for (const io::CsvText::Row& line : names.rows) {
    const int row = names.integer(line, rowColumn);
    if (row < 0 || std::size_t(row) >= rows)
      throw Error("npf_row_order.csv, " + io::lineText(line) + ": found row " + std::to_string(row) +
                  ", expected 0 to " + std::to_string(rows - 1));
    result.emplace(line.fields[materialColumn], std::size_t(row));
  }
  return result;
}

std::string namesBeside(const std::filesystem::path& table) {
  const std::filesystem::path path = table.parent_path() / "npf_row_order.csv";
  return withFileInErrors(path, [&] { return io::readText(path); });
}

std::optional<std::size_t> numberOf(std::string_view text) {
  std::size_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  return fault == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// The row of a number or of a name.
std::size_t rowOf(const std::string& wanted, const std::filesystem::path& table, std::size_t rows) {
  if (const auto number = numberOf(wanted)) {
    if (*number >= rows) throw Error("found row " + wanted + ", expected 0 to " + std::to_string(rows - 1));
    return *number;
  }
  const auto names = namedRows(namesBeside(table), rows);
  const auto found = names.find(wanted);
  if (found == names.end())
    throw Error("found the material '" + wanted + "', expected one of the " + std::to_string(names.size()) +
                " names in npf_row_order.csv");
  return found->second;
}

struct RowPath {
  std::filesystem::path table;
  std::string row;
};

RowPath partsOf(const std::filesystem::path& path) {
  const std::string text = path.string();
  const std::size_t at = text.rfind(rowSeparator);
  if (at == std::string::npos) return {path, ""};
  return {text.substr(0, at), text.substr(at + 1)};
}

}  // namespace

const NonparametricFactors* NpfTable::find(std::string_view material) const {
  const auto found = materials.find(material);
  return found == materials.end() ? nullptr : &found->second;
}

NpfTable readNpf(const io::ByteSource& source, std::string_view rowNames) {
  NpfTable table{.sha256 = io::sha256Hex(io::sha256Hex(source) + std::string(rowNames)), .materials = {}};
  for (const auto& [name, row] : namedRows(rowNames, rowCount(source)))
    table.materials.emplace(name, factorsOf(NpfRow(source, row)));
  return table;
}

NpfTable readNpf(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] {
    const io::FileSource source(path);
    return readNpf(source, namesBeside(path));
  });
}

bool isNpfRow(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) return false;
  const RowPath parts = partsOf(path);
  return !parts.row.empty() && std::filesystem::is_regular_file(parts.table, ignored);
}

Material readNpfRow(const std::filesystem::path& path) {
  const RowPath parts = partsOf(path);
  return withFileInErrors(parts.table, [&] {
    const io::FileSource source(parts.table);
    const std::size_t number = rowOf(parts.row, parts.table, rowCount(source));
    const NpfRow row(source, number);
    const NonparametricFactors factors = factorsOf(row);
    Material material;
    material.name = numberOf(parts.row) ? parts.table.stem().string() + "-" + parts.row : parts.row;
    material.source = {.path = std::filesystem::absolute(path).lexically_normal(),
                       .format = "non-parametric factors",
                       .sha256 = row.sha256(),
                       .description = "published factors of row " + std::to_string(number) + ", Bagher et al. 2016",
                       .grid = {int(factorNodes), int(factorNodes), int(factorNodes)},
                       .notes = {}};
    material.brdf = factorization::makeNonparametricBrdf(factors);
    return material;
  });
}

}  // namespace gonio::materials
