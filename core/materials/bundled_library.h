// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/materials/material.h"

/// Names and reading of the bundled materials, which bundledLibrary() lists.
namespace gonio::materials {

inline constexpr std::string_view libraryScheme = "library:";

/// MaterialSource::sha256 of the material of a library path, without reading it; empty if there is no such material.
std::string librarySha256(const std::string& path);

/// Paths of the default training set, each material once: the measured ones, then near-measured copies of materials
/// that are not among them. No published fits.
std::vector<std::string> libraryTrainingPaths();

/// The material of a path such as "library:rgl/NAME" (MeasuredMaterial), "library:merl-copy/NAME"
/// (NearMeasuredMaterial) or "library:sgd/NAME" (SgdFit).
/// @throws Error if there is no material of this name; Cancelled.
Material readLibraryMaterial(const std::string& path, const TaskControl& control = {});

}  // namespace gonio::materials
