// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>

#include "app/goniotool/comparison_picture.h"
#include "app/goniotool/materials.h"
#include "app/goniotool/picture_options.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "app/goniotool/usage.h"
#include "core/io/image_io.h"
#include "core/metrics/image_errors.h"
#include "core/rendering/render_picture.h"

namespace gonio::tool {

namespace {

struct CompareArguments {
  std::string reference, test, image;
  PictureOptions picture;  ///< size and samples; the scene is that of every comparison
};

void writeComparison(const Image& reference, const Image& test, const materials::Material& a,
                     const materials::Material& b, const std::string& out) {
  const DisplayPicture picture = comparisonPicture(reference, test, a.name, b.name, 0, ToneMap::clamp);
  io::writePng(picture.bytes, picture.width, picture.height, out);
}

int compare(const CompareArguments& options, const Tool& tool) {
  if (!options.image.empty()) checkPicture(options.image, false);
  options.picture.renderOptions();  // reports a wrong size before the work
  const materials::Material a = openMaterial(options.reference, tool.control("reading the first material"));
  const materials::Material b = openMaterial(options.test, tool.control("reading the second material"));
  const std::vector<double> errors = metrics::brdfErrors(*a.brdf, *b.brdf);
  const double brdfSnr = metrics::brdfSignalToNoiseRatio(*a.brdf, *b.brdf);
  const RenderedComparison comparison(*a.brdf, options.picture.renderOptions(),
                                      tool.control("rendering the first material"));
  const ComparisonPicture picture = comparison.render(*b.brdf, tool.control("rendering the second material"));
  const double snr = comparison.signalToNoiseRatio(picture);
  const double psnr = comparison.peakSignalToNoiseRatio(picture);
  const std::vector<double> imageErrors = metrics::imageErrors(comparison.reference(), picture.image);
  if (!options.image.empty()) writeComparison(comparison.reference(), picture.image, a, b, options.image);
  Json json{{"errors", errorsJson(errors)},       {"renderedSnr", decibelsJson(snr)},
            {"renderedPsnr", decibelsJson(psnr)}, {"imageMetrics", imageErrorsJson(imageErrors)},
            {"scene", comparisonSceneName},       {"brdfSnr", decibelsJson(brdfSnr)},
            {"samples", options.picture.samples}, {"identical", std::isinf(snr) && std::isinf(brdfSnr)}};
  if (!options.image.empty()) json["image"] = options.image;
  print(tool, json,
        "rendered SNR " + number(snr) + " dB, PSNR " + number(psnr) + " dB (comparison scene), BRDF SNR " +
            number(brdfSnr) + " dB\n" + imageErrorsText(imageErrors) + errorsText(errors));
  return 0;
}

}  // namespace

void addCompare(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<CompareArguments>();
  CLI::App* command =
      app.add_subcommand("compare", "Computes every metric between two materials and between their images");
  command->add_option("A", options->reference, "Reference material")->required();
  command->add_option("B", options->test, "Material to compare with the reference")->required();
  command->add_option("--image", options->image, "PNG file to write: both images side by side and the error map");
  command->add_option("--size", options->picture.size, "Size of the images, pixels (256)")
      ->check(parsedBy(pictureSize));
  command->add_option("--samples", options->picture.samples, "Samples per pixel (64)")->check(CLI::Range(1, 1 << 20));
  command->callback([options, &tool] { tool.run = [options, &tool] { return compare(*options, tool); }; });
}

}  // namespace gonio::tool
