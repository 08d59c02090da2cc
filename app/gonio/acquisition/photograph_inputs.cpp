// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/photograph_inputs.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "core/io/byte_source.h"
#include "core/io/image_io.h"
#include "core/io/json_text.h"
#include "core/math/types.h"
#include "core/photograph/photograph.h"
#include "core/rendering/environment.h"
#include "core/rendering/tone_map.h"
#include "core/support/error.h"
#include "widgets/acquisition/residual_view.h"

namespace gonio::app {

namespace {

using nlohmann::json;

json directionJson(double azimuth, double elevation, double length) {
  return {length * std::sin(azimuth) * std::cos(elevation), length * std::sin(elevation),
          length * std::cos(azimuth) * std::cos(elevation)};
}

PhotographCamera placeOf(const json& position) {
  const double x = position[0], y = position[1], z = position[2];
  return {std::sqrt(x * x + y * y + z * z), std::atan2(x, z), std::atan2(y, std::hypot(x, z))};
}

json discJson(const matching::Disc& disc) { return {{"x", disc.x}, {"y", disc.y}, {"radius", disc.radius}}; }

bool isBundledEnvironment(const QString& name) {
  return std::ranges::count(rendering::bundledEnvironmentNames(), name.toStdString()) > 0;
}

/// Calls change(path) for each path of an entry, as a QString.
template <typename Change>
void changePaths(json& entry, const Change& change) {
  const auto at = [&](json& place) { place = change(QString::fromStdString(place.get<std::string>())).toStdString(); };
  at(entry["file"]);
  for (json& light : entry["lights"])
    if (light.contains("environment") &&
        !isBundledEnvironment(QString::fromStdString(light["environment"].get<std::string>())))
      at(light["environment"]);
}

/// The mean of blocks of pixels, with at most PhotographItem::shownSide per side.
Image reduced(const Image& image) {
  const int step = (std::max(image.width, image.height) + PhotographItem::shownSide - 1) / PhotographItem::shownSide;
  if (step <= 1) return image;
  Image small(std::max(1, image.width / step), std::max(1, image.height / step));
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      glm::vec3 sum(0);
      for (int dy = 0; dy < step; ++dy)
        for (int dx = 0; dx < step; ++dx) {
          const glm::vec3& pixel =
              image.at(std::min(x * step + dx, image.width - 1), std::min(y * step + dy, image.height - 1));
          if (std::isfinite(pixel.x + pixel.y + pixel.z)) sum += pixel;
        }
      small.at(x, y) = sum / float(step * step);
    }
  return small;
}

/// Factor that makes the surface as bright as a display shows it without losing much in the highlights.
double brightnessFor(const photograph::Photograph& photograph) {
  constexpr double bright = 0.95, shown = 0.6;
  const photograph::SurfaceView view(photograph);
  const Image& image = photograph.image;
  std::vector<double> values;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (view.shows({x + 0.5, y + 0.5}))
        if (const double value = luminance(Rgb(image.at(x, y))); std::isfinite(value)) values.push_back(value);
  if (values.empty()) return 1;
  const auto at = values.begin() + std::ptrdiff_t(bright * double(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at > 0 ? shown / *at : 1;
}

PhotographItem itemOf(json entry, const photograph::Photograph& photograph) {
  PhotographItem item;
  item.entry = std::move(entry);
  if (item.hasOutline()) item.setDisc(photograph.disc);
  item.describedLights = item.entry["lights"];
  item.size = {photograph.image.width, photograph.image.height};
  item.brightness = brightnessFor(photograph);
  item.shown = photographColours(reduced(photograph.image), item.brightness);
  return item;
}

PhotographItem readPhotograph(const QString& path, const json& like) {
  json entry{{"file", QFileInfo(path).absoluteFilePath().toStdString()},
             {"camera", {{"position", {0, 0, PhotographCamera().distance}}}},
             {"lights", json::array({{{"environment", PhotographLight().environment.toStdString()}}})}};
  for (const char* member : {"shape", "camera", "lights"})
    if (like.contains(member)) entry[member] = like[member];
  const json root{{"format", "gonio photographs"}, {"version", 1}, {"images", json::array({entry})}};
  photograph::PhotographSet set = photograph::parseDescription(io::exactJsonText(root), {}, true).set;
  photograph::Photograph& photograph = set.photographs.front();
  bool found = true;
  if (photograph::isSphere(photograph.surface)) try {
      photograph.disc = matching::findSphere(photograph.image);
    } catch (const Error&) {
      found = false;  // the user moves the circle
    }
  PhotographItem item = itemOf(std::move(entry), photograph);
  item.isOutlineFound = found;
  return item;
}

}  // namespace

QString PhotographItem::path() const { return QString::fromStdString(entry["file"].get<std::string>()); }

matching::Disc PhotographItem::disc() const {
  if (!hasOutline())
    return {size.width() / 2.0, size.height() / 2.0,
            std::max(size.width(), size.height()) / (2 * widgets::ResidualView::mapExtent)};
  const json& sphere = entry["sphere"];
  return {sphere["x"], sphere["y"], sphere["radius"]};
}

void PhotographItem::setDisc(const matching::Disc& disc) { entry["sphere"] = discJson(disc); }

PhotographCamera PhotographItem::camera() const { return placeOf(entry["camera"]["position"]); }

void PhotographItem::setCamera(const PhotographCamera& camera) {
  entry["camera"]["position"] = directionJson(camera.azimuth, camera.elevation, camera.distance);
}

PhotographLight PhotographItem::light() const {
  PhotographLight light;
  const json& lights = entry["lights"];
  const json& first = lights[0];
  if (lights.size() == 1 && first.contains("environment")) {
    light.environment = QString::fromStdString(first["environment"].get<std::string>());
    light.rotation = radians(first.value("rotation", 0.0));
  } else if (lights.size() == 1 && first.contains("toLight")) {
    light.kind = PhotographLight::Kind::distant;
    const PhotographCamera place = placeOf(first["toLight"]);
    light.azimuth = place.azimuth;
    light.elevation = place.elevation;
    for (const json& channel : first["irradiance"]) light.irradiance += channel.get<double>() / 3;
  } else {
    light.kind = PhotographLight::Kind::other;
  }
  return light;
}

void PhotographItem::setLight(const PhotographLight& light) {
  const PhotographLight before = this->light();
  json& lights = entry["lights"];
  if (light.kind == PhotographLight::Kind::other) {
    lights = describedLights;
  } else if (light.kind == PhotographLight::Kind::environment) {
    lights = json::array({{{"environment", light.environment.toStdString()}, {"rotation", degrees(light.rotation)}}});
  } else {
    // The colour of a light that was read stays.
    json irradiance = {light.irradiance, light.irradiance, light.irradiance};
    if (before.kind == PhotographLight::Kind::distant && before.irradiance > 0)
      for (std::size_t i = 0; i < 3; ++i)
        irradiance[i] = lights[0]["irradiance"][i].get<double>() * (light.irradiance / before.irradiance);
    lights = json::array({{{"toLight", directionJson(light.azimuth, light.elevation, 1)}, {"irradiance", irradiance}}});
  }
}

void PhotographInputs::add(std::vector<PhotographItem> items) {
  for (PhotographItem& item : items) m_items.push_back(std::move(item));
}

void PhotographInputs::remove(std::size_t index) { m_items.erase(m_items.begin() + std::ptrdiff_t(index)); }

bool PhotographInputs::isExposureKnown() const { return m_root.value("exposure", "known") == "known"; }

void PhotographInputs::setExposureKnown(bool known) { m_root["exposure"] = known ? "known" : "unknown"; }

std::string PhotographInputs::description(const QString& folder) const {
  json root = m_root;
  root["format"] = "gonio photographs";
  root["version"] = 1;
  root["images"] = json::array();
  const QString inside = QDir(folder).absolutePath() + '/';
  for (const PhotographItem& item : m_items) {
    json entry = item.entry;
    if (!folder.isEmpty())
      changePaths(entry, [&](const QString& path) { return path.startsWith(inside) ? path.mid(inside.size()) : path; });
    root["images"].push_back(std::move(entry));
  }
  constexpr int indent = 1;
  return io::exactJsonText(root, indent) + '\n';
}

PhotographInputs readPhotographDescription(const QString& path, const TaskControl& control) {
  const photograph::PhotographDescription read = photograph::readDescription(path.toStdString());
  control.throwIfStopped();
  const std::vector<std::byte> bytes = io::FileSource(path.toStdString()).readAll(std::uint64_t(1) << 24);
  PhotographInputs inputs;
  inputs.m_root = io::parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  const json images = inputs.m_root["images"];
  inputs.m_root.erase("images");
  const QDir folder = QFileInfo(path).absoluteDir();
  for (std::size_t i = 0; i < images.size(); ++i) {
    json entry = images[i];
    changePaths(entry, [&](const QString& file) { return QDir::cleanPath(folder.absoluteFilePath(file)); });
    inputs.m_items.push_back(itemOf(std::move(entry), read.set.photographs[i]));
    control.throwIfStopped();
  }
  return inputs;
}

std::vector<PhotographItem> readPhotographs(const QStringList& paths, const json& like, const TaskControl& control) {
  std::vector<PhotographItem> items;
  for (const QString& path : paths) {
    control.report(double(items.size()) / double(paths.size()));
    items.push_back(readPhotograph(path, like));
  }
  return items;
}

matching::Disc findOutline(const PhotographItem& item) {
  const std::filesystem::path path = item.path().toStdString();
  return withFileInErrors(path, [&] { return matching::findSphere(io::readImage(path)); });
}

bool isPhotographFile(const QString& path) {
  static const QStringList suffixes{"exr", "hdr", "png", "jpg", "jpeg"};
  return suffixes.contains(QFileInfo(path).suffix().toLower());
}

bool isPhotographDescription(const QString& path) { return QFileInfo(path).suffix().toLower() == "json"; }

QImage photographColours(const Image& radiance, double factor) {
  const auto bytes = rendering::toDisplayBytes(radiance, std::log2(factor), rendering::ToneMap::clamp);
  return QImage(bytes.data(), radiance.width, radiance.height, 4 * radiance.width, QImage::Format_RGBA8888).copy();
}

}  // namespace gonio::app
