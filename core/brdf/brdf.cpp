// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/brdf.h"

#include "core/brdf/density_mixture.h"

namespace gonio {

DirectionSample Brdf::sample(const Direction& wo, const glm::dvec3& u) const { return cosineSampler().sample(wo, u); }

double Brdf::pdf(const Direction& wi, const Direction& wo) const { return cosineSampler().pdf(wi, wo); }

}  // namespace gonio
