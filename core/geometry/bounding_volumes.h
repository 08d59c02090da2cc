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

/// A binary hierarchy of axis-aligned boxes in flat arrays, for ray queries on a graphics card, where Embree's own are
/// out of reach. CPU queries use MeshIntersector.
struct BoundingVolumes {
  /// What lies in one of a node's two boxes: another node, or a leaf of some primitives.
  struct Child {
    AxisBox box;
    std::uint32_t first = 0;  ///< index of the node, or of the leaf's first entry in `order`
    std::uint32_t count = 0;  ///< of the leaf's primitives; 0: a node
  };
  struct Node {
    Child children[2];
  };

  static constexpr std::uint32_t maxInLeaf = 4;

  std::vector<Node> nodes;           ///< the root first; a parent before its children
  std::vector<std::uint32_t> order;  ///< of the primitives: each once, those of a leaf side by side
  int depth = 0;                     ///< nodes on the longest way from the root to a leaf
};

/// Embree's builder, by the surface area heuristic: about 0.5 s a million primitives, on the calling thread. The same
/// boxes give the same hierarchy. A second child with an empty box (min > max) and no primitives stands beside a lone
/// leaf.
/// @param boxes at least one, finite.
/// @throws Error where Embree has not the memory.
BoundingVolumes buildBoundingVolumes(std::span<const AxisBox> boxes);

}  // namespace gonio
