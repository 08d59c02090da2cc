// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/math/sampling.h"
#include "core/math/types.h"
#include "core/rendering/film.h"
#include "core/rendering/path_tracer.h"
#include "core/rendering/scene_light.h"
#include "core/rendering/shape.h"

namespace gonio::rendering {

/// Identifies the sample points of a path: its pixel and the index of its sample.
struct PathSeed {
  std::uint32_t pixel, sample;
};

/// Sample points for one purpose (Dimension) at one reflection: an independent set per pixel. The set-up is cached for
/// consecutive paths of a pixel. The position in the pixel belongs to the points of the first reflected direction: what
/// a mirror shows depends on both together.
class PathSamples {
 public:
  enum Dimension : std::uint32_t { reflectedDirection, survival, firstLight };

  /// @param reflection 0 at the camera.
  PathSamples(int reflection, std::uint32_t dimension)
      : dimension_(std::uint32_t(reflection) * dimensionsPerBounce + dimension), pixel_(0), points_(seedOf(0)) {}

  glm::dvec2 pair(const PathSeed& path) { return pointsOf(path.pixel)[path.sample]; }
  glm::dvec2 filmPosition(const PathSeed& path) { return pointsOf(path.pixel).fourthAndFifth(path.sample); }
  glm::dvec3 triple(const PathSeed& path) { return pointsOf(path.pixel).triple(path.sample); }
  double number(const PathSeed& path) { return pointsOf(path.pixel).first(path.sample); }

 private:
  static constexpr std::uint32_t dimensionsPerBounce = 1024;

  std::uint32_t seedOf(std::uint32_t pixel) const { return hashCombine(pixel, dimension_); }
  const SobolPoints& pointsOf(std::uint32_t pixel) {
    if (pixel != pixel_) points_ = SobolPoints(seedOf(pixel_ = pixel));
    return points_;
  }

  std::uint32_t dimension_, pixel_;
  SobolPoints points_;
};

/// A sampled direction from a point toward a light. Values do not include the cosine.
struct LightSample {
  Direction toLight{0};  ///< world, unit
  double distance = 0;   ///< infinite for distant light; 0 if the sample failed
  Rgb radiance{0};       ///< for a light without size: irradiance perpendicular to the direction
  double density = 0;    ///< 1/sr; 0 for a light without size
};

/// Whether a light subtends a solid angle, so that directions sampled from a material can hit it.
bool hasSize(const SceneLight& light);

/// Samples the lights of a scene, which must outlive this object.
class LightSampler {
 public:
  explicit LightSampler(const Scene& scene);

  /// Samples a light. The radiance is 0 if the sample is below the horizon of the surface, by its geometric normal.
  /// @param u two numbers in [0, 1); not used for lights without size.
  LightSample sample(const SceneLight& light, const Direction& position, const Direction& normal,
                     const glm::dvec2& u) const;
  /// Radiance of a light in a direction that hits it, and density of that direction.
  struct Found {
    Rgb radiance{0};
    double density = 0;  ///< of sample(), 1/sr
  };
  /// Radiance of a light with size, and density of sample() for a surface with this normal, for a direction (world)
  /// that hits it at a distance; both are 0 on the back of an area light.
  Found evalLight(const SceneLight& light, const Direction& normal, const Direction& toward, double distance) const;
  /// Radiance of the visible environment in a world direction. Precondition: the scene shows it.
  Rgb background(const Direction& toward) const;

 private:
  const Scene& scene_;
  EnvironmentRotation rotation_;
  std::shared_ptr<const EnvironmentMap> background_;  ///< null if the scene does not show it
};

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
  /// Direct light that an object reflects, summed over the hits of paths.
  struct DirectLight {
    double sum = 0;
    int hits = 0;
  };

  /// @param brightness by which paths are weighed before they are followed (survives()); must outlive this object. With
  /// a typical radiance of 0 all are followed, up to the fourth reflection.
  /// @param direct empty, or one per object: receives the direct light.
  PathBatch(const PathTracer& tracer, RayCounters& counters, RecordedPaths::Row* recorded, const Brightness& brightness,
            std::span<DirectLight> direct = {})
      : tracer_(tracer),
        counters_(counters),
        recorded_(recorded),
        brightness_(brightness),
        direct_(direct),
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
  void observe(const Path& path, const Rgb& radiance) {
    if (!direct_.empty()) direct_[path.object].sum += maxChannel(glm::abs(radiance));
  }
  /// Adds the light that the sampled directions hit, moves continuing paths to their next surface, and removes the
  /// others.
  void follow(int reflection);
  bool followOne(Path& path, int reflection, PathSamples& survival);
  /// Ends paths by chance that can add little (Russian roulette), before any ray is traced for them; weighs up those
  /// that go on. @param found radiance of the lights in the sampled direction, if nothing occludes them.
  bool survives(Path& path, const Rgb& found, bool continues, PathSamples& survival) const;
  bool survivesLongPath(Path& path, int reflection, PathSamples& survival) const;
  /// Sets `distances_` to those of the lamps or of all other candidates. Returns whether one of the others is met.
  bool meet(const Ray& ray, std::span<const std::size_t> candidates, bool lamps);
  Rgb foundLights(const Path& path) const;

  const PathTracer& tracer_;
  RayCounters& counters_;
  RecordedPaths::Row* recorded_;
  const Brightness& brightness_;
  std::span<DirectLight> direct_;
  LightSampler lights_;
  std::span<const Start> starts_;
  std::vector<Result> results_;
  std::vector<Path> paths_;
  std::vector<LightQuery> lightQueries_;
  std::vector<BrdfQueries> queries_;  ///< of each of the tracer's BRDFs
  /// Distances of the candidates of a path's object along its sampled direction.
  std::vector<double> distances_;
};

}  // namespace gonio::rendering
