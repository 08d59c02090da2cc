// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/dictionary_file.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>

#include "core/io/atomic_file.h"
#include "core/io/container.h"
#include "core/io/sha256.h"
#include "core/materials/basis_file.h"
#include "core/support/error.h"
#include "core/support/json_object.h"

/// The first byte of each bundled dictionary file, in the order of bundledIds(), and the end of the last one: included
/// by the build (bundled_files.S).
extern "C" const std::byte* const gonioDictionaryFiles[];

namespace gonio::materials {

namespace {

using dictionary::Dictionary;
using dictionary::Ensemble;
using nlohmann::json;

constexpr io::ContainerFormat dictionaryFormat{.name = "dictionary", .signature = "GONIODIC"};
constexpr int maxDictionaries = 256;
constexpr const char* halfPrecision = "half";
/// Maximum deviation from orthonormality of matrices that were orthonormal before they were rounded.
constexpr double maxRounding = 1e-4, maxHalfRounding = 1e-2;

Eigen::MatrixXd orthonormalMatrix(io::ContainerReader& file, int size, bool half) {
  Eigen::MatrixXd matrix;
  if (half)
    matrix = file.squareMatrix<Eigen::half>(size).cast<double>();
  else
    matrix = file.squareMatrix<float>(size).cast<double>();
  if (!matrix.allFinite()) file.fail("found a matrix entry that is not finite");
  if (!(dictionary::orthonormalityError(matrix) < (half ? maxHalfRounding : maxRounding)))
    file.fail("found a matrix that is not orthonormal");
  return dictionary::polished(dictionary::polished(half ? dictionary::polished(matrix) : matrix));
}

}  // namespace

void writeDictionary(const Ensemble& ensemble, const std::filesystem::path& path, bool half) {
  json sparsities = json::array();
  for (const Dictionary& dictionary : ensemble.dictionaries) sparsities.push_back(dictionary.sparsity);
  io::ContainerWriter file(dictionaryFormat);
  json description{
      {"grid", gridJson(ensemble.grid)}, {"sparsities", sparsities}, {"learnedFrom", ensemble.learnedFrom}};
  if (!ensemble.scaled) description["scaled"] = false;
  if (half) description["precision"] = halfPrecision;
  file.description(description);
  for (const Dictionary& dictionary : ensemble.dictionaries)
    for (const Eigen::MatrixXd& mode : dictionary.modes) {
      if (half)
        file.values(mode.cast<Eigen::half>().eval());
      else
        file.values(mode.cast<float>().eval());
    }
  io::writeFileAtomically(path, file.bytes());
}

std::shared_ptr<const NamedEnsemble> readDictionary(const io::ByteSource& source) {
  io::ContainerReader file(dictionaryFormat, source);
  const json description = file.description();
  const JsonObject root(description, "");
  auto named = std::make_shared<NamedEnsemble>();
  named->ensemble.grid = gridOf(root.object("grid"));
  if (root.contains("scaled")) named->ensemble.scaled = root.flag("scaled");
  const bool half = root.contains("precision") && root.text("precision") == halfPrecision;
  const json& sparsities = root.array("sparsities");
  if (sparsities.empty() || sparsities.size() > maxDictionaries)
    file.fail("found " + std::to_string(sparsities.size()) + " dictionaries, expected 1 to 256");
  for (const json& name : root.array("learnedFrom"))
    named->ensemble.learnedFrom.push_back(name.is_string() ? name.get<std::string>() : name.dump());
  const auto sizes = dictionary::modeSizes(named->ensemble.grid);
  std::uint64_t numbers = 0;
  for (const int size : sizes) numbers += std::uint64_t(size) * std::uint64_t(size);
  file.expectRemaining(sparsities.size() * numbers * (half ? sizeof(Eigen::half) : sizeof(float)));
  for (const json& sparsity : sparsities) {
    Dictionary& dictionary = named->ensemble.dictionaries.emplace_back();
    dictionary.sparsity = sparsity.is_number_integer() ? sparsity.get<int>() : 0;
    for (std::size_t mode = 0; mode < 3; ++mode) dictionary.modes[mode] = orthonormalMatrix(file, sizes[mode], half);
  }
  named->id = std::stoull(io::sha256Hex(source).substr(0, 16), nullptr, 16);
  return named;
}

std::shared_ptr<const NamedEnsemble> readDictionary(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return readDictionary(io::FileSource(path)); });
}

namespace {

/// In the order of the list in CMakeLists.txt.
constexpr std::uint64_t ids[] = {0x35974214a2211932, 0x9eb94cec83c11a00, 0x6bebf51c078c57af};

}  // namespace

