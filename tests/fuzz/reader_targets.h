// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "core/acquisition/factor_plan.h"
#include "core/acquisition/factor_prediction.h"
#include "core/acquisition/measured_values.h"
#include "core/acquisition/sampling_plan.h"
#include "core/brdf/rgl_brdf.h"
#include "core/documents/edit_document.h"
#include "core/figures/figure_description.h"
#include "core/formats/code.h"
#include "core/formats/neural.h"
#include "core/formats/pdv.h"
#include "core/formats/scattered_samples.h"
#include "core/geometry/mesh_intersector.h"
#include "core/io/image_io.h"
#include "core/io/json_text.h"
#include "core/io/mesh_file.h"
#include "core/materials/basis_file.h"
#include "core/materials/material.h"
#include "core/materials/npf_file.h"
#include "core/rendering/effect_plan.h"
#include "core/rendering/environment.h"
#include "core/rendering/scene_file.h"

/// What is done with bytes that nobody vouches for. Each reads and uses the result; every outcome but a result that
/// keeps its promises and a gonio::Error is a bug. Shared by the mutation test and the libFuzzer programs.
namespace gonio::fuzz {

/// @throws std::logic_error where a value is not finite, or negative (which those of RGL files may be).
inline void checkValues(const Brdf& brdf) {
  for (const double thetaI : {0.0, 0.3, 1.2, 1.57})
    for (const double phi : {0.0, 1.0, 3.0, -2.0}) {
      const Rgb value = brdf.evaluate(fromSpherical(thetaI, 0.5), fromSpherical(0.9, phi));
      for (int channel = 0; channel < 3; ++channel)
        if (!std::isfinite(value[channel]) || (value[channel] < 0 && !formOf<RglBrdf>(brdf)))
          throw std::logic_error("a value that is no BRDF's");
    }
}

/// @throws std::logic_error where a promise is broken; Error where the bytes are refused.
inline void readMaterialBytes(std::span<const std::byte> bytes) {
  const materials::Material material = materials::readMaterial(io::MemorySource(bytes));
  checkValues(*material.brdf);
  if (material.table && material.table->values().size() != material.table->grid().size())
    throw std::logic_error("a table of another size than its grid");
}

/// What was read holds a finite value, 0 or more, for each pair of directions above the horizon. The material of it is
/// not made: that takes longer than all the rest.
template <formats::ScatteredSamples (*read)(const io::ByteSource& source)>
void readScatteredBytes(std::span<const std::byte> bytes) {
  const formats::ScatteredSamples samples = read(io::MemorySource(bytes));
  if (samples.values.size() != samples.directions.size()) throw std::logic_error("not one value per pair");
  for (std::size_t i = 0; i < samples.values.size(); ++i) {
    const auto& [wi, wo] = samples.directions[i];
    if (!(wi.z > 0) || !(wo.z > 0)) throw std::logic_error("a direction below the horizon");
    for (int channel = 0; channel < 3; ++channel)
      if (const double value = samples.values[i][channel]; !std::isfinite(value) || value < 0)
        throw std::logic_error("a value that is no BRDF's");
  }
  if (auto table = formats::gridOf(samples)) checkValues(IncidenceTableBrdf(std::move(*table)));
}

inline void readPdvBytes(std::span<const std::byte> bytes) {
  checkValues(*factorization::makePdvBrdf(formats::readPdv(io::MemorySource(bytes))));
}

inline void readNeuralBytes(std::span<const std::byte> bytes) {
  checkValues(formats::readNeural(io::MemorySource(bytes)));
}

/// The names of the rows end at the first byte 0.
inline void readNpfBytes(std::span<const std::byte> bytes) {
  const auto end = std::find(bytes.begin(), bytes.end(), std::byte(0));
  const std::string_view names(reinterpret_cast<const char*>(bytes.data()), std::size_t(end - bytes.begin()));
  const auto table = bytes.subspan(std::min(names.size() + 1, bytes.size()));
  for (const auto& [name, factors] : materials::readNpf(io::MemorySource(table), names).materials)
    checkValues(*factorization::makeNonparametricBrdf(factors));
}

/// What was read predicts a material, if the readings lie on two curves, and is the same when it is written and read
/// again, to the six decimals of the angles.
inline void readFactorReadingsBytes(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const auto axes : {acquisition::FactorAxes::symmetricDeviation, acquisition::FactorAxes::halfOut}) {
    const acquisition::FactorReadings readings = acquisition::parseFactorReadings(text, axes);
    const auto again =
        acquisition::parseFactorReadings(acquisition::factorReadingsCsv(readings.plan, readings.values), axes);
    if (again.values.rgb != readings.values.rgb || again.plan.curves != readings.plan.curves)
      throw std::logic_error("readings that are lost in their file");
    const acquisition::FactorMeasurement curves = acquisition::factorMeasurement(readings.plan, readings.values);
    for (const acquisition::FactorBound bound : {acquisition::FactorBound::readings, acquisition::FactorBound::none})
      checkValues(*acquisition::predictFromFactors(curves, bound));
    acquisition::supportOf(curves, 30);
  }
}

