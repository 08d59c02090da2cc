// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/materials/material.h"

/// The bundled library (bundledLibrary() lists it): how its materials are named and read.
namespace gonio::materials {

inline constexpr std::string_view libraryScheme = "library:";

/// MaterialSource::sha256 of the material of such a path, which is not read for it; empty where there is none.
std::string librarySha256(const std::string& path);

/// Paths of the materials from which others are learned, each material once: the measured ones, then the near-measured
/// copies of those that are not among them. No published fits.
std::vector<std::string> libraryTrainingPaths();

/// The material of a path such as "library:rgl/NAME" (MeasuredMaterial), "library:merl-copy/NAME"
/// (NearMeasuredMaterial) or "library:sgd/NAME" (SgdFit).
/// @throws Error when there is none of this name; Cancelled.
Material readLibraryMaterial(const std::string& path, const TaskControl& control = {});

}  // namespace gonio::materials
