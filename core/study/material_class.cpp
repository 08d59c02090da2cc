// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/material_class.h"

#include <algorithm>
#include <limits>

#include "core/documents/open_material.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::study {

MaterialClass materialClassNamed(std::string_view name) {
  const auto found = std::ranges::find(materialClassNames, name);
  if (found == materialClassNames.end())
    throw Error("class of materials: found '" + std::string(name) + "', expected all, diffuse or glossy");
  return MaterialClass(found - materialClassNames.begin());
}

double highlightContrast(const Brdf& material) {
  double largest = 0;
  for (const double angle : {15.0, 30.0, 45.0}) {
    const Direction light = fromSpherical(radians(angle), 0);
    const double mirror = luminance(material.evaluate(light, fromSpherical(radians(angle), pi)));
    const double beside = luminance(material.evaluate(light, fromSpherical(radians(angle), halfPi)));
    if (!(mirror > 0)) continue;
    largest = std::max(largest, beside > 0 ? mirror / beside : std::numeric_limits<double>::infinity());
  }
  return largest;
}

std::vector<std::string> filesOfClass(const std::vector<std::string>& files, MaterialClass materialClass,
                                      const TaskControl& control) {
  if (materialClass == MaterialClass::all) return files;
  std::vector<char> isGlossy(files.size());
  parallelForBlocks(
      files.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          isGlossy[i] = highlightContrast(*documents::openMaterial(files[i]).brdf) >= glossyContrast;
      },
      control);
  std::vector<std::string> result;
  for (std::size_t i = 0; i < files.size(); ++i)
    if ((isGlossy[i] != 0) == (materialClass == MaterialClass::glossy)) result.push_back(files[i]);
  if (result.empty())
    throw Error("no material of the training set is " + std::string(materialClassNames[std::size_t(materialClass)]));
  return result;
}

}  // namespace gonio::study