std::span<const std::uint64_t> bundledIds() { return ids; }

std::shared_ptr<const NamedEnsemble> bundledEnsemble(std::uint64_t id) {
  struct Bundled {
    std::once_flag read;
    std::shared_ptr<const NamedEnsemble> dictionary;
  };
  static std::array<Bundled, std::size(ids)> bundled;
  const auto i = std::size_t(std::ranges::find(ids, id) - std::begin(ids));
  if (i == bundled.size()) return nullptr;
  std::call_once(bundled[i].read, [&] {
    const std::byte* const begin = gonioDictionaryFiles[i];
    bundled[i].dictionary = readDictionary(io::MemorySource({begin, gonioDictionaryFiles[i + 1]}));
  });
  return bundled[i].dictionary;
}

namespace {

using dictionary::ModeMatrices;
using dictionary::TrainingState;
using nlohmann::json;

constexpr io::ContainerFormat checkpointFormat{.name = "checkpoint", .signature = "GONIOCKP"};

void append(const ModeMatrices<double>& matrices, io::ContainerWriter& file) {
  for (const Eigen::MatrixXd& mode : matrices) file.values(mode);
}

ModeMatrices<double> take(io::ContainerReader& file, const dictionary::Sizes& sizes) {
  ModeMatrices<double> matrices;
  for (std::size_t mode = 0; mode < 3; ++mode) matrices[mode] = file.squareMatrix<double>(sizes[mode]);
  return matrices;
}

dictionary::Sizes checkpointSizes(const io::ContainerReader& file, const json& numbers) {
  dictionary::Sizes sizes{};
  if (!numbers.is_array() || numbers.size() != 3)
    file.fail("found " + describeJson(numbers) + ", expected three sizes");
  for (std::size_t mode = 0; mode < 3; ++mode) {
    if (!numbers[mode].is_number_integer()) file.fail("found " + describeJson(numbers[mode]) + ", expected a size");
    sizes[mode] = numbers[mode].get<int>();
    if (sizes[mode] < 1 || sizes[mode] > 1024)
      file.fail("found the size " + std::to_string(sizes[mode]) + ", expected 1 to 1024");
  }
  return sizes;
}

std::vector<double> errorsOf(const io::ContainerReader& file, const json& errors) {
  if (!errors.is_array()) file.fail("found " + describeJson(errors) + ", expected a list of training errors");
  std::vector<double> list;
  for (const json& error : errors) {
    if (!error.is_number()) file.fail("found " + describeJson(error) + ", expected a number");
    list.push_back(error.get<double>());
  }
  return list;
}

TrainingState stateOf(io::ContainerReader file, const std::string& training) {
  const json description = file.description();
  const JsonObject root(description, "");
  if (root.text("training") != training)
    throw Error("the checkpoint belongs to a different training run; found " + root.text("training") + ", expected " +
                training);
  TrainingState state;
  state.subspace.bases = take(file, checkpointSizes(file, root.array("sizes")));
  state.subspace.ranks = checkpointSizes(file, root.array("ranks"));
  state.subspace.loss = root.number("loss", 0, 1);
  const int dictionaries = int(root.number("dictionaries", 1, 256));
  for (const json& errors : root.array("errors")) {
    state.errors.push_back(errorsOf(file, errors));
    auto& ensemble = state.ensembles.emplace_back();
    for (int d = 0; d < dictionaries; ++d) ensemble.push_back(take(file, state.subspace.ranks));
  }
  file.expectRemaining(0);
  return state;
}

}  // namespace

void writeCheckpoint(const TrainingState& state, const std::string& training, const std::filesystem::path& path) {
  const ModeMatrices<double>& bases = state.subspace.bases;
  io::ContainerWriter file(checkpointFormat);
  file.description({{"training", training},
                    {"sizes", {bases[0].rows(), bases[1].rows(), bases[2].rows()}},
                    {"ranks", state.subspace.ranks},
                    {"loss", state.subspace.loss},
                    {"dictionaries", state.ensembles.empty() ? 1 : state.ensembles.front().size()},
                    {"errors", state.errors}});
  append(bases, file);
  for (const auto& ensemble : state.ensembles)
    for (const ModeMatrices<double>& dictionary : ensemble) append(dictionary, file);
  io::writeFileAtomically(path, file.bytes());
}

TrainingState readCheckpoint(const std::string& training, const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return stateOf({checkpointFormat, io::FileSource(path)}, training); });
}

}  // namespace gonio::materials
