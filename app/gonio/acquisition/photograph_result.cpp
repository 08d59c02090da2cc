// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/photograph_result.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gonio/library/thumbnail.h"
#include "app/gonio/scene/scene_panel.h"
#include "core/rendering/error_maps.h"
#include "widgets/acquisition/residual_view.h"
#include "widgets/preview/gl/preview_comparison.h"

namespace gonio::app {

namespace {

struct PhotographResultText {
  Q_DECLARE_TR_FUNCTIONS(PhotographResult)
};

constexpr int mapSide = 200;

/// The map of one photograph: each pixel has the colour of the nearest region, if it is as near as its square reaches.
QImage residualMap(const photograph::PhotographFit& fit, const std::vector<double>& residuals, std::size_t photograph,
                   const PhotographItem& item, double range) {
  const matching::Disc disc = item.disc();
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < fit.regions.size(); ++i)
    if (fit.regions[i].photograph == photograph) own.push_back(i);
  // The squares have equal sides: the smallest distance of two centres in one row.
  double side = disc.radius;
  for (std::size_t n = 1; n < own.size(); ++n) {
    const glm::dvec2 step = fit.regions[own[n]].centre - fit.regions[own[n - 1]].centre;
    if (std::abs(step.y) < 0.01 && step.x > 0) side = std::min(side, step.x);
  }
  QImage map(mapSide, mapSide, QImage::Format_ARGB32_Premultiplied);
  map.fill(Qt::transparent);
  for (int y = 0; y < mapSide; ++y)
    for (int x = 0; x < mapSide; ++x) {
      const glm::dvec2 place =
          (glm::dvec2(x + 0.5, y + 0.5) * (2.0 / mapSide) - 1.0) * (widgets::ResidualView::mapExtent * disc.radius);
      if (item.hasOutline() && glm::length(place) > disc.radius) continue;
      const glm::dvec2 pixel = place + glm::dvec2(disc.x, disc.y);
      std::size_t nearest = own.front();
      double least = std::numeric_limits<double>::infinity();
      for (const std::size_t i : own) {
        const glm::dvec2 offset = glm::abs(pixel - fit.regions[i].centre);
        if (const double distance = std::max(offset.x, offset.y); distance < least) {
          least = distance;
          nearest = i;
        }
      }
      constexpr double reach = 0.75;
      if (least > reach * side || !std::isfinite(residuals[nearest])) continue;
      const rendering::DisplayColour colour = rendering::signedColour(residuals[nearest] / range);
      map.setPixel(x, y, qRgb(colour[0], colour[1], colour[2]));
    }
  return map;
}

double residualRangeOf(const std::vector<double>& residuals) {
  constexpr double least = 0.01, most = 1;
  std::vector<double> sizes;
  for (const double residual : residuals)
    if (std::isfinite(residual)) sizes.push_back(std::abs(residual));
  return std::clamp(widgets::automaticRange(std::move(sizes)), least, most);
}

/// Median and 10th and 90th percentile of the deviations of all cells and channels of each half angle.
std::vector<widgets::UncertaintyCurve::Point> uncertaintyOf(const dictionary::MappedCells& mapping,
                                                            const std::vector<glm::vec3>& deviations) {
  const HalfDifferenceGrid& grid = mapping.grid;
  std::vector<std::vector<float>> values(std::size_t(grid.thetaHCount));
  const std::size_t each = std::size_t(grid.thetaDCount) * std::size_t(grid.phiDCount);
  for (std::size_t i = 0; i < deviations.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) values[mapping.cells[i] / each].push_back(deviations[i][channel]);
  std::vector<widgets::UncertaintyCurve::Point> points;
  for (std::size_t row = 0; row < values.size(); ++row) {
    std::vector<float>& all = values[row];
    if (all.empty()) continue;
    const auto percentile = [&all](double fraction) {
      const auto at = all.begin() + std::ptrdiff_t(std::lround(fraction * double(all.size() - 1)));
      std::ranges::nth_element(all, at);
      return double(*at);
    };
    points.push_back({degrees(grid.node(row * each).thetaH), percentile(0.1), percentile(0.5), percentile(0.9)});
  }
  return points;
}

QString lightName(const photograph::Light& light) {
  if (light.environment) return sceneTitle(light.environment->name());
  if (!light.directional.empty()) return PhotographResultText::tr("Distant light");
  return PhotographResultText::tr("Small light");
}

/// With which the unit sphere nearly fills a picture, rad. @param distance of the camera from its centre.
double fieldOfViewAround(double distance) {
  constexpr double margin = 1.03;
  return 2 * std::atan(margin / std::sqrt(distance * distance - 1));
}

/// The reconstruction on a sphere that fills the picture, or on another surface as the photograph shows it.
QImage sphereOf(const TabulatedBrdf& table, const photograph::Photograph& photograph, double factor,
                const rendering::RenderOptions& picture, const TaskControl& control) {
  rendering::Scene scene = photograph::sceneOf(photograph, photograph.image.width, photograph.image.height);
  // Wherever a sphere is in the photograph.
  if (photograph::isSphere(photograph.surface)) scene.camera.fieldOfView = fieldOfViewAround(scene.camera.distance);
  return photographColours(rendering::renderPicture(table, scene, picture, control), factor);
}

}  // namespace

std::vector<double> relativeResiduals(const photograph::PhotographFit& fit) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < fit.regions.size(); ++i) {
    const double predicted = luminance(fit.predicted[i]);
    residuals.push_back(predicted > 0 ? luminance(fit.regions[i].value) / predicted - 1
                                      : std::numeric_limits<double>::quiet_NaN());
  }
  return residuals;
}

PhotographResultPtr reconstructPhotographs(const PhotographTraining& training, const PhotographInputs& inputs,
                                           std::size_t maxRegions, const rendering::RenderOptions& picture,
                                           const TaskControl& control) {
  const photograph::PhotographSet set = photograph::parseDescription(inputs.description(), {}, true).set;
  auto result = std::make_shared<PhotographResult>();
  result->fit = photograph::fitPhotographs(*training.prior, set, maxRegions, control.between(0.05, 0.75));
  result->table = dictionary::decode(*training.basis, result->fit.code);
  const std::vector<glm::vec3> deviations =
      photograph::deviations(*training.basis, result->fit, control.between(0.75, 0.9));
  result->uncertainty = uncertaintyOf(training.basis->mapping, deviations);
  const std::vector<double> residuals = relativeResiduals(result->fit);
  result->residualRange = residualRangeOf(residuals);
  const std::size_t count = set.photographs.size();
  for (std::size_t i = 0; i < count; ++i) {
    const photograph::Photograph& photograph = set.photographs[i];
    result->paths << inputs[i].path();
    result->residuals.push_back(residualMap(result->fit, residuals, i, inputs[i], result->residualRange));
    result->spheres.push_back(
        sphereOf(*result->table, photograph, result->fit.exposure * inputs[i].brightness, picture,
                 control.between(0.9 + 0.1 * double(i) / double(count), 0.9 + 0.1 * double(i + 1) / double(count))));
    result->lights << lightName(photograph.light);
  }
  return result;
}

QImage sphereUnder(const TabulatedBrdf& table, const std::string& environment, const rendering::RenderOptions& picture,
                   const TaskControl& control) {
  rendering::Scene scene = rendering::sphereScene(rendering::bundledEnvironment(environment));
  scene.camera.fieldOfView = fieldOfViewAround(scene.camera.distance);
  return displayedImage(rendering::renderPicture(table, scene, picture, control));
}

}  // namespace gonio::app
