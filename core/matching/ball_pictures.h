// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <list>
#include <memory>
#include <vector>

#include "core/editing/edit.h"
#include "core/matching/reference_cells.h"
#include "core/rendering/scene.h"
#include "core/sampling/tabulated_density.h"
#include "core/support/task_control.h"

namespace gonio::matching {

/// A material with edits, one of which has the controls that are varied.
struct MatchedMaterial {
  std::shared_ptr<const Brdf> base;
  editing::EditList edits;
  std::size_t index = 0;  ///< of a DifferentialEdit with an effect on its material: enabled, its strength not 0

  const editing::DifferentialEdit& edit() const { return std::get<editing::DifferentialEdit>(edits[index].content); }
  /// The material with other controls.
  std::shared_ptr<const Brdf> with(const models::ParameterValues& controls) const;
};

/// The ball of a scene: its first sphere with a material slot, or else the unit sphere at the origin.
rendering::Sphere ballOf(const rendering::Scene& scene);

/// The lights of a scene on its ball, and a camera that is turned as the scene's.
struct BallView {
  rendering::Scene scene;
  double margin = 1;  ///< half side of the picture, relative to the radius of the ball's outline
};
/// @throws Error if the scene has no light.
BallView ballView(const rendering::Scene& scene);

/// Pairs of pictures of the ball with different controls of one edit. The two have independent noise; noise and paths
/// are equal for all controls, so that the pictures change smoothly with them (RecordedPaths). One thread at a time may
/// call render(), which uses all cores.
class BallPictures {
 public:
  /// @param cells the pixels of the pictures; those that are not used remain 0. @param samples paths per pixel of each
  /// picture. @param density of the sampled directions. @throws Cancelled.
  BallPictures(MatchedMaterial material, const BallView& view, const ReferenceCells& cells, int samples,
               const std::shared_ptr<const TabulatedDensity>& density, const TaskControl& control);

  /// The radiance of each cell in both pictures. Controls that act on values (editing::actsOnValues()) are applied to
  /// the values of the last pictures, if no edit follows that of the controls. @throws Cancelled.
  std::array<std::vector<Rgb>, 2> render(const models::ParameterValues& controls, const TaskControl& control);

 private:
  /// BRDF values of all paths.
  struct Values {
    models::ParameterValues controls;
    std::vector<Rgb> values;
  };
  const std::vector<Rgb>& valuesOf(const models::ParameterValues& controls, const TaskControl& control);

  MatchedMaterial material_;
  bool isLast_;  ///< whether no edit follows
  std::vector<DirectionPair> pairs_;
  std::vector<Rgb> weights_;
  std::vector<std::size_t> first_;  ///< [picture * cells + cell]: its first path; one more at the end
  std::list<Values> values_;        ///< of the last pictures, newest first
};

}  // namespace gonio::matching
