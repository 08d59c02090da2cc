// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "core/brdf/neural_brdf.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/editing/edit.h"
#include "core/factorization/pdv_factors.h"
#include "core/rendering/environment.h"
#include "core/rendering/plan_check.h"
#include "tests/support/function_brdf.h"
#include "tests/support/random_scenes.h"

/// Random scenes of materials that plans are hard for, and the comparison of a plan with all effects.
namespace gonio::test {

/// One term of factors, 1e-5 but `value` between two angles of the viewer, rad.
inline std::shared_ptr<const factorization::PdvFactors> raisedFactors(double low, double high, double value) {
  factorization::PdvFactors factors;
  factors.transform = DataTransform::none;
  factors.highest = 1e6;
  factorization::PdvTerm term;
  for (int i = 0; i <= 180; ++i) {
    const double theta = radians(0.5 * i);
    factors.thetaNodes.push_back(theta);
    term.f1.push_back(theta > low && theta < high ? value : 1e-5);
  }
  factors.deviationNodes = {0, 1, 2};
  factors.phiNodes = {0, 1, pi};
  term.f2 = {1, 1, 1};
  term.f3 = {1, 1, 1};
  factors.channels.fill({term});
  return std::make_shared<const factorization::PdvFactors>(factors);
}

/// A table of 1e-5 but `value` where theta_h and theta_d are in these ranges, rad.
inline std::shared_ptr<const Brdf> raisedTable(const HalfDifferenceGrid& grid, const std::array<double, 2>& thetaH,
                                               const std::array<double, 2>& thetaD, double value) {
  std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(1e-5f));
  std::vector<std::uint8_t> valid(grid.size(), 1);
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const HalfDifference at = grid.node(cell);
    if (at.thetaH >= thetaH[0] && at.thetaH <= thetaH[1] && at.thetaD >= thetaD[0] && at.thetaD <= thetaD[1])
      values[cell] = TabulatedBrdf::Value(float(value));
    valid[cell] = grid.nodeAboveHorizon(cell);
  }
  return std::make_shared<const TabulatedBrdf>(grid, values, valid);
}

/// By lobes: the highlight of GGX widened or narrowed by up to 4, with another colour, of a band or of another
/// highlight.
inline std::shared_ptr<const Brdf> randomLobes(std::mt19937_64& random, const HalfDifferenceGrid& grid,
                                               const Rgb& colour) {
  const auto in = [&](double low, double high) { return low + (high - low) * uniform(random); };
  const models::Model& model = models::ggx();
  models::ParameterValues fitted = models::defaultParameters(model.spec());
  fitted.values[*model.spec().find("roughness")] = Rgb(in(0.05, 0.3));
  editing::DifferentialEdit edit = editing::unchangedEdit(model, fitted);
  edit.keepsAlbedo = random() % 2 == 0;
  edit.edited.values[*model.spec().find("roughness")] *= std::pow(4, in(-1, 1));
  if (random() % 2) edit.edited.values[*model.spec().find("specular")] *= colour;
  const double low = in(0, 1.2);
  const std::shared_ptr<const Brdf> base = random() % 2 ? ggx(colour, Rgb(0.8), in(0.05, 0.5), in(0.03, 0.5))
                                                        : raisedTable(grid, {0, 0.2}, {low, low + 0.2}, in(0.1, 10));
  return editing::applyEdits(base, std::vector<editing::Edit>{{.content = edit, .strength = in(0.3, 1)}});
}

/// A model with some parameters in ranges; the others have their defaults.
struct ParameterRange {
  const char* id;
  double low, high;
};
inline std::shared_ptr<const Brdf> randomModel(const char* id, std::initializer_list<ParameterRange> ranges,
                                               std::mt19937_64& random) {
  const models::Model& model = models::findModel(id);
  models::ParameterValues values = models::defaultParameters(model.spec());
  for (const ParameterRange& range : ranges)
    values.values[*model.spec().find(range.id)] = Rgb(range.low * std::pow(range.high / range.low, uniform(random)));
  return model.instantiate(values);
}

/// A network with weights drawn by chance.
inline std::shared_ptr<const Brdf> randomNetwork(double scale, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0, scale);
  std::vector<float> weights(NeuralBrdf::weightCount);
  for (float& weight : weights) weight = float(normal(random));
  return std::make_shared<const NeuralBrdf>(weights);
}

