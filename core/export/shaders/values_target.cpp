// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/export/export_files.h"
#include "core/export/shaders/shading_formulas.h"
#include "core/export/shaders/shading_models.h"
#include "core/export/target_table.h"
#include "core/io/csv_text.h"
#include "core/math/colour.h"

namespace gonio::exports {

namespace {

constexpr SurfaceLimit unrealLimits[] = {
    {SurfaceField::baseColour, 0, 1},
    {SurfaceField::metalness, 0, 1},
    {SurfaceField::roughness, 0.03, 1},
    {SurfaceField::specular, 0, 1},
};
constexpr SurfaceLimit unityLimits[] = {
    {SurfaceField::baseColour, 0, 1},
    {SurfaceField::metalness, 0, 1},
    {SurfaceField::roughness, 0.03, 1},
};

struct UnrealFormula {
  SurfaceValues v;

  Rgb operator()(const models::SurfaceGeometry& g) const {
    const double alpha = v.roughness * v.roughness, s = schlickWeight(g.cosD);
    const auto widened = [alpha](double cosine) { return cosine * (1 - alpha) + alpha; };
    const double visibility = 0.5 / (g.cosI * widened(g.cosO) + g.cosO * widened(g.cosI));
    const Rgb f0 = glm::mix(Rgb(0.08 * v.specular), v.baseColour, v.metalness);
    // Below 2 % nothing is a real surface: the edge fades too.
    const Rgb fresnel = glm::mix(f0, Rgb(std::min(1.0, 50 * f0.y)), s);
    return (1 - v.metalness) * v.baseColour / pi + ggxDensity(g.h, alpha, alpha) * visibility * fresnel;
  }
};

struct UnityFormula {
  SurfaceValues v;

  Rgb operator()(const models::SurfaceGeometry& g) const {
    constexpr double dielectricF0 = 0.04, renormalised = 1 / 1.03571;
    const double grazing = 0.5 + 2 * v.roughness * g.cosD * g.cosD;
    const auto scattered = [grazing](double cosine) { return glm::mix(1.0, grazing, schlickWeight(cosine)); };
    const double diffuse = renormalised * scattered(g.cosI) * scattered(g.cosO) / pi;
    const Rgb f0 = glm::mix(Rgb(dielectricF0), v.baseColour, v.metalness);
    return (1 - v.metalness) * diffuse * v.baseColour +
           correlatedGgx(g, GgxAlpha(v.roughness * v.roughness)) * glm::mix(f0, Rgb(1), schlickWeight(g.cosD));
  }
};

constexpr std::string_view valuesSuffix = "_values.csv";

/// "#c08040": what colour pickers take.
std::string srgbText(const Rgb& colour) {
  const auto encoded = [](double linear) { return int(std::lround(255 * toSrgb(std::clamp(linear, 0.0, 1.0)))); };
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", encoded(colour.x), encoded(colour.y), encoded(colour.z));
  return text;
}

/// Writes the rows of one program: program,input,value,srgb.
class ValueRows {
 public:
  ValueRows(io::CsvWriter& csv, std::string_view program) : csv_(csv), program_(program) {}
  ValueRows& colour(std::string_view input, const Rgb& colour) {
    return add(input, colourText(colour, " "), srgbText(colour));
  }
  ValueRows& number(std::string_view input, double number) { return add(input, sixDigitText(number), ""); }

 private:
  ValueRows& add(std::string_view input, std::string_view value, std::string_view srgb) {
    csv_.texts({program_, input}).literal(value).literal(srgb).endLine();
    return *this;
  }

