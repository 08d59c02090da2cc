// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/basis_file.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/data_transform.h"
#include "core/coordinates/grid_directions.h"
#include "core/io/atomic_file.h"
#include "core/io/described_numbers.h"
#include "core/support/json_object.h"
#include "core/support/naming_file.h"

namespace gonio::materials {

namespace {

using dictionary::MappedCells;
using dictionary::PrincipalComponents;
using nlohmann::json;

constexpr std::string_view magic = "GONIOPCA", what = "basis";
constexpr std::uint32_t version = 2;
constexpr int mostNodes = 1024, mostSignals = 1 << 20, mostComponents = 1 << 14;

template <typename Numbers>
void append(const Numbers& values, std::vector<std::byte>& numbers) {
  const auto bytes = std::as_bytes(std::span(values.data(), std::size_t(values.size())));
  numbers.insert(numbers.end(), bytes.begin(), bytes.end());
}

std::vector<std::uint8_t> cellBits(const MappedCells& mapping) {
  std::vector<std::uint8_t> bits((mapping.grid.size() + 7) / 8);
  for (const std::uint32_t cell : mapping.cells) bits[cell / 8] = std::uint8_t(bits[cell / 8] | 1u << cell % 8);
  return bits;
}

/// The largest entry of a column, then the column over it.
void appendColumn(const Eigen::Ref<const Eigen::VectorXf>& column, BasisPrecision precision,
                  std::vector<std::byte>& numbers) {
  const Eigen::VectorXf largest = Eigen::VectorXf::Constant(1, column.cwiseAbs().maxCoeff());
  append(largest, numbers);
  const Eigen::VectorXf relative = column * (largest[0] > 0 ? 1 / largest[0] : 0);
  if (precision == BasisPrecision::half)
    append(Eigen::Matrix<Eigen::half, Eigen::Dynamic, 1>(relative.cast<Eigen::half>()), numbers);
  else
    append(relative, numbers);
}

/// Takes numbers off the front; their count was compared with the file's size before.
class Numbers {
 public:
  explicit Numbers(std::span<const std::byte> bytes) : left_(bytes) {}

  template <typename Target>
  void take(Target& target, const char* name) {
    const auto bytes = std::as_writable_bytes(std::span(target.data(), std::size_t(target.size())));
    std::copy_n(left_.begin(), bytes.size(), bytes.begin());
    left_ = left_.subspan(bytes.size());
    if constexpr (std::is_floating_point_v<std::remove_reference_t<decltype(target.data()[0])>>)
      for (std::size_t i = 0; i < std::size_t(target.size()); ++i)
        if (!std::isfinite(target.data()[i]))
          throw Error("basis: found a " + std::string(name) + " that is not finite, the " + std::to_string(i) + "th");
  }

 private:
  std::span<const std::byte> left_;
};

struct Sizes {
  HalfDifferenceGrid grid;
  std::size_t cells = 0, components = 0, signals = 0;
  BasisPrecision precision = BasisPrecision::half;