inline std::shared_ptr<const Brdf> randomPlanMaterial(std::mt19937_64& random) {
  const auto in = [&](double low, double high) { return low + (high - low) * uniform(random); };
  const HalfDifferenceGrid grid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 12};
  const Rgb colour(in(0, 0.8), in(0, 0.8), in(0, 0.8));
  switch (random() % 12) {
    case 0:
      return ggx(Rgb(0), Rgb(1), std::pow(10, in(-2.7, -1)), in(0.3, 1));  // a mirror, more or less
    case 1:
      return ggx(Rgb(0), Rgb(0), 0.2, 0.5);  // black
    case 2: {
      const double low = in(0, 1.4);
      return factorization::makePdvBrdf(*raisedFactors(low, low + in(0.02, 0.1), in(0.1, 0.5)));
    }
    case 3: {  // retroreflection
      const double low = in(0, 1.2);
      return raisedTable(grid, {low, low + in(0.05, 0.2)}, {0, in(0.03, 0.1)}, std::pow(10, in(0, 2)));
    }
    case 4: {  // a band about the half vector, at some difference angles
      const double low = in(0, 1.2);
      return raisedTable(grid, {0, in(0.02, 0.2)}, {low, low + in(0.04, 0.2)}, std::pow(10, in(-1, 1)));
    }
    case 5: {
      const models::Model& model = models::ggx();
      editing::DifferentialEdit edit = editing::unchangedEdit(model, models::defaultParameters(model.spec()));
      edit.composition = random() % 2 ? editing::Composition::additive : editing::Composition::logPlus;
      edit.edited.values[*model.spec().find("diffuse")] = colour;
      edit.edited.values[*model.spec().find("roughness")] = Rgb(in(0.05, 0.6));
      const double low = in(0, 1.4);
      const std::vector<editing::Edit> edits{
          {.content = edit, .strength = in(0.2, 1)},
          {.content = editing::FactorEdit{raisedFactors(0, 0.01, 1e-5), raisedFactors(low, low + 0.07, 0.3), true}}};
      return editing::applyEdits(ggx(Rgb(0.2), Rgb(1), 0.3, 0.04), edits);
    }
    case 6:
      return models::findModel("lambert").instantiate({{colour}});
    case 7:
    case 8:
      return randomLobes(random, grid, colour);
    case 9:
      return randomNetwork(in(0.1, 0.25), random);
    case 10:
      return random() % 2 ? randomModel("he", {{"roughness", 0.02, 1}, {"correlation-length", 1, 20}}, random)
                          : randomModel("layered",
                                        {{"sheen", 0.05, 0.3},
                                         {"sheen-lobe", 1, 1},
                                         {"retro", 0.05, 0.3},
                                         {"retro-lobe", 1, 1},
                                         {"retro-roughness", 0.1, 0.5},
                                         {"coat-roughness", 0.02, 0.2}},
                                        random);
    default:
      return ggx(colour, Rgb(in(0, 1)), in(0.05, 0.7), in(0.02, 0.5));
  }
}

struct RandomPlan {
  rendering::Scene scene;
  rendering::RenderMaterials materials;  ///< of bindMaterials()
};

