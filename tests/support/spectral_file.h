// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/io/tensor_file.h"
#include "core/math/types.h"

/// A spectral RGL file of closed forms.
namespace gonio::test::spectral {

using io::TensorField;

constexpr std::size_t side = 4, plane = side * side, slices = 3, wavelengths = 41;

/// Green paint with a narrow line at 610 nm: nothing that a smooth basis could hold.
inline double spectrum(double nanometres, double amount) {
  const auto bell = [&](double centre, double width) {
    return std::exp(-0.5 * std::pow((nanometres - centre) / width, 2));
  };
  return amount * (0.05 + 0.8 * bell(540, 35)) + (1 - amount) * bell(610, 8);
}

/// A spectral file of closed forms, every 10 nm: each node another mixture; one node black, one without anything below
/// 500 nm.
inline std::vector<std::byte> spectralFile() {
  std::vector<float> nanometres, spectra;
  for (std::size_t w = 0; w < wavelengths; ++w) nanometres.push_back(380 + 10 * float(w));
  for (std::size_t slice = 0; slice < slices; ++slice)
    for (const float at : nanometres)
      for (std::size_t node = 0; node < plane; ++node)
        spectra.push_back(node == 3               ? 0
                          : node == 5 && at < 500 ? 0
                                                  : float(spectrum(at, double(node) / plane) * (1 + double(slice))));
  const char jacobian = 1;
  std::vector<float> ndf(4, 2), sigma(4, 0.5f);
  return io::encodeTensorFile(std::vector<TensorField>{
      TensorField::text("description", "made by a test"), TensorField::floats("phi_i", {1}, std::vector<float>{0}),
      TensorField::floats("theta_i", {slices}, std::vector<float>{0, 0.6f, float(halfPi)}),
      TensorField::floats("sigma", {2, 2}, sigma), TensorField::floats("ndf", {2, 2}, ndf),
      TensorField::floats("vndf", {1, slices, 3, 3}, std::vector<float>(slices * 9, 1)),
      TensorField::floats("luminance", {1, slices, 2, 2}, std::vector<float>(slices * 4, 1)),
      TensorField::floats("spectra", {1, slices, wavelengths, side, side}, spectra),
      TensorField::floats("wavelengths", {wavelengths}, nanometres), TensorField::text("jacobian", {&jacobian, 1})});
}

}  // namespace gonio::test::spectral