  std::size_t bytes() const {
    const std::size_t scalar = precision == BasisPrecision::half ? 2 : 4;
    return (grid.size() + 7) / 8 + cells * 2 * sizeof(float) + components * (1 + signals) * sizeof(double) +
           (components + 1) * (sizeof(float) + cells * scalar);
  }
};

Sizes sizesOf(const JsonObject& root) {
  const JsonObject grid = root.object("grid");
  const auto nodes = [&](const char* key) { return int(grid.number(key, 1, mostNodes)); };
  Sizes sizes;
  sizes.grid = {.thetaHCount = nodes("thetaH"),
                .thetaDCount = nodes("thetaD"),
                .phiDCount = nodes("phiD"),
                .reciprocal = grid.flag("reciprocal")};
  sizes.cells = std::size_t(root.number("cells", 1, double(sizes.grid.size())));
  sizes.components = std::size_t(root.number("components", 0, mostComponents));
  sizes.signals = std::size_t(root.number("signals", 1, mostSignals));
  const std::string precision = root.text("precision");
  if (precision != "single" && precision != "half")
    throw Error("basis: found the precision '" + precision + "', expected single or half");
  sizes.precision = precision == "half" ? BasisPrecision::half : BasisPrecision::single;
  return sizes;
}

MappedCells mappingOf(const Sizes& sizes, Numbers& numbers) {
  MappedCells mapping{.grid = sizes.grid};
  std::vector<std::uint8_t> bits((sizes.grid.size() + 7) / 8);
  numbers.take(bits, "bit");
  const GridDirections directions(sizes.grid);
  for (std::size_t cell = 0; cell < sizes.grid.size(); ++cell) {
    if (!(bits[cell / 8] >> cell % 8 & 1)) continue;
    const DirectionPair pair = directions.at(cell).pair;
    mapping.cells.push_back(std::uint32_t(cell));
    mapping.weights.push_back(float(cosineWeight(std::max(0.0, pair.wi.z), std::max(0.0, pair.wo.z))));
  }
  if (mapping.cells.size() != sizes.cells)
    throw Error("basis: found " + std::to_string(mapping.cells.size()) + " cells that count, expected " +
                std::to_string(sizes.cells));
  mapping.reference.resize(sizes.cells);
  numbers.take(mapping.reference, "reference");
  for (const float reference : mapping.reference)
    if (reference < 0) throw Error("basis: found a negative reference");
  return mapping;
}

/// What appendColumn() wrote. @param name for errors.
Eigen::VectorXf columnOf(const Sizes& sizes, const std::string& name, Numbers& numbers) {
  const auto cells = Eigen::Index(sizes.cells);
  Eigen::VectorXf scale(1), column(cells);
  numbers.take(scale, "scale");
  if (sizes.precision == BasisPrecision::half) {
    Eigen::Matrix<Eigen::half, Eigen::Dynamic, 1> half(cells);
    numbers.take(half, "entry");
    column = half.cast<float>();
  } else {
    numbers.take(column, "entry");
  }
  column *= scale[0];
  if (!column.allFinite()) throw Error("basis: found " + name + " with an entry that is not finite");
  return column;
}

/// The file has standard deviations: half a precision of variances would reach to one part in 4000 of them only.
std::vector<float> leftOutOf(const Sizes& sizes, Numbers& numbers) {
  const Eigen::VectorXf deviations = columnOf(sizes, "what is left out", numbers);
  if (deviations.isZero(0)) return {};
  const Eigen::VectorXf variances = deviations.cwiseAbs2();
  if (deviations.minCoeff() < 0 || !variances.allFinite())
    throw Error("basis: found a standard deviation of what is left out that is negative or too large");
  return {variances.begin(), variances.end()};
}

GramSvd svdOf(const Sizes& sizes, Numbers& numbers) {
  GramSvd svd;
  const auto components = Eigen::Index(sizes.components);
  svd.singularValues.resize(components);
  numbers.take(svd.singularValues, "singular value");
  for (Eigen::Index k = 0; k < components; ++k)
    if (!(svd.singularValues[k] > 0) || (k > 0 && svd.singularValues[k] > svd.singularValues[k - 1]))
      throw Error("basis: found singular values that do not descend");
  svd.v.resize(Eigen::Index(sizes.signals), components);
  numbers.take(svd.v, "coefficient");
  svd.u.rows = Eigen::Index(sizes.cells);
  svd.u.columns = components;
  svd.u.values.resize(sizes.cells * sizes.components);
  for (Eigen::Index k = 0; k < components; ++k)
    svd.u.view().col(k) = columnOf(sizes, "component " + std::to_string(k), numbers);
  return svd;
}

}  // namespace

std::vector<std::byte> encodeBasis(const PrincipalComponents& basis, int components,
                                   const std::vector<std::string>& learnedFrom, BasisPrecision precision) {
  const MappedCells& m = basis.mapping;
  const Eigen::Index count = std::clamp(components, 0, basis.count());
  io::DescribedNumbers content;
  content.description = {{"grid",
                          {{"thetaH", m.grid.thetaHCount},
                           {"thetaD", m.grid.thetaDCount},
                           {"phiD", m.grid.phiDCount},
                           {"reciprocal", m.grid.reciprocal}}},
                         {"cells", m.cells.size()},
                         {"components", count},
                         {"signals", basis.svd.v.rows()},
                         {"precision", precision == BasisPrecision::half ? "half" : "single"},
                         {"learnedFrom", learnedFrom}};
  append(cellBits(m), content.numbers);
  append(m.reference, content.numbers);
  append(basis.mean, content.numbers);
  const std::vector<float> leftOut = leftOutVariance(basis, int(count), 0, m.cells.size());
  appendColumn(Eigen::Map<const Eigen::ArrayXf>(leftOut.data(), Eigen::Index(leftOut.size())).sqrt().matrix(),
               precision, content.numbers);
  append(Eigen::VectorXd(basis.svd.singularValues.head(count)), content.numbers);
  append(Eigen::MatrixXd(basis.svd.v.leftCols(count)), content.numbers);
  for (Eigen::Index k = 0; k < count; ++k) appendColumn(basis.svd.u.view().col(k), precision, content.numbers);
  return io::encodeDescribedNumbers(magic, version, content);
}

void writeBasis(const PrincipalComponents& basis, int components, const std::vector<std::string>& learnedFrom,
                const std::filesystem::path& path, BasisPrecision precision) {
  io::writeFileAtomically(path, encodeBasis(basis, components, learnedFrom, precision));
}

std::shared_ptr<const BasisFile> readBasis(const io::ByteSource& source) {
  const io::DescribedNumbers content = io::decodeDescribedNumbers(magic, version, what, source);
  const JsonObject root(content.description, "");
  const Sizes sizes = sizesOf(root);
  if (content.numbers.size() != sizes.bytes())
    throw Error("basis: found " + std::to_string(content.numbers.size()) + " bytes of numbers, expected " +
                std::to_string(sizes.bytes()));
  auto file = std::make_shared<BasisFile>();
  for (const json& name : root.array("learnedFrom"))
    file->learnedFrom.push_back(name.is_string() ? name.get<std::string>() : name.dump());
  Numbers numbers(content.numbers);
  file->components.mapping = mappingOf(sizes, numbers);
  file->components.mean.resize(sizes.cells);
  numbers.take(file->components.mean, "mean");
  file->components.leftOut = leftOutOf(sizes, numbers);
  file->components.svd = svdOf(sizes, numbers);
  return file;
}

std::shared_ptr<const BasisFile> readBasis(const std::filesystem::path& path) {
  return namingFile(path, [&] { return readBasis(io::FileSource(path)); });
}

}  // namespace gonio::materials
