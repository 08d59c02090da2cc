// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/rendering/render_material.h"
#include "core/support/task_control.h"

namespace gonio::rendering {

/// From which density the path tracer samples directions for a material, for comparisons as in figure 4.4 of
/// Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition".
struct SamplingMethod {
  std::string_view id;    ///< on the command line and in Python
  std::string_view name;  ///< in lists
  std::string_view text;  ///< one sentence
};

/// In their order: "auto" (the first; RenderMaterial chooses), "pdv", "published", "lawrence", "bilgili", "ggx",
/// "cosine".
std::span<const SamplingMethod> samplingMethods();

/// A material that is sampled by a method. The methods "pdv", "published", "lawrence" and "bilgili" factorise a table
/// of the material first (1 to 10 s), with one term (pdv, published) or factors of 44.7 kB; "ggx" fits the model. The
/// published density does not cover all directions: an image by it can lack light where lights are not sampled as well.
/// @throws Error for an unknown method, with the list; Cancelled.
std::shared_ptr<const RenderMaterial> sampledBy(std::string_view method, std::shared_ptr<const Brdf> brdf,
                                                const TaskControl& control = {});

}  // namespace gonio::rendering
