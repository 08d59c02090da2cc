// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/basis_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>

#include "core/brdf/data_transform.h"
#include "core/brdf/neural_brdf.h"
#include "core/coordinates/grid_directions.h"
#include "core/io/atomic_file.h"
#include "core/io/container.h"
#include "core/materials/bundled_library.h"
#include "core/support/error.h"

namespace gonio::materials {

namespace {

using dictionary::MappedCells;
using dictionary::PrincipalComponents;
using nlohmann::json;

using HalfVector = Eigen::Matrix<Eigen::half, Eigen::Dynamic, 1>;

constexpr io::ContainerFormat basisFormat{.name = "basis", .signature = "GONIOPCA", .version = 2};
constexpr int maxSignals = 1 << 20, maxComponents = 1 << 14;

std::vector<std::uint8_t> cellBits(const MappedCells& mapping) {
  std::vector<std::uint8_t> bits((mapping.grid.size() + 7) / 8);
  for (const std::uint32_t cell : mapping.cells) bits[cell / 8] = std::uint8_t(bits[cell / 8] | 1u << cell % 8);
  return bits;
}

/// The largest entry of a column, then the column over it.
void appendColumn(const Eigen::Ref<const Eigen::VectorXf>& column, BasisPrecision precision,
                  io::ContainerWriter& file) {
  const float largest = column.cwiseAbs().maxCoeff();
  file.number(largest);
  const Eigen::VectorXf relative = column * (largest > 0 ? 1 / largest : 0);
  if (precision == BasisPrecision::half)
    file.values(HalfVector(relative.cast<Eigen::half>()));
  else
    file.values(relative);
}

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

Sizes basisSizes(const io::ContainerReader& file, const JsonObject& root) {
  Sizes sizes;
  sizes.grid = gridOf(root.object("grid"));
  sizes.cells = std::size_t(root.number("cells", 1, double(sizes.grid.size())));
  sizes.components = std::size_t(root.number("components", 0, maxComponents));
  sizes.signals = std::size_t(root.number("signals", 1, maxSignals));
  const std::string precision = root.text("precision");
  if (precision != "single" && precision != "half")
    file.fail("found the precision '" + precision + "', expected single or half");
  sizes.precision = precision == "half" ? BasisPrecision::half : BasisPrecision::single;
  file.expectRemaining(sizes.bytes());
  return sizes;
}

MappedCells mappingOf(const Sizes& sizes, io::ContainerReader& file) {
  MappedCells mapping{.grid = sizes.grid};
  std::vector<std::uint8_t> bits((sizes.grid.size() + 7) / 8);
  file.values(bits, "bit");
  const GridDirections directions(sizes.grid);
  for (std::size_t cell = 0; cell < sizes.grid.size(); ++cell) {
    if (!(bits[cell / 8] >> cell % 8 & 1)) continue;
    const DirectionPair pair = directions.at(cell).pair;
    mapping.cells.push_back(std::uint32_t(cell));
    mapping.weights.push_back(float(cosineWeight(std::max(0.0, pair.wi.z), std::max(0.0, pair.wo.z))));
  }
  if (mapping.cells.size() != sizes.cells)
    file.fail("found " + std::to_string(mapping.cells.size()) + " used cells, expected " + std::to_string(sizes.cells));
  mapping.reference.resize(sizes.cells);
  file.values(mapping.reference, "reference");
  for (const float reference : mapping.reference)
    if (reference < 0) file.fail("found a negative reference value (median of the training set), expected 0 or more");
  return mapping;
}

/// Reads a column that appendColumn() wrote. @param name for errors.
Eigen::VectorXf basisColumn(const Sizes& sizes, const std::string& name, io::ContainerReader& file) {
  const auto cells = Eigen::Index(sizes.cells);
  const auto scale = file.number<float>();
  if (!std::isfinite(scale)) file.fail("the scale of " + name + " is not finite, expected a finite number");
  Eigen::VectorXf column(cells);
  if (sizes.precision == BasisPrecision::half) {
    HalfVector half(cells);
    file.values(half, "column entry");
    column = half.cast<float>();
  } else {
    file.values(column, "column entry");
  }
  column *= scale;
  if (!column.allFinite()) file.fail("found " + name + " with an entry that is not finite");
  return column;
}

/// The file has standard deviations: half a precision of variances would reach to one part in 4000 of them only.
std::vector<float> leftOutOf(const Sizes& sizes, io::ContainerReader& file) {
  const Eigen::VectorXf deviations = basisColumn(sizes, "the residual standard deviations", file);
  if (deviations.isZero(0)) return {};
  const Eigen::VectorXf variances = deviations.cwiseAbs2();
  if (deviations.minCoeff() < 0 || !variances.allFinite())
    file.fail("found a residual standard deviation that is negative or too large");
  return {variances.begin(), variances.end()};
}

GramSvd svdOf(const Sizes& sizes, io::ContainerReader& file) {
  GramSvd svd;
  const auto components = Eigen::Index(sizes.components);
  svd.singularValues.resize(components);
  file.values(svd.singularValues, "singular value");
  for (Eigen::Index k = 0; k < components; ++k)
    if (!(svd.singularValues[k] > 0) || (k > 0 && svd.singularValues[k] > svd.singularValues[k - 1]))
      file.fail("found singular values that are not in descending order");
  svd.v.resize(Eigen::Index(sizes.signals), components);
  file.values(svd.v, "coefficient");
  svd.u.rows = Eigen::Index(sizes.cells);
  svd.u.columns = components;
  svd.u.values.resize(sizes.cells * sizes.components);
  for (Eigen::Index k = 0; k < components; ++k)
    svd.u.view().col(k) = basisColumn(sizes, "component " + std::to_string(k), file);
  return svd;
}

}  // namespace

std::vector<std::byte> encodeBasis(const PrincipalComponents& basis, int components,
                                   const std::vector<std::string>& learnedFrom, BasisPrecision precision) {
  const MappedCells& m = basis.mapping;
  const Eigen::Index count = std::clamp(components, 0, basis.count());
  io::ContainerWriter file(basisFormat);
  file.description({{"grid", gridJson(m.grid)},
                    {"cells", m.cells.size()},
                    {"components", count},
                    {"signals", basis.svd.v.rows()},
                    {"precision", precision == BasisPrecision::half ? "half" : "single"},
                    {"learnedFrom", learnedFrom}});
  file.values(cellBits(m));
  file.values(m.reference);
  file.values(basis.mean);
  const std::vector<float> leftOut = leftOutVariance(basis, int(count), 0, m.cells.size());
  appendColumn(Eigen::Map<const Eigen::ArrayXf>(leftOut.data(), Eigen::Index(leftOut.size())).sqrt().matrix(),
               precision, file);
  file.values(Eigen::VectorXd(basis.svd.singularValues.head(count)));
  file.values(Eigen::MatrixXd(basis.svd.v.leftCols(count)));
  for (Eigen::Index k = 0; k < count; ++k) appendColumn(basis.svd.u.view().col(k), precision, file);
  return std::move(file).bytes();
}

void writeBasis(const PrincipalComponents& basis, int components, const std::vector<std::string>& learnedFrom,
                const std::filesystem::path& path, BasisPrecision precision) {
  io::writeFileAtomically(path, encodeBasis(basis, components, learnedFrom, precision));
}

std::shared_ptr<const BasisFile> readBasis(const io::ByteSource& source) {
  io::ContainerReader reader(basisFormat, source);
  const json description = reader.description();
  const JsonObject root(description, "");
  const Sizes sizes = basisSizes(reader, root);
  auto file = std::make_shared<BasisFile>();
  for (const json& name : root.array("learnedFrom"))
    file->learnedFrom.push_back(name.is_string() ? name.get<std::string>() : name.dump());
  file->components.mapping = mappingOf(sizes, reader);
  file->components.mean.resize(sizes.cells);
  reader.values(file->components.mean, "mean");
  file->components.leftOut = leftOutOf(sizes, reader);
  file->components.svd = svdOf(sizes, reader);
  return file;
}

std::shared_ptr<const BasisFile> readBasis(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return readBasis(io::FileSource(path)); });
}

