// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/dictionary/training_materials.h"
#include "core/photograph/photograph_prior.h"
#include "core/support/task_control.h"

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

/// Classes by which a training set can be split (Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance
/// Modeling and Acquisition", section 5.2.2.1, names diffuse and glossy materials and states no rule).
enum class MaterialClass { all, diffuse, glossy };
/// Names on the command line and in Python, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> materialClassNames{"all", "diffuse", "glossy"};
/// @throws Error that lists the names.
MaterialClass materialClassNamed(std::string_view name);

/// The largest ratio, over polar angles of 15, 30 and 45 degrees, of the luminance in the mirror direction to that at
/// the same polar angles with the viewer 90 degrees beside the plane of incidence. 1 for a Lambertian material;
/// infinite if it is black beside the plane.
double highlightContrast(const Brdf& material);
/// highlightContrast() from which a material counts as glossy.
inline constexpr double glossyContrast = 3;

/// The files of a class, in their order. Opens each file unless the class is `all`; in parallel.
/// @throws Error if none is of the class; as documents::openMaterial(); Cancelled.
std::vector<std::string> filesOfClass(const std::vector<std::string>& files, MaterialClass materialClass,
                                      const TaskControl& control = {});

/// The class of each training material of a prior for photographs: 0 diffuse, 1 glossy (highlightContrast(), of its
/// table on the grid of the prior). About 0.03 s per material; parallel.
std::vector<std::size_t> photographClasses(const photograph::PhotographPrior& prior);
/// Number of classes that photographClasses() tells apart.
inline constexpr std::size_t photographClassCount = materialClassNames.size() - 1;

}  // namespace gonio::study
