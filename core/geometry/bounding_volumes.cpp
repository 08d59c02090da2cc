// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/bounding_volumes.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cassert>
#include <deque>
#include <limits>
#include <memory>

#include "core/geometry/embree_device.h"

namespace gonio {

namespace {

/// A node or a leaf while Embree builds.
struct Built {
  Built* children[2] = {nullptr, nullptr};
  AxisBox boxes[2] = {};
  std::vector<std::uint32_t> primitives;  ///< of a leaf

  bool isLeaf() const { return !primitives.empty(); }
};
using BuiltTree = std::deque<Built>;

AxisBox boxOf(const RTCBounds& bounds) {
  return {{bounds.lower_x, bounds.lower_y, bounds.lower_z}, {bounds.upper_x, bounds.upper_y, bounds.upper_z}};
}

AxisBox emptyBox() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  return {glm::vec3(infinity), glm::vec3(-infinity)};
}

void* createNode(RTCThreadLocalAllocator, unsigned int, void* tree) {
  return &static_cast<BuiltTree*>(tree)->emplace_back();
}

void setChildren(void* node, void** children, unsigned int count, void*) {
  for (unsigned int i = 0; i < count; ++i) static_cast<Built*>(node)->children[i] = static_cast<Built*>(children[i]);
}

void setBounds(void* node, const RTCBounds** bounds, unsigned int count, void*) {
  for (unsigned int i = 0; i < count; ++i) static_cast<Built*>(node)->boxes[i] = boxOf(*bounds[i]);
}

void* createLeaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* primitives, std::size_t count, void* tree) {
  Built& leaf = static_cast<BuiltTree*>(tree)->emplace_back();
  for (std::size_t i = 0; i < count; ++i) leaf.primitives.push_back(primitives[i].primID);
  return &leaf;
}

/// Embree's tree of the primitives; the nodes live in `tree`.
const Built& build(std::vector<RTCBuildPrimitive>& primitives, BuiltTree& tree) {
  const std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> volumes(rtcNewBVH(embreeDevice()), rtcReleaseBVH);
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.maxLeafSize = BoundingVolumes::maxInLeaf;
  arguments.bvh = volumes.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = createNode;
  arguments.setNodeChildren = setChildren;
  arguments.setNodeBounds = setBounds;
  arguments.createLeaf = createLeaf;
  arguments.userPtr = &tree;
  void* root = nullptr;
  tbb::task_arena alone(1);
  alone.execute([&] { root = rtcBuildBVH(&arguments); });
  throwIfEmbreeFailed();
  assert(root);
  return *static_cast<const Built*>(root);
}

class Flattening {
 public:
  explicit Flattening(BoundingVolumes& volumes) : volumes_(volumes) {}

  BoundingVolumes::Child child(const Built& built, const AxisBox& box, int depth) {
    if (built.isLeaf()) {
      const auto first = std::uint32_t(volumes_.order.size());
      volumes_.order.insert(volumes_.order.end(), built.primitives.begin(), built.primitives.end());
      return {box, first, std::uint32_t(built.primitives.size())};
    }
    const std::size_t index = volumes_.nodes.size();
    volumes_.nodes.emplace_back();
    volumes_.depth = std::max(volumes_.depth, depth);
    for (int i = 0; i < 2; ++i) {
      const BoundingVolumes::Child found = child(*built.children[i], built.boxes[i], depth + 1);
      volumes_.nodes[index].children[i] = found;
    }
    return {box, std::uint32_t(index), 0};
  }

 private:
  BoundingVolumes& volumes_;
};

}  // namespace

BoundingVolumes buildBoundingVolumes(std::span<const AxisBox> boxes) {
  assert(!boxes.empty());
  std::vector<RTCBuildPrimitive> primitives;
  primitives.reserve(boxes.size());
  AxisBox whole = emptyBox();
  for (const AxisBox& box : boxes) {
    primitives.push_back(
        {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, unsigned(primitives.size())});
    whole = {glm::min(whole.min, box.min), glm::max(whole.max, box.max)};
  }
  BuiltTree tree;
  const Built& root = build(primitives, tree);
  BoundingVolumes volumes;
  volumes.order.reserve(boxes.size());
  const BoundingVolumes::Child top = Flattening(volumes).child(root, whole, 1);
  if (volumes.nodes.empty()) {
    volumes.nodes.push_back({{top, {emptyBox(), 0, 0}}});
    volumes.depth = 1;
  }
  return volumes;
}

}  // namespace gonio
