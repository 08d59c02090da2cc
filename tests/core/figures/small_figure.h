// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/figures/figure_description.h"
#include "core/figures/figure_measurement.h"

namespace gonio::test {

/// Two bundled materials, two representations that are fast to make.
inline figures::FigureDescription smallFigure() {
  figures::FigureDescription figure;
  figure.materials = {{"library:sgd/chrome", ""}, {"library:sgd/blue-rubber", "blue rubber"}};
  figure.representations = {{study::representationById("ggx"), ""},
                            {study::representationById("factors-3d", 1), "PDV"}};
  figure.pictures.size = 16;
  figure.pictures.samples = 4;
  figure.numbers = {"rendered-snr", "flip", "log", "bytes"};
  return figure;
}

/// Replaces one number of a measured cell.
inline void setValue(std::shared_ptr<const figures::FigureCell>& cell, std::string_view number, double value) {
  auto changed = std::make_shared<figures::FigureCell>(*cell);
  changed->values[std::size_t(&figures::figureNumber(number) - figures::figureNumbers().data())] = value;
  cell = changed;
}

/// A measurement of it without the work: pictures of one colour each, numbers that count.
inline figures::FigureMeasurement madeUpMeasurement(const figures::FigureDescription& figure) {
  const auto picture = [&](float value) {
    Image image(figure.pictures.size, figure.pictures.size);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = glm::vec3(value, 0.001f * float(i), 0.5f);
    return image;
  };
  figures::FigureMeasurement measurement{.pictures = figure.pictures};
  double count = 0;
  for (const figures::FigureMaterial& material : figure.materials) {
    figures::FigureRow& row = measurement.rows.emplace_back();
    row.path = row.name = material.path;
    row.reference = std::make_shared<const Image>(picture(0.25f));
    for (std::size_t i = 0; i < figure.representations.size(); ++i) {
      figures::FigureCell cell{.representation = figure.representations[i].representation,
                               .picture = picture(0.3f + 0.1f * float(i))};
      for (std::size_t k = 0; k < figures::figureNumbers().size(); ++k) cell.values.push_back(count += 1.25);
      row.cells.push_back(std::make_shared<const figures::FigureCell>(cell));
    }
  }
  return measurement;
}

}  // namespace gonio::test
