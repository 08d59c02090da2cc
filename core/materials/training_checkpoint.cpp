// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/training_checkpoint.h"

#include "core/io/atomic_file.h"
#include "core/io/described_numbers.h"
#include "core/io/matrix_numbers.h"
#include "core/support/json_object.h"
#include "core/support/naming_file.h"

namespace gonio::materials {

namespace {

using dictionary::ModeMatrices;
using dictionary::TrainingState;
using nlohmann::json;

constexpr std::string_view magic = "GONIOCKP", what = "checkpoint";
constexpr std::uint32_t version = 1;

void append(const ModeMatrices<double>& matrices, std::vector<std::byte>& numbers) {
  for (const Eigen::MatrixXd& mode : matrices) io::appendMatrix(mode, numbers);
}

ModeMatrices<double> take(std::span<const std::byte>& numbers, const dictionary::Sizes& sizes) {
  ModeMatrices<double> matrices;
  for (std::size_t mode = 0; mode < 3; ++mode) matrices[mode] = io::takeMatrix<double>(numbers, sizes[mode], what);
  return matrices;
}

dictionary::Sizes sizesOf(const json& numbers) {
  dictionary::Sizes sizes{};
  if (!numbers.is_array() || numbers.size() != 3) throw Error("checkpoint: found no three sizes");
  for (std::size_t mode = 0; mode < 3; ++mode) {
    if (!numbers[mode].is_number_integer()) throw Error("checkpoint: found a size that is no number");
    sizes[mode] = numbers[mode].get<int>();
    if (sizes[mode] < 1 || sizes[mode] > 1024) throw Error("checkpoint: found a size beyond 1 to 1024");
  }
  return sizes;
}

TrainingState stateOf(const io::DescribedNumbers& content, const std::string& training) {
  const JsonObject root(content.description, "");
  if (root.text("training") != training)
    throw Error("the checkpoint is of another training; found " + root.text("training") + ", expected " + training);
  TrainingState state;
  std::span<const std::byte> numbers = content.numbers;
  state.subspace.bases = take(numbers, sizesOf(root.array("sizes")));
  state.subspace.ranks = sizesOf(root.array("ranks"));
  state.subspace.loss = root.number("loss", 0, 1);
  const int dictionaries = int(root.number("dictionaries", 1, 256));
  for (const json& errors : root.array("errors")) {
    if (!errors.is_array()) throw Error("checkpoint: found no list of errors");
    std::vector<double>& list = state.errors.emplace_back();
    for (const json& error : errors) {
      if (!error.is_number()) throw Error("checkpoint: found an error that is no number");
      list.push_back(error.get<double>());
    }
    auto& ensemble = state.ensembles.emplace_back();
    for (int d = 0; d < dictionaries; ++d) ensemble.push_back(take(numbers, state.subspace.ranks));
  }
  return state;
}

}  // namespace

void writeCheckpoint(const TrainingState& state, const std::string& training, const std::filesystem::path& path) {
  io::DescribedNumbers content;
  const ModeMatrices<double>& bases = state.subspace.bases;
  content.description = {{"training", training},
                         {"sizes", {bases[0].rows(), bases[1].rows(), bases[2].rows()}},
                         {"ranks", state.subspace.ranks},
                         {"loss", state.subspace.loss},
                         {"dictionaries", state.ensembles.empty() ? 1 : state.ensembles.front().size()},
                         {"errors", state.errors}};
  append(bases, content.numbers);
  for (const auto& ensemble : state.ensembles)
    for (const ModeMatrices<double>& dictionary : ensemble) append(dictionary, content.numbers);
  io::writeFileAtomically(path, io::encodeDescribedNumbers(magic, version, content));
}

TrainingState readCheckpoint(const std::string& training, const std::filesystem::path& path) {
  return namingFile(
      path, [&] { return stateOf(io::decodeDescribedNumbers(magic, version, what, io::FileSource(path)), training); });
}

}  // namespace gonio::materials
