// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/slices_target.h"

#include <limits>

#include "core/io/exr_codec.h"
#include "core/plots/slice.h"

namespace gonio::exports {

namespace {

constexpr std::string_view slicesSuffix = "_slices.exr";
constexpr int slicesSide = 180;
/// Degrees. A reciprocal material that is the same on both sides of the plane of incidence has no others.
constexpr int slicesPhiD[] = {0, 30, 60, 90};

ExportResult makeSlices(const materials::EditedMaterial& source, const ExportOptions&, const TaskControl& control) {
  Image image(int(std::size(slicesPhiD)) * slicesSide, slicesSide);
  std::string azimuths;
  for (std::size_t i = 0; i < std::size(slicesPhiD); ++i) {
    control.throwIfStopped();
    const plots::Slice slice =
        plots::halfDifferenceSlice(*source.shown.brdf, radians(slicesPhiD[i]), plots::ThetaHSpacing::squareRoot,
                                   plots::CosineFactor::none, nullptr, slicesSide);
    for (int row = 0; row < slicesSide; ++row)
      for (int column = 0; column < slicesSide; ++column)
        image.at(int(i) * slicesSide + column, slicesSide - 1 - row) =
            glm::vec3(slice.cells.values[slice.index(column, row)]);
    azimuths += (i ? ", " : "") + std::to_string(slicesPhiD[i]);
  }
  ExportResult made;
  made.snr = std::numeric_limits<double>::infinity();
  made.brdf = source.shown.brdf;
  made.parts.push_back(
      {std::string(slicesSuffix),
       io::encodeExr(image, {{"comments", materials::originOf(source)},
                             {"slices", "from left to right: phi_d = " + azimuths +
                                            " degrees; along x: theta_h = 90 u^2 degrees, u from 0 to 1; along y: "
                                            "theta_d from 0 at the bottom to 90 degrees at the top; linear sRGB, 1/sr "
                                            "without the cosine; 0 where a direction is below the surface"}})});
  return made;
}

}  // namespace

ExportTarget slicesTarget() {
  return {.id = "slices",
          .label = "Slices (OpenEXR)",
          .description = "An image of four planes of half-difference space, theta_h by theta_d, for figures.",
          .limitations =
              "Values at phi_d of 0, 30, 60 and 90 degrees; for an anisotropic material with the half vector "
              "tilted towards x, the brushing direction. No renderer reads this file.",
          .suffixes = {slicesSuffix},
          .make = makeSlices};
}

}  // namespace gonio::exports
