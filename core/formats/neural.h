// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "core/brdf/neural_brdf.h"
#include "core/io/byte_source.h"

/// A file of a neural BRDF, `.nbrdf`: a container (core/io/container.h) "GONIONBR", uint32 version 1; then the weights
/// of NeuralBrdf, float32, in its order.
namespace gonio::formats {

inline constexpr std::size_t neuralFileBytes = 8 + 4 + NeuralBrdf::weightCount * sizeof(float);

/// The bytes of the file.
std::vector<std::byte> encodeNeural(std::span<const float, NeuralBrdf::weightCount> weights);
/// Writes a file, atomically. @throws Error that names the file.
void writeNeural(std::span<const float, NeuralBrdf::weightCount> weights, const std::filesystem::path& path);
/// @throws Error that states what was found and what was expected.
NeuralBrdf readNeural(const io::ByteSource& source);
/// The same; the error names the file.
NeuralBrdf readNeural(const std::filesystem::path& path);

}  // namespace gonio::formats
