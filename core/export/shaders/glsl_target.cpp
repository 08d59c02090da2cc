// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>

#include "core/export/export_files.h"
#include "core/export/shaders/shading_models.h"
#include "core/export/target_table.h"
#include "core/support/text.h"

namespace gonio::exports {

namespace {

constexpr std::string_view glslSuffix = ".glsl";
/// Numbers of lobes, the first that reaches the SNR is taken.
constexpr std::size_t glslLobeCounts[] = {1, 2, 4, 6};

constexpr const char* glslUsage = R"(
// GLSL 3.30 or GLSL ES 3.00. gonioBrdf(wi, wo) is the BRDF in 1/sr, linear sRGB, without the cosine. wi points to the
// light, wo to the viewer: unit vectors in the shading frame, z the normal and x the tangent.
// Light that reaches the viewer: radiance * gonioBrdf(wi, wo) * wi.z.
)";

constexpr const char* glslBody = R"(
// cos theta (1 + Lambda) of Smith's masking for GGX.
float gonioShadowedCosine(vec3 w, vec2 alpha) {
  vec2 stretched = alpha * w.xy;
  return 0.5 * (w.z + sqrt(dot(stretched, stretched) + w.z * w.z));
}

// D G2 / (4 cos theta_i cos theta_o), height-correlated (Heitz 2014).
float gonioLobe(vec3 wi, vec3 wo, vec3 h, vec2 alpha) {
  vec2 slope = h.xy / alpha;
  float d = dot(slope, slope) + h.z * h.z;
  float i = gonioShadowedCosine(wi, alpha), o = gonioShadowedCosine(wo, alpha);
  return 0.25 / (3.14159265 * alpha.x * alpha.y * d * d * (o * wi.z + i * wo.z - wi.z * wo.z));
}

// Schlick's term with values at 0, 82 and 90 degrees (Hoffman 2023).
vec3 gonioFresnel(float cosD, vec3 f0, vec3 f82, vec3 f90) {
  float m = 1.0 - cosD, s = m * m * m * m * m;
  const float rest5 = 0.46266436;
  vec3 dip = mix(f0, f90, rest5) * (1.0 - f82) * (7.0 / (rest5 * 0.85714286));
  return mix(f0, f90, s) - dip * (cosD * s * m);
}

vec3 gonioBrdf(vec3 wi, vec3 wo) {
  if (wi.z <= 0.0 || wo.z <= 0.0) return vec3(0.0);
  mat2 toGrain = mat2(gonioGrain.x, -gonioGrain.y, gonioGrain.y, gonioGrain.x);
  wi.xy = toGrain * wi.xy;
  wo.xy = toGrain * wo.xy;
  vec3 h = normalize(wi + wo);
  float cosD = min(1.0, dot(wi, h));
  vec3 value = gonioDiffuse / 3.14159265;
  for (int k = 0; k < gonioLobeCount; ++k)
    value += gonioLobe(wi, wo, h, gonioAlpha[k]) * gonioFresnel(cosD, gonioF0[k], gonioF82[k], gonioF90[k]);
  return value;
}
)";

/// One line. A backslash at its end would continue the comment.
std::string glslComment(const std::string& text) {
  const std::string line = "// " + plainText(text);
  return line + (line.ends_with('\\') ? ".\n" : "\n");
}

std::string glslVector(const Rgb& colour) { return "vec3(" + colourText(colour) + ")"; }

/// const vec3 NAME[n] = vec3[n](...);
template <typename Element>
std::string glslArray(const ReciprocalLobes& lobes, const std::string& type, const std::string& name, Element element) {
  const std::string sized = "[" + std::to_string(lobes.lobes.size()) + "]";
  std::string text = "const " + type + " " + name + sized + " = " + type + sized + "(";
  for (std::size_t k = 0; k < lobes.lobes.size(); ++k) text += (k > 0 ? ", " : "") + element(lobes.lobes[k]);
  return text + ");\n";
}

ExportResult makeGlsl(const materials::EditedMaterial& source, const ExportOptions& options,
                      const TaskControl& control) {
  auto [made, lobes] = makeLobesExport(glslLobeCounts, reciprocalLobesBrdf, source, options, control);
  made.parts.push_back(textPart(glslSuffix, glslFunction(lobes, originText(source, made.snr))));
  return std::move(made);
}

}  // namespace

std::string glslFunction(const ReciprocalLobes& fitted, const std::string& origin) {
  using Lobe = ReciprocalLobes::Lobe;
  ReciprocalLobes lobes = fitted;
  // An array has one element at least.
  if (lobes.lobes.empty()) lobes.lobes.push_back({});
  return glslComment(origin) + (glslUsage + 1) + "const vec3 gonioDiffuse = " + glslVector(lobes.diffuse) +
         ";\nconst vec2 gonioGrain = vec2(" + sixDigitText(std::cos(lobes.rotation)) + ", " +
         sixDigitText(std::sin(lobes.rotation)) + ");  // x axis of the lobes (brushing direction)\n" +
         "const int gonioLobeCount = " + std::to_string(lobes.lobes.size()) + ";\n" +
         glslArray(lobes, "vec2", "gonioAlpha",
                   [](const Lobe& lobe) {
                     return "vec2(" + sixDigitText(lobe.alpha.x) + ", " + sixDigitText(lobe.alpha.y) + ")";
                   }) +
         glslArray(lobes, "vec3", "gonioF0", [](const Lobe& lobe) { return glslVector(lobe.normal); }) +
         glslArray(lobes, "vec3", "gonioF82", [](const Lobe& lobe) { return glslVector(lobe.tint82); }) +
         glslArray(lobes, "vec3", "gonioF90", [](const Lobe& lobe) { return glslVector(lobe.edge); }) + glslBody;
}

ExportTarget glslTarget() {
  return {.id = "glsl",
          .label = "GLSL function",
          .icon = "target-braces",
          .purpose = "Runs in your own real-time shader.",
          .description = "A self-contained function gonioBrdf(wi, wo) for your own shaders, GLSL 3.30 or GLSL ES 3.00.",
          .limitations =
              "An approximation by a diffuse lobe and up to six GGX lobes; isotropic, or anisotropic with one fixed "
              "brushing direction; reciprocal. Single scattering.",
          .suffixes = {glslSuffix},
          .usesSnr = true,
          .make = makeGlsl};
}

}  // namespace gonio::exports
