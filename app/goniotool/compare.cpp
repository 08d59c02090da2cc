// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <stb/stb_easy_font.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "app/goniotool/materials.h"
#include "app/goniotool/picture_options.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "app/goniotool/usage.h"
#include "core/io/image_io.h"
#include "core/math/image.h"
#include "core/metrics/image_errors.h"
#include "core/rendering/error_maps.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/tone_map.h"

namespace gonio::tool {

namespace {

/// 8-bit RGBA, the first row at the top.
struct DisplayPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};

constexpr int gap = 8, captionHeight = 20, legendHeight = 36, barHeight = 10;

constexpr rendering::DisplayColour ink{230, 230, 230}, paper{28, 28, 30};

class Canvas {
 public:
  Canvas(int width, int height) : picture_{width, height, std::vector<std::uint8_t>(std::size_t(width) * height * 4)} {
    fill(0, 0, width, height, paper);
  }

  void set(int x, int y, const rendering::DisplayColour& color) {
    if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) return;
    std::uint8_t* pixel = &picture_.bytes[(std::size_t(y) * picture_.width + std::size_t(x)) * 4];
    std::copy(color.begin(), color.end(), pixel);
    pixel[3] = 255;
  }
  void fill(int left, int top, int width, int height, const rendering::DisplayColour& color) {
    for (int y = top; y < top + height; ++y)
      for (int x = left; x < left + width; ++x) set(x, y, color);
  }

  /// Small capitals of 7 pixels (Sean Barrett's stb_easy_font: quads of 4 vertices of x, y, z, colour).
  void text(int left, int top, const std::string& line) {
    struct Vertex {
      float x, y, z;
      std::uint8_t color[4];
    };
    std::vector<Vertex> vertices(line.size() * 64 + 64);
    std::string copy = line;
    const int quads = stb_easy_font_print(float(left), float(top), copy.data(), nullptr, vertices.data(),
                                          int(vertices.size() * sizeof(Vertex)));
    for (int quad = 0; quad < quads; ++quad) {
      const Vertex &first = vertices[std::size_t(quad) * 4], &opposite = vertices[std::size_t(quad) * 4 + 2];
      fill(int(first.x), int(first.y), int(opposite.x - first.x), int(opposite.y - first.y), ink);
    }
  }

  DisplayPicture take() { return std::move(picture_); }

 private:
  DisplayPicture picture_;
};

int textWidth(const std::string& line) {
  std::string copy = line;
  return stb_easy_font_width(copy.data());
}

std::string legendNumber(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return buffer;
}

void drawLegend(Canvas& canvas, int left, int top, int width, double end) {
  for (int x = 0; x < width; ++x)
    canvas.fill(left + x, top, 1, barHeight, rendering::viridis(double(x) / std::max(1, width - 1)));
  for (int tick = 0; tick <= 2; ++tick) {
    const std::string label = legendNumber(end * tick / 2);
    const int labelWidth = textWidth(label), at = left + tick * (width - 1) / 2;
    canvas.fill(at, top + barHeight, 1, 3, ink);
    canvas.text(std::clamp(at - labelWidth / 2, left, left + width - labelWidth), top + barHeight + 6, label);
  }
}

/// Two renderings of the same size side by side, and their error map with a legend (errorMap()).
DisplayPicture comparisonPicture(const Image& reference, const Image& test, const std::string& referenceName,
                                 const std::string& testName, double exposure, rendering::ToneMap toneMap) {
  const int width = reference.width, height = reference.height, step = width + gap;
  Canvas canvas(3 * step + gap, captionHeight + height + legendHeight);
  const double end = rendering::errorRange(reference, {&test, 1});
  const std::array<std::vector<std::uint8_t>, 3> panels{rendering::toDisplayBytes(reference, exposure, toneMap),
                                                        rendering::toDisplayBytes(test, exposure, toneMap),
                                                        rendering::errorMap(reference, test, end)};
  for (int panel = 0; panel < 3; ++panel) {
    const std::vector<std::uint8_t>& bytes = panels[std::size_t(panel)];
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (const std::size_t i = 4 * reference.index(x, y); bytes[i + 3] > 0)
          canvas.set(gap + panel * step + x, captionHeight + y, {bytes[i], bytes[i + 1], bytes[i + 2]});
  }
  canvas.text(gap, 7, referenceName);
  canvas.text(gap + step, 7, testName);
  canvas.text(gap + 2 * step, 7, "luminance error");
  drawLegend(canvas, gap + 2 * step, captionHeight + height + gap, width, end);
  return canvas.take();
}

