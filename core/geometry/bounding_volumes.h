// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/math/types.h"

namespace gonio {

struct AxisBox {
  glm::vec3 min, max;
};

/// A binary hierarchy of axis-aligned boxes in flat arrays, for ray queries on the GPU. CPU queries use
/// MeshIntersector.
struct BoundingVolumes {
  /// The content of one of a node's two boxes: another node, or a leaf with primitives.
  struct Child {
    AxisBox box;
    std::uint32_t first = 0;  ///< index of the node, or of the leaf's first entry in `order`
    std::uint32_t count = 0;  ///< number of primitives of the leaf; 0: a node, or nothing if box.min > box.max
  };
  struct Node {
    Child children[2];
  };

  static constexpr std::uint32_t maxInLeaf = 4;

  std::vector<Node> nodes;           ///< the root first; parents before their children
  std::vector<std::uint32_t> order;  ///< indices of the primitives: each once, those of a leaf are consecutive
  int depth = 0;                     ///< number of nodes on the longest path from the root to a leaf
};

/// Builds a hierarchy with Embree's builder, by the surface area heuristic: about 0.5 s per million primitives, on the
/// calling thread. Deterministic. If there is only one leaf, the root's second child is empty: its box has min > max,
/// and it has no primitives.
/// @param boxes at least one, finite.
/// @throws Error if Embree runs out of memory.
BoundingVolumes buildBoundingVolumes(std::span<const AxisBox> boxes);

}  // namespace gonio
