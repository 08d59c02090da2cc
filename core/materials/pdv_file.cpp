// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/pdv_file.h"

#include <cmath>
#include <cstring>
#include <fstream>

#include "core/io/atomic_file.h"
#include "core/io/described_numbers.h"
#include "core/support/naming_file.h"

namespace gonio::materials {

namespace {

using factorization::mostPdvTerms;
using factorization::PdvFactors;
using factorization::PdvForm;
using factorization::PdvTerm;

constexpr char magic[] = "GONIOPDV";
constexpr std::size_t magicBytes = 8;
constexpr std::uint32_t version = 1, mostNodes = 4096;
enum Header { versionAt, formAt, transformAt, thetaAt, deviationAt, phiAt, termsAt, headerNumbers };
constexpr std::size_t headerBytes = magicBytes + headerNumbers * sizeof(std::uint32_t) + sizeof(float);

/// The numbers behind the header: those of the axes, and of one term in all channels.
std::size_t floatCount(std::size_t nodes, std::size_t terms) { return nodes * (1 + 3 * terms); }

template <typename Visit>
void visitCurves(PdvFactors& f, const Visit& visit) {
  visit(f.thetaNodes);
  visit(f.deviationNodes);
  visit(f.phiNodes);
  for (std::vector<PdvTerm>& channel : f.channels)
    for (PdvTerm& term : channel) {
      visit(term.f1);
      visit(term.f2);
      visit(term.f3);
    }
}

[[noreturn]] void fail(const std::string& what, const std::string& found, const std::string& expected) {
  throw Error("PDV factors: " + what + " is " + found + ", expected " + expected);
}

void checkNumber(const char* what, std::uint32_t found, std::uint32_t low, std::uint32_t high) {
  if (found < low || found > high)
    fail(what, std::to_string(found), std::to_string(low) + (low == high ? "" : " to " + std::to_string(high)));
}

void checkNodes(const std::vector<double>& nodes, const char* what) {
  if (nodes.front() != 0) fail(std::string("the first node of ") + what, std::to_string(nodes.front()), "0");
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (!(nodes[i] > nodes[i - 1]))
      fail("node " + std::to_string(i) + " of " + what, std::to_string(nodes[i]),
           "more than " + std::to_string(nodes[i - 1]));
}

PdvFactors emptyFactors(const std::uint32_t* header, float highest) {
  PdvFactors f{.form = header[formAt] == 0 ? PdvForm::twoFactors : PdvForm::threeFactors,
               .transform = static_cast<DataTransform>(header[transformAt]),
               .thetaNodes = std::vector<double>(header[thetaAt]),
               .deviationNodes = std::vector<double>(header[deviationAt]),
               .phiNodes = std::vector<double>(header[phiAt]),
               .channels = {},
               .highest = double(highest)};
  for (std::vector<PdvTerm>& channel : f.channels)
    channel.assign(header[termsAt], {std::vector<double>(header[thetaAt]), std::vector<double>(header[deviationAt]),
                                     std::vector<double>(header[phiAt])});
  return f;
}

void checkHeader(const std::uint32_t* header, float highest, std::uint64_t bytes) {
  checkNumber("the version", header[versionAt], version, version);
  checkNumber("the form", header[formAt], 0, 1);
  checkNumber("the transform", header[transformAt], 0, std::uint32_t(dataTransformNames.size()) - 1);
  checkNumber("the count of nodes of theta_R", header[thetaAt], 2, mostNodes);
  checkNumber("the count of nodes of |Dp|", header[deviationAt], 2, mostNodes);
  checkNumber("the count of nodes of |phi|", header[phiAt], header[formAt] == 0 ? 1 : 2,
              header[formAt] == 0 ? 1 : mostNodes);
  checkNumber("the count of terms", header[termsAt], 1, std::uint32_t(mostPdvTerms));
  if (!std::isfinite(highest)) fail("the highest value", "not finite", "a number");
  const std::uint64_t nodes = std::uint64_t(header[thetaAt]) + header[deviationAt] + header[phiAt];
  const std::uint64_t expected = headerBytes + sizeof(float) * floatCount(nodes, header[termsAt]);
  if (bytes != expected)
    fail("the size of the file", std::to_string(bytes) + " bytes", std::to_string(expected) + " for these counts");
}

}  // namespace

std::size_t pdvFileBytes(const PdvFactors& f) {
  return headerBytes + sizeof(float) * floatCount(f.thetaNodes.size() + f.deviationNodes.size() + f.phiNodes.size(),
                                                  std::size_t(f.terms()));
}

void writePdv(const PdvFactors& factors, const std::filesystem::path& path) {
  PdvFactors f = factors;
  const std::uint32_t header[headerNumbers] = {version,
                                               f.form == PdvForm::twoFactors ? 0u : 1u,
                                               static_cast<std::uint32_t>(f.transform),
                                               std::uint32_t(f.thetaNodes.size()),
                                               std::uint32_t(f.deviationNodes.size()),
                                               std::uint32_t(f.phiNodes.size()),
                                               std::uint32_t(f.terms())};
  const float highest = float(f.highest);
  std::vector<std::byte> bytes(pdvFileBytes(f));
  std::byte* at = bytes.data();
  const auto put = [&](const void* from, std::size_t count) {
    std::memcpy(at, from, count);
    at += count;
  };
  put(magic, magicBytes);
  put(header, sizeof header);
  put(&highest, sizeof highest);
  visitCurves(f, [&](const std::vector<double>& curve) {
    for (const double value : curve) {
      const float single = float(value);
      put(&single, sizeof single);
    }
  });
  io::writeFileAtomically(path, bytes);
}

PdvFactors readPdv(const io::ByteSource& source) {
  std::byte start[headerBytes];
  if (source.size() < headerBytes)
    fail("the size of the file", std::to_string(source.size()) + " bytes", "at least " + std::to_string(headerBytes));
  source.readAt(0, start);
  if (std::memcmp(start, magic, magicBytes) != 0)
    throw Error(std::string("PDV factors: the file does not begin with ") + magic);
  std::uint32_t header[headerNumbers];
  float highest = 0;
  std::memcpy(header, start + magicBytes, sizeof header);
  std::memcpy(&highest, start + magicBytes + sizeof header, sizeof highest);
  checkHeader(header, highest, source.size());
  PdvFactors f = emptyFactors(header, highest);
  const std::vector<std::byte> bytes = source.readAll();
  const std::byte* at = bytes.data() + headerBytes;
  visitCurves(f, [&](std::vector<double>& curve) {
    for (double& value : curve) {
      float single = 0;
      std::memcpy(&single, at, sizeof single);
      at += sizeof single;
      if (!std::isfinite(single))
        fail("number " + std::to_string((at - bytes.data() - std::ptrdiff_t(headerBytes)) / 4 - 1), "not finite",
             "a number");
      value = double(single);
    }
  });
  checkNodes(f.thetaNodes, "theta_R");
  checkNodes(f.deviationNodes, "|Dp|");
  checkNodes(f.phiNodes, "|phi|");
  return f;
}

PdvFactors readPdv(const std::filesystem::path& path) {
  return namingFile(path, [&] { return readPdv(io::FileSource(path)); });
}

bool isPdv(const std::filesystem::path& path) {
  char start[magicBytes] = {};
  std::ifstream stream(path, std::ios::binary);
  return stream.read(start, magicBytes) && std::memcmp(start, magic, magicBytes) == 0;
}

bool isPdv(const io::ByteSource& source) { return io::beginsWith(source, std::string_view(magic, magicBytes)); }

}  // namespace gonio::materials
