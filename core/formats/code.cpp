// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/code.h"

#include <array>
#include <string>

#include "core/dictionary/decode.h"
#include "core/formats/formats.h"
#include "core/io/atomic_file.h"
#include "core/io/container.h"
#include "core/support/error.h"

namespace gonio::formats {

namespace {

using dictionary::CodePrecision;
using dictionary::SparseCode;

/// The version of codes of both orders of the directions; older versions of Gonio read version 1 alone.
constexpr std::uint32_t bothOrdersVersion = 2;
constexpr io::ContainerFormat containerOf(bool hasBothOrders) {
  return {.name = "sparse code",
          .signature = "GONIOCOD",
          .version = hasBothOrders ? bothOrdersVersion : 1,
          .readVersion = 1,
          .versionBytes = sizeof(std::uint16_t),
          .maxBytes = std::uint64_t(1) << 21};
}
constexpr io::ContainerFormat codeContainer = containerOf(true);
constexpr int maxCodeNodes = 1024;
// Flags beside the transform.
constexpr std::uint8_t withoutScale = 128, withLargestValues = 64, codeFlags = withoutScale | withLargestValues;

/// A number of the header. @param what for the error.
template <typename Number>
Number takeNumber(io::ContainerReader& file, const char* what, int low, int high) {
  const auto number = file.number<Number>();
  if (number < low || number > high)
    file.fail(std::string(what) + " is " + std::to_string(number) + ", expected " + std::to_string(low) + " to " +
              std::to_string(high));
  return number;
}

HalfDifferenceGrid takeGrid(io::ContainerReader& file) {
  const auto nodes = [&file] { return int(takeNumber<std::uint16_t>(file, "a count of nodes", 1, maxCodeNodes)); };
  return {.thetaHCount = nodes(),
          .thetaDCount = nodes(),
          .phiDCount = nodes(),
          .reciprocal = takeNumber<std::uint16_t>(file, "the range of phi_d (0: 360 degrees, 1: folded)", 0, 1) == 1};
}

}  // namespace

std::vector<std::byte> encodeCode(const SparseCode& code, std::uint64_t dictionaryId, CodePrecision precision) {
  const HalfDifferenceGrid& grid = code.grid;
  io::ContainerWriter file(containerOf(code.hasBothOrders()));
  file.number(std::uint8_t(std::uint8_t(code.transform) | (code.scaled ? 0 : withoutScale) |
                           (code.hasLargestValues ? withLargestValues : 0)));
  file.number(std::uint8_t(precision));
  for (const int number : {grid.thetaHCount, grid.thetaDCount, grid.phiDCount, int(grid.reciprocal)})
    file.number(std::uint16_t(number));
  file.number(dictionaryId);
  file.append(packChannels(code, precision));
  return std::move(file).bytes();
}

void writeCode(const SparseCode& code, std::uint64_t dictionaryId, const std::filesystem::path& path,
               CodePrecision precision) {
  io::writeFileAtomically(path, encodeCode(code, dictionaryId, precision));
}

CodeFile readCode(const io::ByteSource& source) {
  io::ContainerReader file(codeContainer, source);
  CodeFile result;
  const auto transform = file.number<std::uint8_t>();
  if ((transform & ~codeFlags) > 1)
    file.fail("the transform is " + std::to_string(transform) + ", expected 0 or 1, plus 64, 128 or 192 for its flags");
  result.code.transform = DataTransform(transform & ~codeFlags);
  result.code.hasLargestValues = (transform & withLargestValues) != 0;
  result.code.scaled = (transform & withoutScale) == 0;
  result.precision = CodePrecision(takeNumber<std::uint8_t>(file, "the precision", 0, 2));
  result.code.grid = takeGrid(file);
  result.dictionaryId = file.number<std::uint64_t>();
  unpackChannels(file.rest(), result.precision, result.code, file.version() >= bothOrdersVersion);
  return result;
}

CodeFile readCode(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return readCode(io::FileSource(path)); });
}

std::shared_ptr<const materials::NamedEnsemble> bundledDictionaryOf(const CodeFile& code) {
  const auto found = materials::bundledEnsemble(code.dictionaryId);
  const auto dictionary = found ? found : materials::bundledEnsemble();
  checkDictionary(code, *dictionary);
  return dictionary;
}

void checkDictionary(const CodeFile& code, const materials::NamedEnsemble& dictionary) {
  if (code.dictionaryId != dictionary.id)
    throw Error("the code was encoded with another dictionary; decode it with goniotool decode --dictionary");
  dictionary::checkCode(dictionary.ensemble, code.code);
}

namespace {

void sniffCode(const io::ByteSource& source) { io::expectSignature(source, codeContainer); }

/// Decodes a code over a bundled ensemble, under 50 ms.
void readCodeMaterial(const io::ByteSource& source, const TaskControl&, materials::Material& material) {
  const CodeFile file = readCode(source);
  material.dictionary = bundledDictionaryOf(file);
  const SparseCode& code = file.code;
  material.code = std::make_shared<const SparseCode>(code);
  material.table = dictionary::decode(material.dictionary->ensemble, code);
  material.brdf = material.table;
  material.source.grid = {code.grid.thetaHCount, code.grid.thetaDCount, code.grid.phiDCount};
  material.source.description = std::to_string(code.coefficients()) + " coefficients per channel, transform " +
                                std::string(dataTransformNames[std::size_t(code.transform)]) +
                                (code.hasBothOrders() ? ", both orders of the directions" : "") +
                                (code.scaled ? "" : ", as published (without cell scaling)");
}

constexpr std::string_view codeSuffixes[] = {".code"};

}  // namespace

constinit const MaterialFormat codeFormat{.name = "sparse code",
                                          .label = "sparse code",
                                          .suffixes = codeSuffixes,
                                          .holds = {.nonReciprocal = true},
                                          .sniff = sniffCode,
                                          .read = readCodeMaterial};

}  // namespace gonio::formats