/// One to four shapes about the origin, some hidden from the camera, and one to three lights of any kind.
inline RandomPlan randomPlan(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto in = [&](double low, double high) { return low + (high - low) * uniform(random); };
  RandomPlan plan;
  plan.scene.camera = {.yaw = in(-pi, pi), .pitch = in(-1, 1), .distance = 6};
  const int objects = 1 + int(random() % 4);
  for (int i = 0; i < objects; ++i) {
    rendering::SceneObject object{.name = "object " + std::to_string(i), .material = rendering::MaterialSlot{i}};
    const Direction centre = i == 0 ? Direction(0) : in(0.8, 2.5) * randomDirection(random);
    switch (random() % 4) {
      case 0:
        object.shape = meshShape(geometry::torusMesh());
        break;
      case 1: {
        // A wall of any size, turned toward the first object.
        const Direction normal = glm::normalize(-centre + in(0, 0.5) * randomDirection(random) + Direction(0, 1e-3, 0));
        const Direction u = glm::normalize(glm::cross(normal, randomDirection(random)));
        object.shape = rendering::Rectangle{1.5 * centre, in(0.5, 4) * u, in(0.5, 4) * glm::cross(normal, u)};
        break;
      }
      default:
        object.shape = rendering::Sphere{centre, in(0.3, 1)};
    }
    plan.scene.objects.push_back(object);
  }
  const int lights = 1 + int(random() % 3);
  for (int i = 0; i < lights; ++i) switch (random() % 4) {
      case 0:
        plan.scene.directionalLights.push_back({randomDirection(random), Rgb(in(0.5, 3))});
        break;
      case 1:
        plan.scene.pointLights.push_back({in(3, 6) * randomDirection(random), Rgb(in(5, 30))});
        break;
      case 2: {
        const Direction centre = in(2.5, 5) * randomDirection(random), inward = -glm::normalize(centre);
        const Direction u = glm::normalize(glm::cross(inward, randomDirection(random)));
        plan.scene.objects.push_back(
            {.name = "lamp",
             .shape = rendering::Rectangle{centre, in(0.2, 1) * u, in(0.2, 1) * glm::cross(inward, u)},
             .radiance = Rgb(in(2, 10))});
        break;
      }
      default:
        plan.scene.environment = rendering::studioEnvironment();
    }
  rendering::RenderMaterials slots;
  for (int i = 0; i < objects; ++i)
    slots.push_back(std::make_shared<const rendering::RenderMaterial>(randomPlanMaterial(random)));
  plan.materials = rendering::bindMaterials(plan.scene, slots);
  return plan;
}

/// The pictures of a plan and of all effects, with the same random numbers, by blocks of 8 x 8 pixels.
struct PlanComparison {
  /// Of the block that is farthest beyond the stated remainder: the difference, what the plan states, the standard
  /// error of the difference; and the mean of the picture with all effects, with its standard error.
  double difference = 0, stated = 0, standardError = 0, mean = 0, meanError = 0;
  std::uint64_t rays = 0, raysOfAll = 0;  ///< bounce rays
  bool agrees() const { return std::abs(difference) <= stated + 4 * standardError; }
};

inline PlanComparison comparePlan(const RandomPlan& random, int side, int samples, std::uint64_t seed,
                                  const rendering::EffectPlan& plan) {
  const auto render = [&](const rendering::EffectPlan& one) {
    rendering::Film film(side, side);
    rendering::PathTracer(random.scene, random.materials, one, seed).accumulate(film, samples);
    return film;
  };
  // With the frames of the plan: otherwise the random directions differ.
  rendering::EffectOverrides every = rendering::everyEffect();
  every[std::size_t(rendering::Effect::anisotropicFrames)] = plan.simulates(rendering::Effect::anisotropicFrames);
  const rendering::Film planned = render(plan),
                        all = render(rendering::planEffects(random.scene, random.materials, every));
  PlanComparison result{.rays = planned.counters.bounce, .raysOfAll = all.counters.bounce};
  double brightest = 0, squares = 0;
  for (const Rgb& sum : all.radiance) {
    const double value = maxChannel(sum) / samples;
    brightest = std::max(brightest, value);
    result.mean += value / double(all.radiance.size());
    squares += value * value / double(all.radiance.size());
  }
  result.meanError = std::sqrt(std::max(0.0, squares - result.mean * result.mean) / double(all.radiance.size()));
  result.stated = std::isfinite(plan.remainder) ? plan.remainder * brightest : 0;
  constexpr int block = 8;
  double worst = -1;
  for (int y = 0; y < side; y += block)
    for (int x = 0; x < side; x += block)
      for (int channel = 0; channel < 3; ++channel) {
        double sum = 0, square = 0;
        for (int i = 0; i < block * block; ++i) {
          const auto pixel = std::size_t((y + i / block) * side + x + i % block);
          const double one = (all.radiance[pixel][channel] - planned.radiance[pixel][channel]) / samples;
          sum += one / (block * block);
          square += one * one / (block * block);
        }
        const double error = std::sqrt(std::max(0.0, square - sum * sum) / (block * block - 1));
        const double beyond = (std::abs(sum) - result.stated) / (error + 1e-5 * result.mean + 1e-12);
        if (!(beyond > worst)) continue;
        worst = beyond;
        result.difference = sum;
        // Paths that add less of the mean are rarer than the samples resolve.
        result.standardError = error + 1e-5 * result.mean + 1e-12;
      }
  return result;
}

}  // namespace gonio::test
