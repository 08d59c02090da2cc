// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/dictionary_file.h"

#include "core/io/atomic_file.h"
#include "core/io/container.h"
#include "core/io/sha256.h"
#include "core/materials/basis_file.h"
#include "core/support/error.h"

extern "C" {
// The first byte of the bundled dictionary file, which the build includes (bundled_files.S).
extern const std::byte gonioBundledDictionary[];
extern const std::byte gonioBundledDictionaryEnd[];
}

namespace gonio::materials {

namespace {

using dictionary::Dictionary;
using dictionary::Ensemble;
using nlohmann::json;

constexpr io::ContainerFormat dictionaryFormat{.name = "dictionary", .signature = "GONIODIC"};
constexpr int maxDictionaries = 256;
/// Maximum deviation from orthonormality of matrices that were orthonormal before they were rounded to single
/// precision.
constexpr double maxRounding = 1e-4;

Eigen::MatrixXd orthonormalMatrix(io::ContainerReader& file, int size) {
  const Eigen::MatrixXd matrix = file.squareMatrix<float>(size).cast<double>();
  if (!(dictionary::orthonormalityError(matrix) < maxRounding)) file.fail("found a matrix that is not orthonormal");
  return dictionary::polished(dictionary::polished(matrix));
}

}  // namespace

void writeDictionary(const Ensemble& ensemble, const std::filesystem::path& path) {
  json sparsities = json::array();
  for (const Dictionary& dictionary : ensemble.dictionaries) sparsities.push_back(dictionary.sparsity);
  io::ContainerWriter file(dictionaryFormat);
  json description{
      {"grid", gridJson(ensemble.grid)}, {"sparsities", sparsities}, {"learnedFrom", ensemble.learnedFrom}};
  if (!ensemble.scaled) description["scaled"] = false;
  file.description(description);
  for (const Dictionary& dictionary : ensemble.dictionaries)
    for (const Eigen::MatrixXd& mode : dictionary.modes) file.values(Eigen::MatrixXf(mode.cast<float>()));
  io::writeFileAtomically(path, file.bytes());
}

std::shared_ptr<const NamedEnsemble> readDictionary(const io::ByteSource& source) {
  io::ContainerReader file(dictionaryFormat, source);
  const json description = file.description();
  const JsonObject root(description, "");
  auto named = std::make_shared<NamedEnsemble>();
  named->ensemble.grid = gridOf(root.object("grid"));
  if (root.contains("scaled")) named->ensemble.scaled = root.flag("scaled");
  const json& sparsities = root.array("sparsities");
  if (sparsities.empty() || sparsities.size() > maxDictionaries)
    file.fail("found " + std::to_string(sparsities.size()) + " dictionaries, expected 1 to 256");
  for (const json& name : root.array("learnedFrom"))
    named->ensemble.learnedFrom.push_back(name.is_string() ? name.get<std::string>() : name.dump());
  const auto sizes = dictionary::modeSizes(named->ensemble.grid);
  std::uint64_t numbers = 0;
  for (const int size : sizes) numbers += std::uint64_t(size) * std::uint64_t(size);
  file.expectRemaining(sparsities.size() * numbers * sizeof(float));
  for (const json& sparsity : sparsities) {
    Dictionary& dictionary = named->ensemble.dictionaries.emplace_back();
    dictionary.sparsity = sparsity.is_number_integer() ? sparsity.get<int>() : 0;
    for (std::size_t mode = 0; mode < 3; ++mode) dictionary.modes[mode] = orthonormalMatrix(file, sizes[mode]);
  }
  named->id = std::stoull(io::sha256Hex(source).substr(0, 16), nullptr, 16);
  return named;
}

std::shared_ptr<const NamedEnsemble> readDictionary(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return readDictionary(io::FileSource(path)); });
}

std::shared_ptr<const NamedEnsemble> bundledEnsemble() {
  static const std::shared_ptr<const NamedEnsemble> dictionary = readDictionary(
      io::MemorySource({gonioBundledDictionary, std::size_t(gonioBundledDictionaryEnd - gonioBundledDictionary)}));
  return dictionary;
}

}  // namespace gonio::materials
