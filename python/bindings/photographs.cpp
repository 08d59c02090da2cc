// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <pybind11/stl.h>

#include "core/io/byte_source.h"
#include "core/photograph/photograph_candidates.h"
#include "core/photograph/photograph_fit.h"
#include "core/photograph/photograph_plan.h"
#include "core/study/training_files.h"
#include "python/bindings/materials.h"
#include "python/bindings/representations.h"

namespace gonio::python {

namespace {

using namespace photograph;

using FloatImage = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// The text of a file, which errors name.
py::str descriptionText(const std::string& path) {
  return withFileInErrors(path, [&] {
    const auto bytes = io::FileSource(path).readAll(maxDescriptionBytes);
    return toText({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  });
}

GivenImages givenImages(const std::vector<std::pair<std::string, FloatImage>>& arrays) {
  GivenImages images;
  for (const auto& [name, array] : arrays) {
    if (array.ndim() != 3 || array.shape(2) != 3 || array.size() == 0)
      throw Error(name + ": found an array of another shape, expected (height, width, 3)");
    Image image(int(array.shape(1)), int(array.shape(0)));
    std::copy_n(array.data(), array.size(), &image.pixels[0].x);
    images.emplace(name, std::move(image));
  }
  return images;
}

/// (n_h, n_d, n_phi, 3); NaN in cells that the basis does not cover.
py::array_t<float> deviationsOnGrid(const dictionary::MappedCells& mapping, const std::vector<glm::vec3>& deviations) {
  const HalfDifferenceGrid& grid = mapping.grid;
  py::array_t<float> array({grid.thetaHCount, grid.thetaDCount, grid.phiDCount, 3});
  std::fill_n(array.mutable_data(), array.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < deviations.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      array.mutable_data()[3 * std::size_t(mapping.cells[i]) + std::size_t(channel)] = deviations[i][channel];
  return array;
}

py::dict fromImages(const std::string& text, const std::string& folder,
                    const std::vector<std::pair<std::string, FloatImage>>& arrays, const PyBasis& basis, int components,
                    std::size_t regions, const std::string& name, const py::object& progress) {
  const GivenImages given = givenImages(arrays);
  const dictionary::PrincipalComponents& known = *basis.ofMaterials();
  struct Found {
    PhotographSet set;
    PhotographFit fit;
    std::shared_ptr<const TabulatedBrdf> table;
    std::vector<glm::vec3> deviations;
  };
  const Found found = resultOf(progress, [&](const TaskControl& control) {
    Found result{.set = parseDescription(text, folder, true, given).set, .fit = {}, .table = {}, .deviations = {}};
    result.fit = fitPhotographs(photographPrior(known, components), result.set, regions, control.between(0, 0.9));
    result.table = dictionary::decode(known, result.fit.code, {control.stop, {}});
    result.deviations = deviations(known, result.fit, control.between(0.9, 1));
    return result;
  });
  py::list outlines, checks;
  for (const Photograph& photograph : found.set.photographs) {
    const matching::Disc& disc = photograph.disc;
    if (isSphere(photograph.surface))
      outlines.append(py::make_tuple(disc.x, disc.y, disc.radius));
    else
      outlines.append(py::none());
  }
  for (const InputCheck& check : found.fit.checks)
    checks.append(py::make_tuple(check.property, check.estimate, check.deviation, check.evidence, check.unexplainedSnr,
                                 check.isSuspicious));
  py::dict row;
  row["material"] = newMaterial(name, "photograph", found.table);
  row["exposure"] = found.fit.exposure;
  row["exposure_deviation"] = found.fit.exposureDeviation;
  row["grey_exposure"] = py::make_tuple(found.set.exposure.x, found.set.exposure.y, found.set.exposure.z);
  row["outlines"] = outlines;
  row["residual_snr"] = found.fit.residualSnr;
  row["bandwidth"] = found.fit.bandwidth;
  row["model_noise"] = found.fit.modelNoise;
  row["lost_light"] = found.fit.lost;
  row["deviation"] = deviationsOnGrid(known.mapping, found.deviations);
  row["checks"] = checks;
  row["warnings"] = toTexts(found.fit.warnings);
  return row;
}

py::dict deviationDict(const ExpectedDeviation& of) {
  py::dict row;
  row["all"] = of.overall;
  for (std::size_t c = 0; c < of.classes.size(); ++c)
    row[py::str(std::string(study::materialClassNames[c + 1]))] = of.classes[c];
  return row;
}

py::dict planImages(const std::string& text, const std::string& folder, int images, const std::array<int, 3>& counts,
                    const PyBasis& basis, int components, double modelNoise, std::size_t materials,
                    const py::object& progress) {
  const std::string with = withCandidates(text, {.rotations = counts[0], .lights = counts[1], .cameras = counts[2]});
  const PhotographDescription description = parseDescription(with, folder, false);
  const PhotographPlan plan = resultOf(progress, [&](const TaskControl& control) {
    const PhotographPrior prior = photographPrior(*basis.ofMaterials(), components);
    return planPhotographs(prior, description.set, description.candidates, study::photographClasses(prior),
                           study::photographClassCount,
                           {.images = images, .materials = materials, .modelNoise = modelNoise}, control);
  });
  py::list chosen, taken, candidates;
  for (std::size_t i = 0; i < plan.taken.size(); ++i)
    taken.append(py::make_tuple(toText(description.set.photographs[i].name), deviationDict(plan.taken[i])));
  for (std::size_t i = 0; i < plan.chosen.size(); ++i) {
    const py::str file = toText(description.candidates[plan.chosen[i]].name);
    chosen.append(file);
    taken.append(py::make_tuple(file, deviationDict(plan.after[i])));
  }
  for (std::size_t i = 0; i < plan.candidates.size(); ++i)
    candidates.append(py::make_tuple(toText(description.candidates[i].name), deviationDict(plan.candidates[i])));
  py::dict row;
  row["chosen"] = chosen;
  row["description"] = withChosenCandidates(with, plan.chosen);
  row["before"] = deviationDict(plan.before);
  row["images"] = taken;
  row["candidates"] = candidates;
  return row;
}

}  // namespace

void bindPhotographs(py::module_& module) {
  module.def("read_description", descriptionText);
  module.def("from_images", fromImages);
  module.def("plan_images", planImages);
}

}  // namespace gonio::python