/// What was read packs and unpacks again.
inline void readCodeBytes(std::span<const std::byte> bytes) {
  const formats::CodeFile file = formats::readCode(io::MemorySource(bytes));
  const auto again =
      formats::readCode(io::MemorySource(formats::encodeCode(file.code, file.dictionaryId, file.precision)));
  if (again.code.coefficients() != file.code.coefficients()) throw std::logic_error("a code that is lost in its file");
}

inline void readDictionaryBytes(std::span<const std::byte> bytes) {
  const auto dictionary = materials::readDictionary(io::MemorySource(bytes));
  if (!(dictionary::orthonormalityError(dictionary->ensemble) < 1e-10))
    throw std::logic_error("a dictionary that is not orthonormal");
}

inline std::string_view textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// What was read stands above the horizon and is the same when it is written and read again, to its six decimals.
inline void readPlanBytes(std::span<const std::byte> bytes) {
  const acquisition::SamplingPlan plan = acquisition::parsePlan(textOf(bytes));
  const acquisition::SamplingPlan again = acquisition::parsePlan(acquisition::planCsv(plan));
  for (std::size_t i = 0; i < plan.samples.size(); ++i) {
    const DirectionPair &pair = plan.samples[i].directions, &other = again.samples[i].directions;
    if (isBelowHorizon(pair.wi) || isBelowHorizon(pair.wo)) throw std::logic_error("a direction below the horizon");
    if (!(acquisition::armTravel(pair, other) < 1e-6)) throw std::logic_error("a direction that is lost in its file");
  }
}

/// Of a plan with the indices 1 to 3.
inline void readValuesBytes(std::span<const std::byte> bytes) {
  acquisition::SamplingPlan plan;
  for (const int index : {1, 2, 3}) plan.samples.push_back({index, {}, index});
  const acquisition::MeasuredValues values = acquisition::parseValues(textOf(bytes), plan);
  if (values.rgb.size() != 3 || (!values.noise.empty() && values.noise.size() != 3))
    throw std::logic_error("not one value per sample");
  for (const auto* list : {&values.rgb, &values.noise})
    for (const Rgb& value : *list)
      for (int channel = 0; channel < 3; ++channel)
        if (!std::isfinite(value[channel]) || value[channel] < 0) throw std::logic_error("a value that is none");
}

/// What was read decodes.
inline void readBasisBytes(std::span<const std::byte> bytes) {
  const auto basis = materials::readBasis(io::MemorySource(bytes));
  dictionary::ComponentCode code;
  for (Eigen::VectorXf& channel : code.channels) channel.setOnes(basis->components.count());
  checkValues(*dictionary::decode(basis->components, code));
}

/// What was read has unit normals, and rays meet it.
inline void checkMesh(geometry::TriangleMesh read) {
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(std::move(read));
  for (const glm::vec3& normal : mesh->cornerNormals())
    if (!(std::abs(glm::length(normal) - 1) < 1e-5f)) throw std::logic_error("a normal that is no direction");
  const geometry::MeshIntersector intersector(mesh);
  const glm::dvec3 first(mesh->positions()[mesh->triangles()[0][0]]);
  const glm::dvec3 eye = mesh->boundingSphere().centre + 3 * mesh->boundingSphere().radius * glm::dvec3(0.6, 0, 0.8);
  if (const auto hit = intersector.closest(eye, first - eye, 0, 2); hit && !std::isfinite(glm::length(hit->position)))
    throw std::logic_error("a hit that is nowhere");
}

