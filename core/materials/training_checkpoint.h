// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>

#include "core/dictionary/training.h"

namespace gonio::materials {

/// Writes a checkpoint of a training, atomically: a container (core/io/container.h) "GONIOCKP", version 1, with a
/// description that identifies the training, and the state in double precision. @param training text that identifies
/// the materials and options; readCheckpoint() requires the same text. @throws Error that names the file.
void writeCheckpoint(const dictionary::TrainingState& state, const std::string& training,
                     const std::filesystem::path& path);
/// @throws Error that names the file, also if it belongs to another training.
dictionary::TrainingState readCheckpoint(const std::string& training, const std::filesystem::path& path);

}  // namespace gonio::materials
