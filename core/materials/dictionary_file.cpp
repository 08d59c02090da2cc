// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/dictionary_file.h"

#include "core/io/atomic_file.h"
#include "core/io/described_numbers.h"
#include "core/io/matrix_numbers.h"
#include "core/io/sha256.h"
#include "core/support/json_object.h"
#include "core/support/naming_file.h"

namespace gonio::materials {

namespace {

using dictionary::Dictionary;
using dictionary::Ensemble;
using nlohmann::json;

constexpr std::string_view magic = "GONIODIC", what = "dictionary";
constexpr std::uint32_t version = 1;
constexpr int mostDictionaries = 256, mostNodes = 1024;
/// Of matrices that were orthonormal before they were rounded to single precision.
constexpr double mostRounding = 1e-4;

HalfDifferenceGrid gridOf(const JsonObject& object) {
  const auto count = [&](const char* key) { return int(object.number(key, 1, mostNodes)); };
  return {.thetaHCount = count("thetaH"),
          .thetaDCount = count("thetaD"),
          .phiDCount = count("phiD"),
          .reciprocal = object.flag("reciprocal")};
}

Eigen::MatrixXd orthonormalMatrix(std::span<const std::byte>& numbers, int size) {
  const Eigen::MatrixXd matrix = io::takeMatrix<float>(numbers, size, what).cast<double>();
  if (!(dictionary::orthonormalityError(matrix) < mostRounding))
    throw Error("dictionary: found a matrix that is not orthonormal");
  return dictionary::polished(dictionary::polished(matrix));
}

}  // namespace

void writeDictionary(const Ensemble& ensemble, const std::filesystem::path& path) {
  const HalfDifferenceGrid& grid = ensemble.grid;
  io::DescribedNumbers content;
  json sparsities = json::array();
  for (const Dictionary& dictionary : ensemble.dictionaries) {
    sparsities.push_back(dictionary.sparsity);
    for (const Eigen::MatrixXd& mode : dictionary.modes) io::appendMatrix<float>(mode.cast<float>(), content.numbers);
  }
  content.description = {{"grid",
                          {{"thetaH", grid.thetaHCount},
                           {"thetaD", grid.thetaDCount},
                           {"phiD", grid.phiDCount},
                           {"reciprocal", grid.reciprocal}}},
                         {"sparsities", sparsities},
                         {"learnedFrom", ensemble.learnedFrom}};
  io::writeFileAtomically(path, io::encodeDescribedNumbers(magic, version, content));
}

std::shared_ptr<const NamedEnsemble> readDictionary(const io::ByteSource& source) {
  const io::DescribedNumbers content = io::decodeDescribedNumbers(magic, version, what, source);
  const JsonObject root(content.description, "");
  auto named = std::make_shared<NamedEnsemble>();
  named->ensemble.grid = gridOf(root.object("grid"));
  const json& sparsities = root.array("sparsities");
  if (sparsities.empty() || sparsities.size() > mostDictionaries)
    throw Error("dictionary: found " + std::to_string(sparsities.size()) + " dictionaries, expected 1 to 256");
  for (const json& name : root.array("learnedFrom"))
    named->ensemble.learnedFrom.push_back(name.is_string() ? name.get<std::string>() : name.dump());
  std::span<const std::byte> numbers = content.numbers;
  for (const json& sparsity : sparsities) {
    Dictionary& dictionary = named->ensemble.dictionaries.emplace_back();
    dictionary.sparsity = sparsity.is_number_integer() ? sparsity.get<int>() : 0;
    for (std::size_t mode = 0; mode < 3; ++mode)
      dictionary.modes[mode] = orthonormalMatrix(numbers, dictionary::modeSizes(named->ensemble.grid)[mode]);
  }
  if (!numbers.empty())
    throw Error("dictionary: the file holds " + std::to_string(numbers.size()) + " bytes behind its matrices");
  named->id = std::stoull(io::sha256Hex(source).substr(0, 16), nullptr, 16);
  return named;
}

std::shared_ptr<const NamedEnsemble> readDictionary(const std::filesystem::path& path) {
  return namingFile(path, [&] { return readDictionary(io::FileSource(path)); });
}

}  // namespace gonio::materials