inline void readObjBytes(std::span<const std::byte> bytes) { checkMesh(io::readObj(io::MemorySource(bytes)).mesh); }

inline void readPlyBytes(std::span<const std::byte> bytes) { checkMesh(io::readPly(io::MemorySource(bytes)).mesh); }

inline void readStlBytes(std::span<const std::byte> bytes) { checkMesh(io::readStl(io::MemorySource(bytes)).mesh); }

inline void readGlbBytes(std::span<const std::byte> bytes) { checkMesh(io::readGltf(io::MemorySource(bytes)).mesh); }

/// What was read lights a scene, if its values are finite.
inline void readImageBytes(std::span<const std::byte> bytes) {
  Image image = io::readImage(bytes);
  const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  if (count == 0 || image.pixels.size() != count || (!image.alpha.empty() && image.alpha.size() != count))
    throw std::logic_error("a picture of another size than it says");
  if (constexpr std::size_t most = 4096; count > most) return;  // the density of a large map takes longer than all else
  const rendering::EnvironmentMap map(std::move(image), "map");
  const rendering::EnvironmentMap::Sample sample = map.sample(0.3, 0.7);
  if (!(std::abs(glm::length(sample.direction) - 1) < 1e-6) || !(sample.pdf > 0) || !std::isfinite(sample.pdf) ||
      !(luminance(sample.radiance) >= 0))
    throw std::logic_error("light from nowhere");
}

/// What PNG and JPEG files store lies between 0 and 1.
inline void readEncodedImageBytes(std::span<const std::byte> bytes) {
  const Image image = io::readEncodedImage(bytes);
  const auto isStored = [](const glm::vec3& pixel) {
    return glm::all(glm::greaterThanEqual(pixel, glm::vec3(0))) && glm::all(glm::lessThanEqual(pixel, glm::vec3(1)));
  };
  if (image.pixels.size() != std::size_t(image.width) * std::size_t(image.height) ||
      !std::ranges::all_of(image.pixels, isStored))
    throw std::logic_error("a picture with values that no file stores");
}

inline void readDocumentBytes(std::span<const std::byte> bytes) {
  const auto document = documents::documentFromText(std::string(textOf(bytes)));
  for (const editing::Edit& edit : document.edits) {
    if (const auto* differential = std::get_if<editing::DifferentialEdit>(&edit.content))
      differential->model->instantiate(differential->edited);
    else
      factorization::makePdvBrdf(*std::get<editing::FactorEdit>(edit.content).edited);
  }
  documents::toJson(document).dump();
}

/// What was read can be planned. Files that the text names are not opened.
inline void readSceneBytes(std::span<const std::byte> bytes) {
  const rendering::Scene scene = rendering::parseScene(std::string(textOf(bytes)), 2);
  const std::vector<std::shared_ptr<const rendering::RenderMaterial>> grey(2, rendering::diffuseMaterial(Rgb(0.5)));
  const rendering::EffectPlan plan = rendering::planEffects(scene, rendering::bindMaterials(scene, grey));
  if (plan.reflections < 0 || !(plan.remainder >= 0) || !(scene.camera.distance > 0))
    throw std::logic_error("a scene without a plan");
  for (const rendering::SceneObject& object : scene.objects)
    if (const rendering::Sphere bound = rendering::boundingSphere(object.shape);
        !(bound.radius > 0) || !std::isfinite(glm::length(bound.centre)))
      throw std::logic_error("a shape without a place");
}

/// What was read is written as it is.
inline void readFigureBytes(std::span<const std::byte> bytes) {
  const figures::FigureDescription figure = figures::figureFromJson(io::parseJson(textOf(bytes)));
  if (figures::figureFromJson(io::parseJson(figures::toJson(figure).dump())) != figure)
    throw std::logic_error("a description that is another one when it is written");
}

}  // namespace gonio::fuzz
