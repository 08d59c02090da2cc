// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/photograph_candidates.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/io/json_text.h"
#include "core/math/types.h"
#include "core/photograph/surface.h"
#include "core/support/json_object.h"

namespace gonio::photograph {

namespace {

using JsonText = nlohmann::json;

Direction tripleOf(const JsonText& json, const char* key) {
  const auto [x, y, z] = JsonObject(json, "").triple(key);
  return {x, y, z};
}

JsonText tripleJson(const Direction& of) { return {of.x, of.y, of.z}; }

std::string degreesText(const char* what, double angle) {
  char text[32];
  std::snprintf(text, sizeof text, "%s-%03.0f.exr", what, angle);
  return text;
}

/// A variant of an image: another file, without the grey patch.
JsonText variantOf(const JsonText& image, std::string file) {
  JsonText variant = image;
  variant["file"] = std::move(file);
  variant.erase("greyPatch");
  return variant;
}

void addRotations(const JsonText& image, int count, JsonText& candidates) {
  const auto hasEnvironment = [](const JsonText& light) { return light.contains("environment"); };
  if (count > 0 && std::ranges::none_of(image.at("lights"), hasEnvironment))
    JsonObject(image, "images[0]").fail("lights", "an environment, of which rotations are candidates");
  for (int i = 0; i < count; ++i) {
    const double angle = 360.0 * i / count;
    JsonText variant = variantOf(image, degreesText("rotation", angle));
    for (JsonText& light : variant["lights"])
      if (hasEnvironment(light)) light["rotation"] = angle;
    candidates.push_back(std::move(variant));
  }
}

/// The i-th of `count` directions evenly spread over a cap about an axis, along a spiral of golden angles.
Direction spreadDirection(const Direction& axis, int i, int count) {
  const double leastCosine = std::cos(radians(120)), golden = pi * (3 - std::sqrt(5.0));
  const double cosine = 1 - (1 - leastCosine) * (i + 0.5) / count, sine = std::sqrt(1 - cosine * cosine);
  const Direction right = glm::normalize(glm::cross(Direction(0, 1, 0), axis)), up = glm::cross(axis, right);
  return cosine * axis + sine * (std::cos(golden * i) * right + std::sin(golden * i) * up);
}

void addLights(const JsonText& image, int count, JsonText& candidates) {
  const Direction toCamera = glm::normalize(tripleOf(image.at("camera"), "position"));
  for (int i = 0; i < count; ++i) {
    const Direction direction = spreadDirection(toCamera, i, count);
    JsonText variant = variantOf(image, "light-" + std::to_string(i + 1) + ".exr");
    JsonText& lights = variant["lights"];
    const auto moved = std::ranges::find_if(
        lights, [](const JsonText& light) { return light.contains("toLight") || light.contains("position"); });
    if (moved == lights.end())
      lights.push_back({{"toLight", tripleJson(direction)}, {"irradiance", {pi, pi, pi}}});
    else if (moved->contains("toLight"))
      (*moved)["toLight"] = tripleJson(direction);
    else
      (*moved)["position"] = tripleJson(direction * glm::length(tripleOf(*moved, "position")));
    candidates.push_back(std::move(variant));
  }
}

void addCameras(const JsonText& image, int count, JsonText& candidates) {
  const Direction position = tripleOf(image.at("camera"), "position");
  const Surface surface = readSurface(JsonObject(image, "images[0]"));
  for (int i = 0; i < count; ++i) {
    const double angle = 360.0 * i / count, c = std::cos(radians(angle)), s = std::sin(radians(angle));
    JsonText variant = variantOf(image, degreesText("camera", angle));
    const Direction turned{c * position.x + s * position.z, position.y, c * position.z - s * position.x};
    if (!isOutside(surface, turned)) continue;
    variant["camera"]["position"] = tripleJson(turned);
    candidates.push_back(std::move(variant));
  }
}

}  // namespace

std::string withCandidates(const std::string& description, const CandidateCounts& counts) {
  JsonText json = io::parseJson(description);
  const JsonObject root(json, "");
  if (root.array("images").empty()) root.fail("images", "at least one image");
  const JsonText image = json["images"][0];
  const JsonObject first(image, "images[0]");
  first.array("lights");
  first.object("camera").triple("position");
  if (!json.contains("candidates")) json["candidates"] = JsonText::array();
  JsonText& candidates = json["candidates"];
  addRotations(image, counts.rotations, candidates);
  addLights(image, counts.lights, candidates);
  addCameras(image, counts.cameras, candidates);
  return io::jsonText(json);
}

std::string withChosenCandidates(const std::string& description, std::span<const std::size_t> chosen) {
  JsonText json = io::parseJson(description);
  for (const std::size_t candidate : chosen) json["images"].push_back(json["candidates"].at(candidate));
  json.erase("candidates");
  return io::jsonText(json);
}

}  // namespace gonio::photograph
