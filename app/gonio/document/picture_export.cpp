// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/picture_export.h"

#include <cmath>

#include "core/io/image_io.h"

namespace gonio::app {

namespace {

Rgb linearOf(const QColor& colour) {
  return {fromSrgb(colour.redF()), fromSrgb(colour.greenF()), fromSrgb(colour.blueF())};
}

}  // namespace

Scene PictureExport::shownScene() const {
  Scene shown = scene;
  shown.showEnvironment = background == PictureBackground::environment;
  return shown;
}

PicturePlan planPicture(const PictureExport& request, const std::shared_ptr<const Brdf>& edited) {
  PicturePlan planned{.scene = request.shownScene()};
  const auto material = std::make_shared<const RenderMaterial>(edited);
  planned.materials =
      bindMaterials(planned.scene, materialsInSlots(planned.scene, material, request.otherSlotMaterials));
  planned.plan = planEffects(planned.scene, planned.materials, request.overrides);
  return planned;
}

void writeRenderedPicture(const PictureExport& request, const std::shared_ptr<const Brdf>& edited,
                          const std::string& name, const TaskControl& control, const Pause& pause) {
  constexpr std::uint64_t seed = 1;
  const PicturePlan planned = planPicture(request, edited);
  const PathTracer tracer(planned.scene, planned.materials, planned.plan, seed);
  Film film(request.width, request.height);
  refinePicture(tracer, film, request.limits, control, &pause);
  Image image = film.image();
  const bool overColour = request.background == PictureBackground::colour;
  const std::string path = request.path.toStdString();
  if (request.isExr()) {
    if (overColour) composeOver(request.colour, image);
    return io::writeExr(image, path, pictureAttributes(planned.scene, planned.plan, name, film.samples, seed));
  }
  std::vector<std::uint8_t> bytes = toDisplayBytes(image, request.exposure, request.toneMap);
  if (overColour) composeOver(request.colour, bytes);
  io::writePng(bytes, image.width, image.height, path);
}

void composeOver(const QColor& colour, std::span<std::uint8_t> rgba) {
  const Rgb behind = linearOf(colour);
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const double alpha = rgba[i + 3] / 255.0;
    if (alpha == 1) continue;
    for (int c = 0; c < 3; ++c) {
      std::uint8_t& byte = rgba[i + std::size_t(c)];
      byte = std::uint8_t(std::lround(255 * toSrgb(alpha * fromSrgb(byte / 255.0) + (1 - alpha) * behind[c])));
    }
    rgba[i + 3] = 255;
  }
}

void composeOver(const QColor& colour, Image& image) {
  const Rgb behind = linearOf(colour);
  for (std::size_t i = 0; i < image.alpha.size(); ++i) image.pixels[i] += glm::vec3(behind * (1.0 - image.alpha[i]));
  image.alpha.clear();
}

}  // namespace gonio::app
