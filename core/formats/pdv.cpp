// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/pdv.h"

#include <array>
#include <cmath>

#include "core/factorization/deviation_grid.h"
#include "core/factorization/pdv_operations.h"
#include "core/formats/formats.h"
#include "core/io/atomic_file.h"
#include "core/io/container.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::formats {

namespace {

using factorization::maxCurveValue;
using factorization::maxPdvTerms;
using factorization::PdvFactors;
using factorization::PdvForm;
using factorization::PdvTerm;

constexpr io::ContainerFormat pdvContainerOf(bool hasNegativeValues) {
  return {.name = "PDV", .signature = "GONIOPDV", .version = hasNegativeValues ? 2u : 1u, .readVersion = 1};
}
constexpr io::ContainerFormat pdvContainer = pdvContainerOf(true);
constexpr std::uint32_t maxFactorNodes = factorization::maxPdvNodes;
enum HeaderAt { formAt, transformAt, thetaAt, deviationAt, phiAt, termsAt, headerNumbers };
using Header = std::array<std::uint32_t, headerNumbers>;
/// Signature, version, header and highest y; version 2 also has the lowest y.
constexpr std::size_t headerBytes = 8 + sizeof(std::uint32_t) + sizeof(Header) + sizeof(float);

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

[[noreturn]] void fail(const io::ContainerReader& file, const std::string& what, const std::string& found,
                       const std::string& expected) {
  file.fail(what + " is " + found + ", expected " + expected);
}

void checkNodes(const io::ContainerReader& file, const std::vector<double>& nodes, const char* what) {
  if (nodes.front() != 0) fail(file, std::string("the first node of ") + what, numberText(nodes.front()), "0");
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (!(nodes[i] > nodes[i - 1]))
      fail(file, "node " + std::to_string(i) + " of " + what, numberText(nodes[i]),
           "more than " + numberText(nodes[i - 1]));
}

PdvFactors emptyFactors(const Header& header, float highest, float lowest) {
  PdvFactors f{.form = header[formAt] == 0 ? PdvForm::twoFactors : PdvForm::threeFactors,
               .transform = static_cast<DataTransform>(header[transformAt]),
               .thetaNodes = std::vector<double>(header[thetaAt]),
               .deviationNodes = std::vector<double>(header[deviationAt]),
               .phiNodes = std::vector<double>(header[phiAt]),
               .channels = {},
               .highest = double(highest),
               .lowest = double(lowest)};
  for (std::vector<PdvTerm>& channel : f.channels)
    channel.assign(header[termsAt], {std::vector<double>(header[thetaAt]), std::vector<double>(header[deviationAt]),
                                     std::vector<double>(header[phiAt])});
  return f;
}

void checkHeader(const io::ContainerReader& file, const Header& header, float highest, float lowest) {
  const auto check = [&](const char* what, HeaderAt at, std::uint32_t low, std::uint32_t high) {
    if (header[at] < low || header[at] > high)
      fail(file, what, std::to_string(header[at]),
           std::to_string(low) + (low == high ? "" : " to " + std::to_string(high)));
  };
  if (header[formAt] > 1) fail(file, "the form", std::to_string(header[formAt]), "0 (two curves) or 1 (three curves)");
  check("the transform", transformAt, 0, std::uint32_t(dataTransformNames.size()) - 1);
  check("the count of nodes of theta_R", thetaAt, 2, maxFactorNodes);
  check("the count of nodes of |Dp|", deviationAt, 2, maxFactorNodes);
  const bool isFlat = header[formAt] == 0;
  check("the count of nodes of |phi|", phiAt, isFlat ? 1 : 2, isFlat ? 1 : maxFactorNodes);
  check("the count of terms", termsAt, 1, std::uint32_t(maxPdvTerms));
  if (!std::isfinite(highest)) fail(file, "the maximum transformed BRDF value", "not finite", "a finite number");
  if (!std::isfinite(lowest) || lowest > 0)
    fail(file, "the minimum transformed BRDF value", numberText(double(lowest)), "0 or a negative number");
  const std::size_t nodes = std::size_t(header[thetaAt]) + header[deviationAt] + header[phiAt];
  file.expectRemaining(sizeof(float) * floatCount(nodes, header[termsAt]));
}

}  // namespace

