// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>

#include "core/models/anisotropic_parameters.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/models/ward_lobe.h"

namespace gonio::models {

namespace {

constexpr std::string_view neumann1999 = "Neumann, Neumann and Szirmay-Kalos 1999, Compact Metallic Reflectance Models";

enum Index { diffuse, specular, roughnessX, roughnessY };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1,
                      "k_s exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / "
                      "(4 pi alpha_x alpha_y max(cos theta_i, cos theta_o))",
                      neumann1999),
    roughnessXParameter("exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2)", ward1992),
    roughnessYParameter("exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2)", ward1992),
};

constexpr ModelSpec neumannWardSpec = {
    .id = "neumann-ward", .name = "Neumann-Neumann (Ward)",
    .description = "Ward's Gaussian divided by the larger cosine, for metals: bounded everywhere. Reciprocal; "
                   "the albedo of the highlight never exceeds k_s and falls toward grazing angles.",
    .formula = "k_d / pi + k_s exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / "
               "(4 pi alpha_x alpha_y max(cos theta_i, cos theta_o))",
    .reference = neumann1999, .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

class NeumannWard final : public Model {
 public:
  const ModelSpec& spec() const override { return neumannWardSpec; }

 protected:
  std::unique_ptr<const Brdf> create(const ParameterValues& p) const override {
    return makeWardBrdf(p.values[diffuse], p.values[specular], p.values[roughnessX].x, p.values[roughnessY].x,
                        [](const SurfaceGeometry& g) { return 1 / std::max(g.cosI, g.cosO); });
  }
};

}  // namespace

const Model& neumannWard() {
  static const NeumannWard model;
  return model;
}

}  // namespace gonio::models
