// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/dictionary/training_materials.h"

namespace gonio::study {

/// Help text of options that take a training set, e.g. "Measured materials (.binary and .bsdf files) or folders of
/// them".
std::string trainingHelp();

/// The files of a training set. Folders in `sources` are replaced by all measured materials in them
/// (MaterialFormat::isMeasurement), sorted by name; other entries remain. Materials named in `excluded` are removed.
/// @throws Error if a folder has no measured material, an excluded name matches none, or none is left.
std::vector<std::string> trainingFiles(const std::vector<std::string>& sources,
                                       const std::vector<std::string>& excluded = {});

/// The same; without sources the measured and near-measured bundled materials (materials::libraryTrainingPaths()).
std::vector<std::string> trainingFilesOrLibrary(const std::vector<std::string>& sources,
                                                const std::vector<std::string>& excluded = {});

/// The grid of the first file if it is a table, otherwise the MERL grid. All files must have it. @throws as
/// editing::openMaterial().
HalfDifferenceGrid trainingGrid(const std::vector<std::string>& files);

/// What a method learns from materials that are not reciprocal.
enum class TrainingOrders {
  mean,  ///< the mean of both orders of the directions, as from a MERL file
  both   ///< both orders: the tables of these materials cover the whole circle of phi_d
};

/// The tables of the files; `load` throws Error that names a file with another grid than `grid`, or than its whole
/// circle where the table has both orders of the directions.
dictionary::TrainingMaterials trainingMaterials(const std::vector<std::string>& files,
                                                const HalfDifferenceGrid& grid = {},
                                                TrainingOrders orders = TrainingOrders::mean);

}  // namespace gonio::study
