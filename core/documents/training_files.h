// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/dictionary/training_materials.h"

namespace gonio::editing {

/// "Folders of .binary and .bsdf files, or files".
std::string trainingHelp();

/// Files as they are, of folders all measured materials (MaterialFormat::isMeasurement), in the order of their names;
/// less the excluded names.
/// @throws Error when a folder has none, a name excludes nothing, or none is left.
std::vector<std::string> trainingFiles(const std::vector<std::string>& sources,
                                       const std::vector<std::string>& excluded = {});

/// The grid of the first file's table, which all others must share; that of MERL tables where it has a form of its own.
HalfDifferenceGrid trainingGrid(const std::vector<std::string>& files);

/// Their tables; `load` throws Error naming a file of another grid than the one expected.
dictionary::TrainingMaterials trainingMaterials(const std::vector<std::string>& files,
                                                const HalfDifferenceGrid& grid = {});

}  // namespace gonio::editing
