// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/anisotropic_parameters.h"
#include "core/models/registry.h"
#include "core/models/ward_lobe.h"

namespace gonio::models {

namespace {

enum Index { diffuse, specular, roughnessX, roughnessY };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1,
                      "k_s exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / "
                      "(4 pi alpha_x alpha_y sqrt(cos theta_i cos theta_o))",
                      ward1992),
    roughnessXParameter("exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2)", ward1992),
    roughnessYParameter("exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2)", ward1992),
};

constexpr ModelSpec wardAnisotropicSpec = {
    .id = "ward-anisotropic", .name = "Ward anisotropic",
    .description = "A Gaussian of surface slopes with a width along either axis: brushed metal, satin. "
                   "Reciprocal. Loses light toward grazing angles, then gains it without bound within a fraction "
                   "of a degree of the horizon.",
    .formula = "k_d / pi + k_s exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / "
               "(4 pi alpha_x alpha_y sqrt(cos theta_i cos theta_o))",
    .reference = "Ward 1992, Measuring and Modeling Anisotropic Reflection, eq. 5a (h by its components: Walter 2005)", .parameters = parameters,
    .family = ModelFamily::empirical};
// clang-format on

class WardAnisotropic final : public Model {
 public:
  const ModelSpec& spec() const override { return wardAnisotropicSpec; }

 protected:
  std::unique_ptr<const Brdf> create(const ParameterValues& p) const override {
    return makeWardBrdf(p.values[diffuse], p.values[specular], p.values[roughnessX].x, p.values[roughnessY].x,
                        [](const SurfaceGeometry& g) { return 1 / std::sqrt(g.cosI * g.cosO); });
  }
};

}  // namespace

const Model& wardAnisotropic() {
  static const WardAnisotropic model;
  return model;
}

}  // namespace gonio::models