std::size_t pdvFileBytes(const PdvFactors& f) {
  return headerBytes + (f.lowest < 0 ? sizeof(float) : 0) +
         sizeof(float) *
             floatCount(f.thetaNodes.size() + f.deviationNodes.size() + f.phiNodes.size(), std::size_t(f.terms()));
}

std::size_t pdvFileBytes(factorization::PdvForm form, int terms) {
  using namespace factorization;
  const std::size_t phis = form == PdvForm::twoFactors ? 1 : pdvPhiNodes;
  return headerBytes + sizeof(float) * floatCount(phis + pdvThetaNodes + defaultDeviations, std::size_t(terms));
}

void writePdv(const PdvFactors& factors, const std::filesystem::path& path) {
  PdvFactors f = factors;
  io::ContainerWriter file(pdvContainerOf(f.lowest < 0));
  file.values(Header{f.form == PdvForm::twoFactors ? 0u : 1u, std::uint32_t(f.transform),
                     std::uint32_t(f.thetaNodes.size()), std::uint32_t(f.deviationNodes.size()),
                     std::uint32_t(f.phiNodes.size()), std::uint32_t(f.terms())});
  file.number(float(std::min(f.highest, maxBrdfValue)));
  if (f.lowest < 0) file.number(float(std::max(f.lowest, -maxBrdfValue)));
  visitCurves(f, [&](const std::vector<double>& curve) {
    for (const double value : curve) file.number(float(std::clamp(value, -maxCurveValue, maxCurveValue)));
  });
  io::writeFileAtomically(path, file.bytes());
}

PdvFactors readPdv(const io::ByteSource& source) {
  io::ContainerReader file(pdvContainer, source);
  Header header;
  file.values(header, "header");
  const auto highest = file.number<float>();
  const float lowest = file.version() > 1 ? file.number<float>() : 0;
  checkHeader(file, header, highest, lowest);
  PdvFactors f = emptyFactors(header, highest, lowest);
  std::size_t at = 0;
  visitCurves(f, [&](std::vector<double>& curve) {
    for (double& value : curve) {
      value = double(file.number<float>());
      if (!std::isfinite(value)) fail(file, "number " + std::to_string(at), "not finite", "a number");
      ++at;
    }
  });
  checkNodes(file, f.thetaNodes, "theta_R");
  checkNodes(file, f.deviationNodes, "|Dp|");
  checkNodes(file, f.phiNodes, "|phi|");
  return f;
}

PdvFactors readPdv(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return readPdv(io::FileSource(path)); });
}

bool isPdv(const std::filesystem::path& path) {
  try {
    return io::hasSignature(io::FileSource(path), pdvContainer);
  } catch (const Error&) {
    return false;
  }
}

namespace {

void sniffPdv(const io::ByteSource& source) { io::expectSignature(source, pdvContainer); }

void readPdvMaterial(const io::ByteSource& source, const TaskControl&, materials::Material& material) {
  const PdvFactors factors = readPdv(source);
  material.brdf = factorization::makePdvBrdf(factors);
  material.source.grid = {int(factors.thetaNodes.size()), int(factors.deviationNodes.size()),
                          int(factors.phiNodes.size())};
  material.source.description = std::to_string(factors.terms()) + (factors.terms() == 1 ? " term of " : " terms of ") +
                                (factors.form == PdvForm::twoFactors ? "two" : "three") + " factors, transform " +
                                std::string(dataTransformNames[std::size_t(factors.transform)]);
  if (const std::string warning = factorization::curveLimitWarning(factors); !warning.empty())
    material.source.notes.push_back("warning: " + warning);
}

constexpr std::string_view pdvSuffixes[] = {".pdv"};

}  // namespace

constinit const MaterialFormat pdvFormat{.name = "PDV factors",
                                         .label = "PDV factors",
                                         .suffixes = pdvSuffixes,
                                         .holds = {.nonReciprocal = true},
                                         .sniff = sniffPdv,
                                         .read = readPdvMaterial};

}  // namespace gonio::formats
