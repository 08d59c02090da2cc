// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/common_parameters.h"
#include "core/models/registry.h"
#include "core/models/ward_lobe.h"

namespace gonio::models {

namespace {

enum Index { diffuse, specular, roughness };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1, "k_s exp(-tan^2 theta_h / alpha^2) / (4 pi alpha^2 sqrt(cos theta_i cos theta_o))", ward1992),
    roughnessParameter("alpha", "Width of the highlight: the root mean square slope of the surface.",
                       "exp(-tan^2 theta_h / alpha^2)", ward1992),
};

constexpr ModelSpec wardSpec = {
    .id = "ward", .name = "Ward",
    .description = "A Gaussian of surface slopes, isotropic, without a Fresnel term. Reciprocal. Loses light "
                   "toward grazing angles, then gains it without bound within a fraction of a degree of the "
                   "horizon.",
    .formula = "k_d / pi + k_s exp(-tan^2 theta_h / alpha^2) / (4 pi alpha^2 sqrt(cos theta_i cos theta_o))",
    .reference = "Ward 1992, Measuring and Modeling Anisotropic Reflection, eq. 4", .parameters = parameters,
    .family = ModelFamily::empirical};
// clang-format on

class Ward final : public Model {
 public:
  const ModelSpec& spec() const override { return wardSpec; }

 protected:
  std::unique_ptr<const Brdf> create(const ParameterValues& p) const override {
    return makeWardBrdf(p.values[diffuse], p.values[specular], p.values[roughness].x, p.values[roughness].x,
                        [](const SurfaceGeometry& g) { return 1 / std::sqrt(g.cosI * g.cosO); });
  }
};

}  // namespace

const Model& ward() {
  static const Ward model;
  return model;
}

}  // namespace gonio::models