struct CompareArguments {
  std::string reference, test, image;
  PictureOptions picture = comparisonPictures();  ///< size and samples; the scene is that of every comparison
};

void writeComparison(const Image& reference, const Image& test, const materials::Material& a,
                     const materials::Material& b, const std::string& out) {
  const DisplayPicture picture = comparisonPicture(reference, test, a.name, b.name, 0, rendering::ToneMap::clamp);
  io::writePng(picture.bytes, picture.width, picture.height, out);
}

int compare(const CompareArguments& options, const Tool& tool) {
  if (!options.image.empty()) checkPicture(options.image, false);
  options.picture.renderOptions();  // reports a wrong size before the work
  const materials::Material a = documents::openMaterial(options.reference, tool.control("reading the first material"));
  const materials::Material b = documents::openMaterial(options.test, tool.control("reading the second material"));
  const std::vector<double> errors = metrics::brdfErrors(*a.brdf, *b.brdf);
  const double brdfSnr = metrics::brdfSignalToNoiseRatio(*a.brdf, *b.brdf);
  const rendering::RenderedComparison comparison(*a.brdf, options.picture.renderOptions(),
                                                 tool.control("rendering the first material"));
  const rendering::ComparisonPicture picture =
      comparison.render(*b.brdf, tool.control("rendering the second material"));
  const double snr = comparison.signalToNoiseRatio(picture);
  const double psnr = comparison.peakSignalToNoiseRatio(picture);
  const std::vector<double> imageErrors = metrics::imageErrors(comparison.reference(), picture.image);
  if (!options.image.empty()) writeComparison(comparison.reference(), picture.image, a, b, options.image);
  Json json{{"errors", errorsJson(errors)},
            {"renderedSnr", decibelsJson(snr)},
            {"renderedPsnr", decibelsJson(psnr)},
            {"imageMetrics", imageErrorsJson(imageErrors)},
            {"scene", rendering::comparisonSceneName},
            {"brdfSnr", decibelsJson(brdfSnr)},
            {"samples", options.picture.samples},
            {"identical", std::isinf(snr) && std::isinf(brdfSnr)}};
  std::string costs;
  for (const auto& [key, material] : {std::pair{"costOfA", &a}, {"costOfB", &b}}) {
    const study::UseCost cost = study::measureUse(*material->brdf, tool.control("measuring times"));
    json[key] = Json::object();
    addCost(json[key], cost);
    costs += material->name + ": " + costText(cost) + "\n";
  }
  if (!options.image.empty()) json["image"] = options.image;
  print(tool, json,
        "rendered SNR " + number(snr) + " dB, PSNR " + number(psnr) + " dB (comparison scene), BRDF SNR " +
            number(brdfSnr) + " dB\n" + costs + imageErrorsText(imageErrors) + errorsText(errors));
  return 0;
}

}  // namespace

void addCompare(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<CompareArguments>();
  CLI::App* command =
      app.add_subcommand("compare", "Computes every metric between two materials and between their images");
  command->add_option("A", options->reference, "Reference material")->required();
  command->add_option("B", options->test, "Material to compare with the reference")->required();
  command->add_option("--image", options->image, "PNG file to write: both images side by side and the error map")
      ->group(outputGroup);
  command->add_option("--size", options->picture.size, "Size of the images, pixels (128)")
      ->type_name("N|WIDTHxHEIGHT")
      ->check(parsedBy(pictureSize));
  command->add_option("--samples", options->picture.samples, "Samples per pixel (32)")->check(CLI::Range(1, 1 << 20));
  command->callback([options, &tool] { tool.run = [options, &tool] { return compare(*options, tool); }; });
}

}  // namespace gonio::tool