namespace {

/// Number of components of the bundled basis. The others carry little information on any material, and would cost
/// memory.
constexpr int components = 64;

void raise(std::vector<float>& largest, const TabulatedBrdf& table) {
  for (std::size_t cell = 0; cell < largest.size(); ++cell)
    largest[cell] = std::max(largest[cell], float(maxChannel(Rgb(table.values()[cell]))));
}

/// Those of libraryTrainingPaths(). A copy is evaluated as the network that it is: its table
/// of the MERL grid would take longer than all else.
std::vector<std::function<std::shared_ptr<const Brdf>()>> trainingMaterials() {
  std::vector<std::function<std::shared_ptr<const Brdf>()>> result;
  for (const MeasuredMaterial& measured : measuredMaterials())
    result.push_back([&measured] { return measuredMaterial(measured).brdf; });
  for (const NearMeasuredMaterial& copy : nearMeasuredMaterials())
    if (!isOriginalBundled(copy))
      result.push_back([&copy] { return std::make_shared<const NeuralBrdf>(copy.weights); });
  return result;
}

BundledBasis learn(const TaskControl& control) {
  const auto materials = trainingMaterials();
  BundledBasis basis;
  basis.largest.resize(bundledBasisGrid.size());
  const auto load = [&](std::size_t m) {
    control.throwIfStopped();
    const auto table = bakeTable(*materials[m](), bundledBasisGrid);
    raise(basis.largest, *table);
    return table;
  };
  basis.components =
      dictionary::learnPrincipalComponents(materials.size(), load, {.maxComponents = components}, control);
  return basis;
}

}  // namespace

std::shared_ptr<const BundledBasis> bundledBasis(const TaskControl& control) {
  static std::mutex mutex;
  static std::shared_ptr<const BundledBasis> basis;
  const std::scoped_lock lock(mutex);
  if (!basis) basis = std::make_shared<const BundledBasis>(learn(control));
  return basis;
}

}  // namespace gonio::materials