  io::CsvWriter& csv_;
  std::string_view program_;
};

void unrealRows(io::CsvWriter& csv, const SurfaceValues& v) {
  ValueRows(csv, "Unreal Engine (Default Lit)")
      .colour("Base Color", v.baseColour)
      .number("Metallic", v.metalness)
      .number("Specular", v.specular)
      .number("Roughness", v.roughness);
}

void unityRows(io::CsvWriter& csv, const SurfaceValues& v) {
  ValueRows(csv, "Unity (HDRP Lit)")
      .colour("Base Map", v.baseColour)
      .number("Metallic", v.metalness)
      .number("Smoothness", 1 - v.roughness);
}

void arnoldRows(io::CsvWriter& csv, const SurfaceValues& v) {
  ValueRows(csv, "Arnold (standard_surface)")
      .number("base", 1)
      .colour("base_color", v.baseColour)
      .number("metalness", v.metalness)
      .number("specular", 1)
      .colour("specular_color", v.specularColour)
      .number("specular_roughness", v.roughness)
      .number("specular_IOR", v.ior)
      .number("specular_anisotropy", v.anisotropy)
      .number("specular_rotation", v.rotation / (2 * pi))
      .number("coat", v.coat)
      .number("coat_roughness", v.coatRoughness)
      .number("coat_IOR", 1.5);
}

struct ValuesProgram {
  std::string_view key, label;  ///< of its SNR
  const SurfaceShader& (*shader)();
  void (*rows)(io::CsvWriter&, const SurfaceValues&);
};

constexpr ValuesProgram programs[] = {
    {"snrUnreal", "Rendered SNR in Unreal Engine", unrealShader, unrealRows},
    {"snrUnity", "Rendered SNR in Unity", unityShader, unityRows},
    {"snrArnold", "Rendered SNR in Arnold", standardSurfaceShader, arnoldRows},
};

ExportResult makeValues(const materials::EditedMaterial& source, const ExportOptions& options,
                        const TaskControl& control) {
  const rendering::RenderedComparison comparison = materials::comparisonOf(source, options, control.between(0, 0.1));
  ExportResult worst;
  std::vector<ExportFact> facts;
  std::vector<SurfaceValues> fitted;
  for (std::size_t i = 0; i < std::size(programs); ++i) {
    const TaskControl part = control.between(0.1 + 0.3 * double(i), 0.4 + 0.3 * double(i));
    const SurfaceShader& shader = programs[i].shader();
    const SurfaceValues values = writtenValues(fitSurface(shader, *source.shown.brdf, part.between(0, 0.8)));
    ExportResult made;
    measureExport(made, shader.brdf(values), comparison, part.between(0.8, 1));
    facts.push_back({programs[i].key, programs[i].label, made.snr});
    fitted.push_back(values);
    if (!worst.brdf || made.snr < worst.snr) worst = std::move(made);
  }
  worst.facts = std::move(facts);
  if (!source.shown.brdf->isIsotropic())
    worst.warnings.push_back(
        "the material is anisotropic: the values for Unreal and Unity are means over all azimuths");
  io::CsvWriter csv;
  csv.comment(originText(source, worst.snr));
  csv.texts({"program", "input", "value", "srgb"}).endLine();
  for (std::size_t i = 0; i < std::size(programs); ++i) programs[i].rows(csv, fitted[i]);
  worst.parts.push_back(textPart(valuesSuffix, csv.str()));
  return worst;
}

}  // namespace

const SurfaceShader& unrealShader() {
  static const SurfaceShader shader{
      unrealLimits, {.specular = 0.5}, [](const SurfaceValues& v) { return makeFormulaBrdf(UnrealFormula{v}); }};
  return shader;
}

const SurfaceShader& unityShader() {
  static const SurfaceShader shader{
      unityLimits, {}, [](const SurfaceValues& v) { return makeFormulaBrdf(UnityFormula{v}); }};
  return shader;
}

ExportTarget valuesTarget() {
  return {.id = "values",
          .label = "Shader inputs (Unreal, Unity, Arnold)",
          .icon = "target-list",
          .purpose = "Lists the numbers to type into a material of Unreal Engine, Unity or Arnold.",
          .description =
              "A table (.csv) of the inputs of Unreal's Default Lit, Unity's HDRP Lit and Arnold's standard_surface "
              "by the names that these programs give them; colours in linear sRGB and as hexadecimal sRGB.",
          .limitations =
              "An approximation by a diffuse lobe and one highlight, and for Arnold also a coat. The stated accuracy "
              "is the lowest of the three.",
          .suffixes = {valuesSuffix},
          .make = makeValues};
}

}  // namespace gonio::exports
