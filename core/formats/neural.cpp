// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/neural.h"

#include <array>

#include "core/formats/formats.h"
#include "core/io/atomic_file.h"
#include "core/io/container.h"
#include "core/support/error.h"

namespace gonio::formats {

namespace {

constexpr io::ContainerFormat neuralContainer{
    .name = "neural BRDF", .signature = "GONIONBR", .maxBytes = std::uint64_t(1) << 16};

}  // namespace

std::vector<std::byte> encodeNeural(std::span<const float, NeuralBrdf::weightCount> weights) {
  io::ContainerWriter file(neuralContainer);
  file.values(weights);
  return std::move(file).bytes();
}

void writeNeural(std::span<const float, NeuralBrdf::weightCount> weights, const std::filesystem::path& path) {
  io::writeFileAtomically(path, encodeNeural(weights));
}

NeuralBrdf readNeural(const io::ByteSource& source) {
  io::ContainerReader file(neuralContainer, source);
  std::array<float, NeuralBrdf::weightCount> weights;
  file.expectRemaining(sizeof weights);
  file.values(weights, "weight");
  return NeuralBrdf(weights);
}

NeuralBrdf readNeural(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] { return readNeural(io::FileSource(path)); });
}

namespace {

void sniffNeural(const io::ByteSource& source) { io::expectSignature(source, neuralContainer); }

void readNeuralMaterial(const io::ByteSource& source, const TaskControl&, materials::Material& material) {
  material.brdf = std::make_shared<const NeuralBrdf>(readNeural(source));
  material.source.grid = {int(NeuralBrdf::weightCount)};
  material.source.description = "network with two hidden layers of " + std::to_string(NeuralBrdf::hidden) + " units";
}

constexpr std::string_view neuralSuffixes[] = {".nbrdf"};

}  // namespace

constinit const MaterialFormat neuralFormat{.name = "neural BRDF",
                                            .label = "neural BRDF",
                                            .suffixes = neuralSuffixes,
                                            .sniff = sniffNeural,
                                            .read = readNeuralMaterial};

}  // namespace gonio::formats
