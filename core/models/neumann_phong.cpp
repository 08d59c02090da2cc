// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>

#include "core/brdf/cosine_power_lobe.h"
#include "core/models/cosine_power.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"

namespace gonio::models {

namespace {

constexpr std::string_view neumann1999 = "Neumann, Neumann and Szirmay-Kalos 1999, Compact Metallic Reflectance Models";
constexpr std::string_view normalisations[] = {"energy", "none"};

enum Index { diffuse, specular, exponent, normalisation };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1, "k_s N max(0, cos alpha)^n / max(cos theta_i, cos theta_o)", neumann1999),
    exponentParameter("max(0, cos alpha)^n", neumann1999),
    choiceParameter("normalisation", "Normalisation", "N",
                    "Whether the brightness of the highlight follows its sharpness, so that its energy stays.",
                    "energy: (n + 1) / (2 pi) (derived: bounds the albedo by k_s); none: 1", neumann1999,
                    normalisations),
};

constexpr ModelSpec neumannPhongSpec = {
    .id = "neumann-phong", .name = "Neumann-Neumann (Phong)",
    .description = "Phong's lobe divided by the larger cosine, for metals. Reciprocal; the albedo of the "
                   "highlight never exceeds k_s. With the normalisation 'none' its energy depends on the "
                   "exponent and exceeds 1 for broad lobes.",
    .formula = "k_d / pi + k_s N max(0, cos alpha)^n / max(cos theta_i, cos theta_o)",
    .reference = neumann1999, .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

class NeumannPhong final : public Model {
 public:
  const ModelSpec& spec() const override { return neumannPhongSpec; }

 protected:
  std::unique_ptr<const Brdf> create(const ParameterValues& p) const override {
    const double n = p.values[exponent].x;
    const double bound = (n + 1) / (2 * pi);
    const double factor = chosen(p.values[normalisation].x) == 0 ? bound : 1;
    const Rgb kd = p.values[diffuse] / pi, ks = p.values[specular] * factor;
    return makeGeometryBrdf(
        [=](const SurfaceGeometry& g) { return kd + ks * (reflectionPower(g, n) / std::max(g.cosI, g.cosO)); },
        diffuseAnd(maxChannel(p.values[diffuse]), maxChannel(ks) / bound, CosinePowerLobe{n}));
  }
};

}  // namespace

const Model& neumannPhong() {
  static const NeumannPhong model;
  return model;
}

}  // namespace gonio::models
