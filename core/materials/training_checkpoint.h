// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>

#include "core/dictionary/training.h"

namespace gonio::materials {

/// A checkpoint of a training, atomic: a container (core/io/container.h) "GONIOCKP", version 1, with a description that
/// names the training, and the state in double precision. @throws Error naming the file.
void writeCheckpoint(const dictionary::TrainingState& state, const std::string& training,
                     const std::filesystem::path& path);
/// @throws Error naming the file; also where it is of another training.
dictionary::TrainingState readCheckpoint(const std::string& training, const std::filesystem::path& path);

}  // namespace gonio::materials
