// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/light_sampling.h"
#include "core/rendering/path_samples.h"
#include "core/rendering/path_tracer.h"
#include "core/rendering/recorded_paths.h"
#include "core/rendering/shading_frame.h"

namespace gonio {

/// Traces many camera paths together, step by step, so that the BRDF values of a material are evaluated in one call.
/// Results of a path do not depend on the other paths of the batch.
class PathTracer::PathBatch {
 public:
  /// Large enough for the batches of a BRDF, small enough for the cache.
  static constexpr std::size_t capacity = 128;

  struct Start {
    std::size_t pixel;
    PathSeed seed;
    Ray ray;
  };
  struct Result {
    Rgb radiance{0};       ///< along the camera ray
    bool covered = false;  ///< whether the ray hits anything visible
    Direction normal{0};   ///< shading normal at the first hit of a reflecting surface
  };

  /// @param recorded the light that surfaces reflect is added here (RecordedPaths); null: it is added to the results.
  PathBatch(const PathTracer& tracer, RayCounters& counters, RecordedPaths::Row* recorded)
      : tracer_(tracer),
        counters_(counters),
        recorded_(recorded),
        lights_(tracer.scene_),
        queries_(tracer.brdfs_.size()) {}

  /// One result per start, valid until the next call.
  std::span<const Result> trace(std::span<const Start> starts);

 private:
  /// A path at its last hit.
  struct Path {
    Path() {}  // without it members would be set to 0 first

    std::size_t result, object;
    PathSeed seed;
    Rgb throughput{1};
    ShadingFrame frame;
    Direction position, geometricNormal;
    Direction wo;            ///< local; below the horizon on the back of a surface
    Direction origin;        ///< of rays that leave the surface, if the object sends any
    DirectionSample sample;  ///< from the material, local; pdf 0 if there is none
    Direction toward;        ///< the sample in world coordinates
    std::size_t query;       ///< index of the sample in the queries of the path's material
  };
  /// A light sample that waits for its BRDF value.
  struct LightQuery {
    std::size_t path, light, query;
    Rgb weight;  ///< factor of the BRDF value, without the throughput
    Direction toLight;
    double distance;
  };
  /// BRDF values of one material that are evaluated together.
  struct BrdfQueries {
    std::vector<DirectionPair> pairs;
    std::vector<Rgb> values;

    std::size_t add(const Direction& wi, const Direction& wo) {
      DirectionPair& pair = pairs.emplace_back();
      pair.wi = wi;
      pair.wo = wo;
      return pairs.size() - 1;
    }
  };

  const std::vector<SceneObject>& objects() const { return tracer_.scene_.objects; }
  BrdfQueries& queriesOf(const Path& path) { return queries_[tracer_.brdfOf_[path.object]]; }
  bool goesOn(const Path& path, int reflection) const;

  void enter(const Start& start, std::size_t result);
  void addSurface(Path& path, std::size_t object, const Ray& ray, double distance) const;
  void sampleLights(int reflection);
  void sampleLight(std::size_t light, Path& path, const glm::dvec2& u);
  void sampleMaterials(int reflection);
  void evaluateQueries();
  void addSampledLights();
  /// Adds `radiance` times the value of a query. @param query index in the queries of the path's material.
  void addRadiance(const Path& path, std::size_t query, const Rgb& radiance);
  bool isBlocked(const LightQuery& query, const Path& path);
  /// Adds the light that the sampled directions hit, moves continuing paths to their next surface, and removes the
  /// others.
  void follow(int reflection);
  bool followOne(Path& path, int reflection, PathSamples& survival);
  Rgb foundLights(const Path& path) const;

  const PathTracer& tracer_;
  RayCounters& counters_;
  RecordedPaths::Row* recorded_;
  LightSampler lights_;
  std::span<const Start> starts_;
  std::vector<Result> results_;
  std::vector<Path> paths_;
  std::vector<LightQuery> lightQueries_;
  std::vector<BrdfQueries> queries_;  ///< of each of the tracer's BRDFs
  /// Distances of the candidates of a path's object along its sampled direction.
  std::vector<double> distances_;
};

}  // namespace gonio
