// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/rendering/scene.h"
#include "core/rendering/tone_map.h"
#include "core/study/accuracy_study.h"
#include "core/study/representation.h"

namespace gonio::figures {

/// Whether higher or lower values are better.
enum class Better { higher, lower };

/// A number to display below a picture: an error, size or time of a representation.
struct FigureNumber {
  std::string id;    ///< in descriptions and JSON, e.g. "rendered-snr", "flip", "log", "bytes", "evaluation-time"
  std::string name;  ///< for display in figures and tables, e.g. "SNR"
  std::string unit;  ///< of the value; empty for a number without unit
  Better better = Better::lower;
  bool isError = true;   ///< an error or SNR, not a cost
  bool isTimed = false;  ///< a time on this machine, which differs from run to run
  std::function<double(const study::MeasuredRepresentation& studied, const Image& reference)> value;

  /// Name and unit, e.g. "SNR [dB]".
  std::string title() const;
};

/// All numbers: rendered SNR; metrics of pictures (metrics::imageMetricRecords()); metrics of BRDF values
/// (metrics::metricRecords()); size; times of encoding, of one evaluation and of one frame.
std::span<const FigureNumber> figureNumbers();
/// @throws Error that lists the ids.
const FigureNumber& figureNumber(std::string_view id);

/// A value with three significant digits and its unit, for sizes and times with an SI prefix: "38.2 dB", "44.7 kB",
/// "1.25 ms", "∞ dB"; "-" for NaN.
std::string valueText(const FigureNumber& number, double value);
/// The value with three significant digits, without SI prefix and unit, for tables with the unit in the header: "38.2",
/// "1.25e-08". Bytes and values from 1000 on are whole numbers.
std::string tableText(const FigureNumber& number, double value);

/// Width of a figure on a two-column page.
enum class FigureWidth { oneColumn, twoColumns };

struct FigureMaterial {
  std::string path;        ///< as for editing::openMaterial()
  std::string label = {};  ///< empty: the material's name

  bool operator==(const FigureMaterial&) const = default;
};

struct FigureRepresentation {
  study::Representation representation;
  std::string label = {};  ///< empty: the name of the model, or the representation's label with its budget

  bool operator==(const FigureRepresentation&) const = default;
  std::string shownLabel() const;
};

/// A square part of every picture that is magnified; in fractions of the picture's side, from the top left.
struct FigureInset {
  static constexpr double minSize = 0.01;

  double x = 0.35, y = 0.15, size = 0.25;

  bool operator==(const FigureInset&) const = default;
};

/// How the pictures, which are square, are rendered and displayed.
struct FigurePictures {
  static constexpr int maxSize = 2048, maxSamples = 1 << 20;
  static constexpr double maxExposure = 30;

  std::string scene;        ///< as for openScene(); empty: comparisonScene()
  std::string environment;  ///< as for openEnvironment(); empty: the scene's own
  int size = 256;           ///< pixels per side
  int samples = 64;         ///< per pixel
  double exposure = 0;      ///< stops
  rendering::ToneMap toneMap = rendering::ToneMap::clamp;

  bool operator==(const FigurePictures&) const = default;
};

/// The content and layout of a figure: a grid of materials and representations. Saved as JSON with a version, so that a
/// figure can be reproduced:
///   {"format": "gonio figure", "version": 1, "columns": "two", "font": "Helvetica", "fontSize": 8,
///    "materials": [{"path": "library:merl-copy/chrome", "label": "chrome"}, ..],
///    "representations": [{"id": "ggx"}, {"id": "factors-3d", "budget": 10, "label": "PDV"}, ..],
///    "pictures": {"scene": "row", "environment": "sky", "size": 256, "samples": 64, "exposure": 0,
///                 "toneMap": "clamp"},
///    "numbers": ["rendered-snr", "bytes", "evaluation-time"], "inset": {"x": 0.35, "y": 0.15, "size": 0.25},
///    "errorMaps": true, "errorMaximum": 0.5}
/// Only format, version, materials and representations are required.
struct FigureDescription {
  static constexpr int currentVersion = 1;
  static constexpr std::size_t maxMaterials = 50, maxRepresentations = 12, maxNumbers = 8;
  static constexpr double minFontSize = 4, maxFontSize = 24;  ///< pt
  static constexpr double minErrorMaximum = 1e-9, maxErrorMaximum = 1e9;

  std::string title;
  FigureWidth width = FigureWidth::twoColumns;
  std::string font = "Helvetica";  ///< family; if it is not installed, the system's substitute
  double fontSize = 0;             ///< pt; 0: 7 in one column, 8 in two
  std::vector<FigureMaterial> materials;
  std::vector<FigureRepresentation> representations;
  FigurePictures pictures;
  std::vector<std::string> numbers{"rendered-snr", "bytes",
                                   "evaluation-time"};  ///< ids of figureNumbers(), in the order of display
  std::optional<FigureInset> inset;
  bool errorMaps = true;
  std::optional<double> errorMaximum;  ///< luminance difference at the end of the error scale; empty: from all pictures

  bool operator==(const FigureDescription&) const = default;
};

/// The id in descriptions and on the command line: "one" or "two".
std::string_view figureWidthId(FigureWidth width);

nlohmann::ordered_json toJson(const FigureDescription& description);
/// @throws Error that states the member, what was found and what was expected.
FigureDescription figureFromJson(const nlohmann::json& json);

/// Reads a description; relative paths of materials, scene and environment are resolved against the file's folder.
/// @throws Error that names the file.
FigureDescription readFigureDescription(const std::filesystem::path& path);
/// The JSON text for a file at `path`. Files in or below its folder are written as relative paths, so that they can be
/// moved together.
std::string figureDescriptionText(const FigureDescription& description, const std::filesystem::path& path);

/// Paths of the files that a figure uses, as in the description, without bundled ones.
std::vector<std::string> figureSources(const FigureDescription& description);
/// Checks that an output file does not overwrite a source of the figure. Reads the documents among the sources.
/// @throws Error that names the file if it is a source, or a file that a document among the sources edits.
void checkFigureOutput(const FigureDescription& description, const std::filesystem::path& path);

/// The scene with its environment replaced if the pictures name one. @throws Error if scene or environment cannot be
/// opened.
rendering::Scene figureScene(const FigurePictures& pictures);

/// Checks a description that does not come from figureFromJson(). @throws Error that states the member, if there are no
/// materials or no representations or a number is outside the range that files allow.
void checkFigure(const FigureDescription& description);

}  // namespace gonio::figures
