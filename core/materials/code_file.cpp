// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/code_file.h"

#include <array>
#include <cstring>
#include <string>

#include "core/dictionary/decode.h"
#include "core/io/atomic_file.h"
#include "core/io/described_numbers.h"
#include "core/support/naming_file.h"

namespace gonio::materials {

namespace {

using dictionary::CodePrecision;
using dictionary::SparseCode;

constexpr std::string_view magic = "GONIOCOD";
constexpr std::uint16_t version = 1, mostNodes = 1024;
constexpr std::size_t mostBytes = std::size_t(1) << 21;

struct Header {
  std::uint16_t fileVersion;
  std::uint8_t transform, precision;
  std::array<std::uint16_t, 4> grid;
  std::uint64_t dictionaryId;
};

template <typename Visit>
void visitFields(Header& header, const Visit& visit) {
  visit(header.fileVersion);
  visit(header.transform);
  visit(header.precision);
  visit(header.grid);
  visit(header.dictionaryId);
}

[[noreturn]] void fail(const std::string& what, std::uint64_t found, const std::string& expected) {
  throw Error("sparse code: " + what + " is " + std::to_string(found) + ", expected " + expected);
}

void check(const Header& header) {
  if (header.fileVersion != version) fail("the version", header.fileVersion, std::to_string(version));
  if (header.transform > std::uint8_t(DataTransform::cosineLog)) fail("the transform", header.transform, "0 or 1");
  if (header.precision > 1) fail("the precision", header.precision, "0 or 1");
  for (std::size_t i = 0; i < 3; ++i)
    if (header.grid[i] < 1 || header.grid[i] > mostNodes) fail("a count of nodes", header.grid[i], "1 to 1024");
  if (header.grid[3] > 1) fail("the fold of phi_d", header.grid[3], "0 or 1");
}

}  // namespace

std::vector<std::byte> encodeCode(const SparseCode& code, std::uint64_t dictionaryId, CodePrecision precision) {
  const HalfDifferenceGrid& grid = code.grid;
  Header header{version,
                std::uint8_t(code.transform),
                std::uint8_t(precision),
                {std::uint16_t(grid.thetaHCount), std::uint16_t(grid.thetaDCount), std::uint16_t(grid.phiDCount),
                 std::uint16_t(grid.reciprocal)},
                dictionaryId};
  std::vector<std::byte> bytes(codeHeaderBytes);
  std::byte* at = bytes.data();
  const auto put = [&](const void* from, std::size_t count) {
    std::memcpy(at, from, count);
    at += count;
  };
  put(magic.data(), magic.size());
  visitFields(header, [&](const auto& field) { put(&field, sizeof field); });
  const std::vector<std::byte> channels = packChannels(code, precision);
  bytes.insert(bytes.end(), channels.begin(), channels.end());
  return bytes;
}

void writeCode(const SparseCode& code, std::uint64_t dictionaryId, const std::filesystem::path& path,
               CodePrecision precision) {
  io::writeFileAtomically(path, encodeCode(code, dictionaryId, precision));
}

CodeFile readCode(const io::ByteSource& source) {
  if (!isCode(source)) throw Error("sparse code: the file does not begin with " + std::string(magic));
  if (source.size() < codeHeaderBytes || source.size() > mostBytes)
    fail("the size of the file", source.size(), std::to_string(codeHeaderBytes) + " to " + std::to_string(mostBytes));
  const std::vector<std::byte> bytes = source.readAll();
  const std::byte* at = bytes.data() + magic.size();
  Header header{};
  visitFields(header, [&](auto& field) {
    std::memcpy(&field, at, sizeof field);
    at += sizeof field;
  });
  check(header);
  CodeFile file{.code = {.grid = {.thetaHCount = header.grid[0],
                                  .thetaDCount = header.grid[1],
                                  .phiDCount = header.grid[2],
                                  .reciprocal = header.grid[3] == 1},
                         .transform = DataTransform(header.transform),
                         .channels = {}},
                .dictionaryId = header.dictionaryId,
                .precision = CodePrecision(header.precision)};
  unpackChannels(std::span(bytes).subspan(codeHeaderBytes), file.precision, file.code);
  return file;
}

CodeFile readCode(const std::filesystem::path& path) {
  return namingFile(path, [&] { return readCode(io::FileSource(path)); });
}

bool isCode(const io::ByteSource& source) { return io::beginsWith(source, magic); }

void checkDictionary(const CodeFile& code, const NamedEnsemble& dictionary) {
  if (code.dictionaryId != dictionary.id)
    throw Error(
        "the code is over another dictionary than the bundled or the given one: decode it with its own (goniotool "
        "decode --dictionary)");
  dictionary::checkCode(dictionary.ensemble, code.code);
}

void setCode(const CodeFile& file, Material& material) {
  const auto dictionary = bundledDictionary();
  checkDictionary(file, *dictionary);
  const dictionary::SparseCode& code = file.code;
  material.code = std::make_shared<const dictionary::SparseCode>(code);
  material.table = dictionary::decode(dictionary->ensemble, code);
  material.brdf = material.table;
  material.source.grid = {code.grid.thetaHCount, code.grid.thetaDCount, code.grid.phiDCount};
  material.source.description = std::to_string(code.coefficients()) + " coefficients a channel, transform " +
                                std::string(dataTransformNames[std::size_t(code.transform)]);
}

}  // namespace gonio::materials
