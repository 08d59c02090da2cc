// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rendering/scene.h"
#include "core/rendering/tone_map.h"
#include "core/study/representation.h"

namespace gonio::figures {

/// How wide a figure is: one column of a page with two, or both.
enum class FigureWidth { oneColumn, twoColumns };

struct FigureMaterial {
  std::string path;        ///< what editing::openMaterial() takes
  std::string label = {};  ///< "": the material's name

  bool operator==(const FigureMaterial&) const = default;
};

struct FigureRepresentation {
  study::Representation representation;
  std::string label = {};  ///< "": the name of a model; else the representation's label with its budget

  bool operator==(const FigureRepresentation&) const = default;
  std::string shownLabel() const;
};

/// A square part of every picture that is shown magnified: in fractions of the picture's side, from the top left.
struct FigureInset {
  double x = 0.35, y = 0.15, size = 0.25;

  bool operator==(const FigureInset&) const = default;
};

/// How the pictures are rendered and displayed. They are square.
struct FigurePictures {
  std::string scene;        ///< what openScene() takes; "": comparisonScene()
  std::string environment;  ///< what openEnvironment() takes; "": that of the scene
  int size = 256;           ///< pixels a side
  int samples = 64;         ///< per pixel
  double exposure = 0;      ///< stops
  ToneMap toneMap = ToneMap::clamp;

  bool operator==(const FigurePictures&) const = default;
};

/// What a figure shows and how: materials by representations. A value that can be saved, so that the figure can be made
/// again. JSON, versioned:
///   {"format": "gonio figure", "version": 1, "columns": "two", "font": "Helvetica", "fontSize": 8,
///    "materials": [{"path": "library:merl-copy/chrome", "label": "chrome"}, ..],
///    "representations": [{"id": "ggx"}, {"id": "factors-3d", "budget": 10, "label": "PDV"}, ..],
///    "pictures": {"scene": "row", "environment": "sky", "size": 256, "samples": 64, "exposure": 0,
///                 "toneMap": "clamp"},
///    "numbers": ["rendered-snr", "bytes"], "inset": {"x": 0.35, "y": 0.15, "size": 0.25},
///    "errorMaps": true, "errorMaximum": 0.5}
/// All but the format, the version, the materials and the representations may be left out.
struct FigureDescription {
  static constexpr int currentVersion = 1;

  std::string title;
  FigureWidth width = FigureWidth::twoColumns;
  std::string font = "Helvetica";  ///< family; where it is not installed, the one that the system has instead
  double fontSize = 0;             ///< pt; 0: 7 in one column, 8 in two
  std::vector<FigureMaterial> materials;
  std::vector<FigureRepresentation> representations;
  FigurePictures pictures;
  std::vector<std::string> numbers{"rendered-snr", "bytes"};  ///< ids of figureNumbers(), in their order
  std::optional<FigureInset> inset;
  bool errorMaps = true;
  std::optional<double> errorMaximum;  ///< difference of luminance at the end of the scale; none: from all pictures

  bool operator==(const FigureDescription&) const = default;
};

/// "one" and "two", in descriptions and on the command line.
std::string_view figureWidthId(FigureWidth width);

nlohmann::ordered_json toJson(const FigureDescription& description);
/// @throws Error stating the member, what was found and what was expected.
FigureDescription figureFromJson(const nlohmann::json& json);

/// With the paths of materials, scene and environment resolved against the folder of the file.
/// @throws Error naming the file.
FigureDescription readFigureDescription(const std::filesystem::path& path);
/// As text for a file at `path`: files beside or below its folder are written relative to it, so that both can be moved
/// together.
std::string figureDescriptionText(const FigureDescription& description, const std::filesystem::path& path);

/// The files that a figure is made of, by the paths of the description; bundled ones are none.
std::vector<std::string> figureSources(const FigureDescription& description);

/// @throws Error for a scene or an environment that cannot be opened.
Scene figureScene(const FigurePictures& pictures);

/// Stating the member, as figureFromJson(). For descriptions that were put together elsewhere.
/// @throws Error for no materials, no representations, or numbers that are outside the ranges that files may have.
void checkFigure(const FigureDescription& description);

}  // namespace gonio::figures
