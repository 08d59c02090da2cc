// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/reproduction/picture_rows.h"

#include <algorithm>

#include "core/rendering/error_maps.h"
#include "core/support/text.h"

namespace gonio::reproduction {

std::vector<double> PictureRows::add(const std::string& label, const Brdf& reference,
                                     std::span<const ComparedBrdf> compared, const TaskControl& control) {
  const rendering::RenderedComparison comparison(reference, picture_, {control.stop, {}});
  std::vector<Image> pictures;
  std::vector<double> ratios;
  PictureRow shown{label, {{shownPicture(comparison.reference()), {}}}};
  for (const ComparedBrdf& one : compared) {
    const rendering::ComparisonPicture picture = comparison.render(*one.brdf, {control.stop, {}});
    ratios.push_back(comparison.signalToNoiseRatio(picture));
    pictures.push_back(picture.image);
    shown.cells.push_back({shownPicture(picture.image), {"SNR " + shortText(ratios.back()) + " dB"}});
    if (rows_.empty()) columns_.push_back(one.label);
    materials_.push_back(label);
    representations_.push_back(one.label);
    ratios_.push_back(ratios.back());
  }
  const double range = rendering::errorRange(comparison.reference(), pictures);
  PictureRow errors{"difference", {{{}, {"luminance from 0 (dark) to " + shortText(range, 3)}}}};
  for (const Image& picture : pictures) errors.cells.push_back({errorPicture(comparison.reference(), picture, range)});
  rows_.push_back(std::move(shown));
  rows_.push_back(std::move(errors));
  return ratios;
}

figures::FigureDrawing PictureRows::draw(const std::string& title) const {
  return drawPictures(title, columns_, rows_,
                      "Sphere in the studio environment, " + std::to_string(picture_.width) + " x " +
                          std::to_string(picture_.height) + " pixels, " + std::to_string(picture_.samples) +
                          " samples per pixel. SNR: rendered SNR of the linear picture against the reference.");
}

io::CsvTable PictureRows::table() const {
  return {{}, {{"material", {}, materials_}, {"representation", {}, representations_}, {"rendered SNR [dB]", ratios_}}};
}

}  // namespace gonio::reproduction
