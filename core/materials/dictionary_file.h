// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "core/dictionary/training.h"
#include "core/io/byte_source.h"

namespace gonio::materials {

/// Writes an ensemble, `.dictionary`: a container (core/io/container.h) "GONIODIC", version 1; a description with the
/// grid, the sparsities and the training materials; the matrices of each dictionary (phi_d, theta_d, theta_h), column
/// by column, float32. 5.9 MiB for 32 dictionaries. Readers orthonormalise the matrices again, to 1e-12
/// (dictionary::polished()). @param half whether the values are float16: half the size, and entries change by up to
/// 1/2000 of their size.
void writeDictionary(const dictionary::Ensemble& ensemble, const std::filesystem::path& path, bool half = false);

/// An ensemble with the id that codes refer to.
struct NamedEnsemble {
  dictionary::Ensemble ensemble;
  std::uint64_t id = 0;  ///< the first eight bytes of the SHA-256 of the file
};

/// @throws Error that names the file, what was found and what was expected.
std::shared_ptr<const NamedEnsemble> readDictionary(const std::filesystem::path& path);
/// The same for bytes; errors name no file.
std::shared_ptr<const NamedEnsemble> readDictionary(const io::ByteSource& source);

/// The ids of the ensembles bundled with Gonio: the one for new codes, that of the published method
/// (dictionary::publishedEncodeOptions()), and that of version 0.2.0.
std::span<const std::uint64_t> bundledIds();
/// The bundled ensemble with an id, read at the first call (about 0.1 s); null if none has the id.
std::shared_ptr<const NamedEnsemble> bundledEnsemble(std::uint64_t id = bundledIds().front());
/// The bundled ensemble for dictionary::publishedEncodeOptions(): learned without cell scaling.
inline std::shared_ptr<const NamedEnsemble> publishedEnsemble() { return bundledEnsemble(bundledIds()[1]); }

/// Writes a checkpoint of a training, atomically: a container (core/io/container.h) "GONIOCKP", version 1, with a
/// description that identifies the training, and the state in double precision. @param training text that identifies
/// the materials and options; readCheckpoint() requires the same text. @throws Error that names the file.
void writeCheckpoint(const dictionary::TrainingState& state, const std::string& training,
                     const std::filesystem::path& path);
/// @throws Error that names the file, also if it belongs to another training.
dictionary::TrainingState readCheckpoint(const std::string& training, const std::filesystem::path& path);

}  // namespace gonio::materials
