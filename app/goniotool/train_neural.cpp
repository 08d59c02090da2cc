// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <optional>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/baselines/neural_fit.h"
#include "core/formats/formats.h"
#include "core/formats/neural.h"
#include "core/io/byte_source.h"
#include "core/rendering/render_picture.h"
#include "core/support/error.h"

namespace gonio::tool {

namespace {

struct NeuralArguments {
  std::string material, out, weights;
  baselines::NeuralFitOptions training;
  std::size_t row = 0;
  int samples = rendering::smallComparisonPicture().samples;
};

/// Row `row` of a file of rows of 675 float32, as the weights of Sztrajman et al. are exchanged.
baselines::NeuralFit publishedWeights(const std::string& path, std::size_t row) {
  return withFileInErrors(path, [&] {
    const io::FileSource file(path);
    baselines::NeuralFit fit;
    constexpr std::size_t rowBytes = sizeof fit.weights;
    if (file.size() == 0 || file.size() % rowBytes != 0 || row >= file.size() / rowBytes)
      throw Error("found " + std::to_string(file.size()) + " bytes, expected rows of " + std::to_string(rowBytes) +
                  " bytes, at least up to row " + std::to_string(row) + " (counted from 0)");
    const auto bytes = std::as_writable_bytes(std::span(fit.weights));
    file.readAt(row * rowBytes, bytes);
    return fit;
  });
}

int trainNeural(const NeuralArguments& options, const Tool& tool) {
  if (!options.out.empty() && !materials::hasSuffixOf(formats::neuralFormat, options.out))
    materials::checkWritableSuffix(options.out);
  const materials::Material material = documents::openMaterial(options.material, tool.control("reading"));
  const auto table = meanOfOrders(material.tabulated(tool.control("tabulating")));
  const baselines::NeuralFit fit = options.weights.empty()
                                       ? baselines::fitNeural(*table, options.training, tool.control("training"))
                                       : publishedWeights(options.weights, options.row);
  const auto brdf = std::make_shared<const NeuralBrdf>(fit.weights);
  const study::MaterialQuality quality = qualityOf(material, *brdf, nullptr, options.samples, tool);
  WrittenMaterial written;
  if (materials::hasSuffixOf(formats::neuralFormat, options.out))
    formats::writeNeural(fit.weights, options.out);
  else if (!options.out.empty())
    written = writeMaterial(material.name, brdf, options.out, tool, table->grid());
  Json json{{"weights", fit.weights.size()},
            {"bytes", formats::neuralFileBytes},
            {"losses", fit.losses},
            {"seconds", fit.seconds}};
  addQuality(json, quality);
  const std::string tableText = addTableQuality(json, *material.brdf, *table);
  if (written.bytes > 0) json["written"] = written.json();
  if (!options.out.empty()) json["out"] = options.out;
  print(tool, json,
        std::to_string(fit.weights.size()) + " weights, " + std::to_string(formats::neuralFileBytes) + " bytes, " +
            (fit.losses.empty() ? "" : "loss " + number(fit.losses.back()) + ", ") + qualityText(quality, fit.seconds) +
            tableText + written.text);
  return 0;
}

}  // namespace

void addTrainNeural(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<NeuralArguments>();
  CLI::App* command = app.add_subcommand(
      "train-neural", "Trains a neural BRDF of 675 weights (Sztrajman et al. 2021) to reproduce a material");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  auto* steps =
      command->add_option("--steps", options->training.steps, "Number of training steps, about 0.3 ms each (40000)");
  steps->check(CLI::Range(1, 100'000'000));
  auto* rate =
      command->add_option("--learning-rate", options->training.learningRate, "Learning rate at the start (0.01)");
  rate->check(CLI::Range(1e-6, 1.0));
  auto* seed =
      command->add_option("--seed", options->training.seed, "Seed of the initial weights and of the batches (1)");
  auto* weights = command
                      ->add_option("--weights", options->weights,
                                   "File of published weights to use instead of training: rows of 675 float32 values")
                      ->type_name("FILE");
  for (CLI::Option* option : {steps, rate, seed}) weights->excludes(option);
  command->add_option("--row", options->row, "Row of the material in --weights, from 0 (0)")->needs(weights);
  command->add_option("--samples", options->samples, "Samples per pixel of the images for the rendered SNR (32)")
      ->check(CLI::Range(1, 1 << 20));
  command
      ->add_option("--out", options->out,
                   "File to write: the network (" + suffixOf(formats::neuralFormat) + "), or " +
                       outputHelp("the material that it represents"))
      ->group(outputGroup);
  command->callback([options, &tool] { tool.run = [options, &tool] { return trainNeural(*options, tool); }; });
}

}  // namespace gonio::tool
