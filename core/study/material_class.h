// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/support/task_control.h"

namespace gonio::study {

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

}  // namespace gonio::study
