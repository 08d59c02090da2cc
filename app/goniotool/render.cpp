// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <chrono>
#include <cmath>

#include "app/goniotool/materials.h"
#include "app/goniotool/picture_options.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/io/mesh_file.h"
#include "core/metrics/image_metrics.h"
#include "core/rendering/plan_check.h"
#include "core/rendering/sampling_method.h"
#include "core/rendering/scene_file.h"
#include "core/rendering/strategy_costs.h"

namespace gonio::tool {

namespace {

using Materials = std::vector<std::shared_ptr<const rendering::RenderMaterial>>;

struct RenderArguments {
  std::vector<std::string> materials, on, off;
  std::string scene = "sphere", up = "y", out, sampling{rendering::samplingMethods().front().id};
  std::shared_ptr<PictureOptions> picture = std::make_shared<PictureOptions>();
  bool effects = false, costs = false, strategies = false, everything = false, compare = false;
  int reflections = rendering::EffectThresholds().maxReflections;
  double remainder = rendering::EffectThresholds().remainder, wavelength = 0;
};

rendering::EffectOverrides overridesOf(const RenderArguments& options) {
  rendering::EffectOverrides overrides;
  if (options.everything) overrides = rendering::everyEffect();
  for (const auto& [ids, value] : {std::pair{&options.on, true}, {&options.off, false}})
    for (const std::string& id : *ids) overrides[std::size_t(rendering::effectOfId(id))] = value;
  return overrides;
}

std::vector<std::string> effectIds() {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < rendering::effectCount; ++i) ids.emplace_back(rendering::effectId(rendering::Effect(i)));
  return ids;
}

void requirePlaces(const rendering::Scene& scene, std::size_t materials) {
  const std::size_t places = std::size_t(std::max(1, rendering::materialSlotCount(scene)));
  if (materials > places)
    throw UsageError("MATERIAL: found " + std::to_string(materials) + ", expected at most " + std::to_string(places) +
                     ", as many as the scene '" + scene.name + "' shows");
}

Materials openMaterials(const RenderArguments& options, const Tool& tool) {
  Materials materials;
  for (const std::string& material : options.materials) {
    const auto brdf = openAtWavelength(material, options.wavelength, tool.control("reading " + material));
    materials.push_back(rendering::sampledBy(options.sampling, brdf, tool.control("sampling by " + options.sampling)));
  }
  return materials;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

struct Rendered {
  rendering::Film film;
  double seconds = 0;
};

Rendered renderPicture(const rendering::PathTracer& tracer, const rendering::RenderOptions& size, const Tool& tool) {
  Rendered result{rendering::Film(size.width, size.height)};
  const auto start = std::chrono::steady_clock::now();
  tracer.accumulate(result.film, size.samples, tool.control("rendering"));
  result.seconds = secondsSince(start);
  return result;
}

std::vector<rendering::StrategyCost> measureStrategies(const rendering::PathTracer& tracer, const Materials& materials,
                                                       const rendering::RenderOptions& size, const Tool& tool) {
  return rendering::measureStrategyCosts(
      tracer.scene(), materials, tracer.plan(),
      {.width = size.width, .height = size.height, .samples = size.samples, .referenceSamples = 64 * size.samples},
      tool.control("measuring strategies"));
}

/// Adds the figures of each sampling strategy to the result.
void reportStrategies(std::span<const rendering::StrategyCost> costs, Json& json, std::string& text) {
  Json list = Json::array();
  for (const rendering::StrategyCost& cost : costs) {
    list.push_back({{"strategy", rendering::strategyId(cost.strategy)},
                    {"seconds", cost.seconds},
                    {"error", cost.error},
                    {"equalTimeError", cost.equalTimeError},
                    {"equalErrorTime", cost.equalErrorTime}});
    text += std::string("  sampling ") + rendering::strategyId(cost.strategy) + ": " + number(cost.seconds) +
            " s, error " + number(100 * cost.error) + " %; estimated: error " + number(100 * cost.equalTimeError) +
            " % in the time of 'both', " + number(cost.equalErrorTime) + " s to reach the error of 'both'\n";
  }
  json["strategies"] = list;
}

Json countersJson(const rendering::RayCounters& rays) {
  return {{"cameraRays", rays.camera}, {"shadowRays", rays.shadow}, {"bounceRays", rays.bounce}};
}

/// All effects, with the frames of the plan, so that both pictures have the same random directions.
rendering::EffectOverrides everythingLike(const rendering::EffectPlan& plan) {
  rendering::EffectOverrides overrides = rendering::everyEffect();
  const auto frames = rendering::Effect::anisotropicFrames;
  overrides[std::size_t(frames)] = plan.simulates(frames);
  return overrides;
}

/// Adds rays and time of the picture with all effects, and its difference from the planned picture.
void reportEverything(const Rendered& planned, const rendering::PathTracer& everything,
                      const rendering::RenderOptions& size, const Tool& tool, Json& json, std::string& text) {
  const Rendered all = renderPicture(everything, size, tool);
  const Image a = planned.film.image(), b = all.film.image();
  const auto meanOf = [](const Image& image) {
    double sum = 0;
    for (const glm::vec3& pixel : image.pixels) sum += luminance(Rgb(pixel));
    return sum / double(image.pixels.size());
  };
  const double difference = metrics::relativeDifference(b, a), mean = meanOf(a), meanOfAll = meanOf(b);
  json["everything"] = {{"seconds", all.seconds},
                        {"counters", countersJson(all.film.counters)},
                        {"difference", difference},
                        {"mean", meanOfAll},
                        {"plannedMean", mean}};
  text += "  with all effects: " + number(all.seconds) + " s, " + std::to_string(all.film.counters.shadow) +
          " shadow rays, " + std::to_string(all.film.counters.bounce) + " bounce rays; mean " + number(meanOfAll) +
          " instead of " + number(mean) + ", RMS difference " + number(100 * difference) + " % (with noise)\n";
}

int render(const RenderArguments& options, const Tool& tool) {
  if (options.out.empty() && !options.effects && !options.costs && !options.strategies)
    throw UsageError("--out is missing: name an image to write, or use --effects, --effect-costs or --strategy-costs");
  if (!options.out.empty()) checkPicture(options.out);
  const rendering::RenderOptions size = options.picture->renderOptions();
  rendering::Scene scene =
      rendering::openScene(options.scene, int(options.materials.size()), rendering::upAxisOf(options.up));
  requirePlaces(scene, options.materials.size());
  options.picture->apply(scene);
  const Materials materials = rendering::bindMaterials(scene, openMaterials(options, tool));
  const rendering::EffectOverrides overrides = overridesOf(options);
  const rendering::EffectThresholds thresholds{.remainder = options.remainder, .maxReflections = options.reflections};
  const rendering::PathTracer tracer(
      scene, materials,
      rendering::checkedPlan(scene, materials, overrides, thresholds, tool.control("checking the effect plan")),
      size.seed);
  std::optional<rendering::EffectCosts> costs;
  if (options.costs)
    costs = rendering::measureEffectCosts(
        scene, materials, overrides,
        {.width = size.width, .height = size.height, .samples = size.samples, .thresholds = thresholds},
        tool.control("measuring effects"));
  const rendering::EffectCosts* shownCosts = costs ? &*costs : nullptr;
  Json json{{"scene", scene.name},
            {"environment", scene.environment ? Json(scene.environment->name()) : Json(nullptr)},
            {"reflections", tracer.plan().reflections},
            {"remainder", std::isfinite(tracer.plan().remainder) ? Json(tracer.plan().remainder) : Json(nullptr)},
            {"plan", planJson(tracer.plan(), shownCosts)}};
  std::string text, comparison;
  // Before the image is written: an interrupted command leaves none.
  const auto strategies =
      options.strategies ? measureStrategies(tracer, materials, size, tool) : std::vector<rendering::StrategyCost>();
  if (!options.out.empty()) {
    const Rendered rendered = renderPicture(tracer, size, tool);
    if (options.compare)
      reportEverything(rendered,
                       {scene, materials,
                        rendering::planEffects(scene, materials, everythingLike(tracer.plan()), thresholds), size.seed},
                       size, tool, json, comparison);
    writePicture(
        rendered.film.image(), *options.picture, options.out,
        rendering::pictureAttributes(scene, tracer.plan(), joined(options.materials), size.samples, size.seed));
    const rendering::RayCounters& rays = rendered.film.counters;
    const rendering::Fireflies fireflies = rendered.film.fireflies();
    json.update({{"seconds", rendered.seconds},
                 {"samples", size.samples},
                 {"width", size.width},
                 {"height", size.height},
                 {"counters", countersJson(rays)},
                 {"fireflies", {{"brightest", fireflies.brightest}, {"fraction", fireflies.fraction}}},
                 {"out", options.out}});
    text = options.out + ": " + std::to_string(size.width) + " x " + std::to_string(size.height) + ", " +
           number(rendered.seconds) + " s, " + std::to_string(rays.camera) + " camera rays, " +
           std::to_string(rays.shadow) + " shadow rays, " + std::to_string(rays.bounce) + " bounce rays\n" + comparison;
  }
  if (options.strategies) reportStrategies(strategies, json, text);
  if (options.effects || options.costs) text += planText(tracer.plan(), shownCosts);
  print(tool, json, text);
  return 0;
}

}  // namespace

void addRender(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<RenderArguments>();
  CLI::App* command =
      app.add_subcommand("render", "Renders materials in a scene with the effects that the scene needs");
  command
      ->add_option("MATERIAL", options->materials,
                   std::string(materialHelp) + "; several for scenes with several materials")
      ->required();
  command
      ->add_option(
          "--scene", options->scene,
          "Bundled scene (see goniotool scenes), scene file (.json) or mesh (" + io::meshSuffixList() + ") (sphere)")
      ->type_name("NAME|FILE");
  addUpOption(*command, options->up);
  addPictureOptions(*command, options->picture);
  command->add_flag("--effects", options->effects,
                    "Show which effects are simulated, and why; without --out nothing is rendered");
  command->add_flag("--effect-costs", options->costs, "Measure the time and contribution of each effect");
  command->add_flag(
      "--strategy-costs", options->strategies,
      "Measure time and error of sampling the lights, the materials, or both (multiple importance sampling)");
  const CLI::IsMember known(effectIds());
  command->add_option("--on", options->on, "Effects to simulate even if the analysis leaves them out")
      ->delimiter(',')
      ->check(known);
  command->add_option("--off", options->off, "Effects to leave out")->delimiter(',')->check(known);
  command->add_flag("--everything", options->everything, "Simulate all effects, to verify the effect plan");
  command->add_flag("--compare-everything", options->compare,
                    "Render the picture with all effects too, and report its rays, its time and the difference");
  command
      ->add_option("--reflections", options->reflections,
                   "Simulate at most this number of reflections: 1 shows direct light, 2 adds light that was reflected "
                   "twice, and so on (64)")
      ->check(CLI::Range(1, 64));
  command
      ->add_option("--remainder", options->remainder,
                   "Ignore further reflections that together add at most this fraction of the brightest first "
                   "reflection (1/512)")
      ->check(CLI::Range(1e-9, 1.0));
  std::vector<std::string> samplings;
  for (const rendering::SamplingMethod& method : rendering::samplingMethods()) samplings.emplace_back(method.id);
  command
      ->add_option("--sampling", options->sampling,
                   "Density from which directions are sampled for the materials, to compare methods: auto chooses the "
                   "one with the least noise at equal time")
      ->check(CLI::IsMember(samplings));
  command->add_option("--wavelength", options->wavelength, wavelengthHelp)->check(CLI::Range(1.0, 1e6));
  command->add_option("--out", options->out, "Image file to write: .exr (linear) or .png")->group(outputGroup);
  command->callback([options, &tool] { tool.run = [options, &tool] { return render(*options, tool); }; });
}

}  // namespace gonio::tool
