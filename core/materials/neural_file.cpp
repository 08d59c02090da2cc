// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/neural_file.h"

#include <array>

#include "core/io/atomic_file.h"
#include "core/io/container.h"
#include "core/support/file_in_errors.h"

namespace gonio::materials {

namespace {

constexpr io::ContainerFormat neuralFormat{
    .name = "neural BRDF", .signature = "GONIONBR", .maxBytes = std::uint64_t(1) << 16};

}  // namespace

std::vector<std::byte> encodeNeural(std::span<const float, NeuralBrdf::weightCount> weights) {
  io::ContainerWriter file(neuralFormat);
  file.values(weights);
  return std::move(file).bytes();
}

void writeNeural(std::span<const float, NeuralBrdf::weightCount> weights, const std::filesystem::path& path) {
  io::writeFileAtomically(path, encodeNeural(weights));
}

NeuralBrdf readNeural(const io::ByteSource& source) {
  io::ContainerReader file(neuralFormat, source);
  std::array<float, NeuralBrdf::weightCount> weights;
  file.expectRemaining(sizeof weights);
  file.values(weights, "weight");
  return NeuralBrdf(weights);
}

NeuralBrdf readNeural(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return readNeural(io::FileSource(path)); });
}

void expectNeural(const io::ByteSource& source) { io::expectSignature(source, neuralFormat); }

}  // namespace gonio::materials
