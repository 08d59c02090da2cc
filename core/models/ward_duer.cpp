// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/anisotropic_parameters.h"
#include "core/models/registry.h"
#include "core/models/ward_lobe.h"

namespace gonio::models {

namespace {

constexpr std::string_view duer = "Duer 2006, An Improved Normalization for the Ward Reflectance Model";

enum Index { diffuse, specular, roughnessX, roughnessY };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1,
                      "k_s exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / "
                      "(4 pi alpha_x alpha_y cos theta_i cos theta_o)",
                      duer),
    roughnessXParameter("exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2)", ward1992),
    roughnessYParameter("exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2)", ward1992),
};

constexpr ModelSpec wardDuerSpec = {
    .id = "ward-duer", .name = "Ward-Duer",
    .description = "Ward's Gaussian divided by both cosines in full: conserves energy better at middle angles. "
                   "Reciprocal, but at grazing angles it gains energy without bound (3.4 at 89 degrees with "
                   "roughness 0.2).",
    .formula = "k_d / pi + k_s exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / "
               "(4 pi alpha_x alpha_y cos theta_i cos theta_o)",
    .reference = duer, .parameters = parameters,
    .family = ModelFamily::empirical};
// clang-format on

class WardDuer final : public Model {
 public:
  const ModelSpec& spec() const override { return wardDuerSpec; }

 protected:
  std::unique_ptr<const Brdf> create(const ParameterValues& p) const override {
    return makeWardBrdf(p.values[diffuse], p.values[specular], p.values[roughnessX].x, p.values[roughnessY].x,
                        [](const SurfaceGeometry& g) { return 1 / (g.cosI * g.cosO); });
  }
};

}  // namespace

const Model& wardDuer() {
  static const WardDuer model;
  return model;
}

}  // namespace gonio::models
