// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/mesh_intersector.h"

#include <QTest>
#include <algorithm>

#include "tests/support/simple_meshes.h"
#include "tests/support/test_program.h"

namespace bounding_volumes_test {
using namespace gonio;
using namespace gonio::geometry;

std::vector<AxisBox> boxesOf(const TriangleMesh& mesh) {
  std::vector<AxisBox> boxes;
  for (const TriangleIndices& t : mesh.triangles()) {
    const glm::vec3 a = mesh.positions()[t[0]], b = mesh.positions()[t[1]], c = mesh.positions()[t[2]];
    boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
  }
  return boxes;
}

bool contains(const AxisBox& outer, const AxisBox& inner) {
  for (int i = 0; i < 3; ++i)
    if (!(outer.min[i] <= inner.min[i] && inner.max[i] <= outer.max[i])) return false;
  return true;
}

/// Checks everything below a node, whose own box is `outer`, and counts how often each primitive is met.
/// @returns the longest way down, in nodes; -1 where something is wrong.
int checkNode(const BoundingVolumes& volumes, std::uint32_t node, const AxisBox* outer,
              const std::vector<AxisBox>& boxes, std::vector<int>& met) {
  int below = 0;
  for (const BoundingVolumes::Child& child : volumes.nodes[node].children) {
    if (child.count == 0 && child.first == 0) continue;
    if (outer && !contains(*outer, child.box)) return -1;
    if (child.count > BoundingVolumes::maxInLeaf) return -1;
    for (std::uint32_t i = 0; i < child.count; ++i) {
      const std::uint32_t primitive = volumes.order[child.first + i];
      ++met[primitive];
      if (!contains(child.box, boxes[primitive])) return -1;
    }
    if (child.count > 0) continue;
    const int depth = child.first > node ? checkNode(volumes, child.first, &child.box, boxes, met) : -1;
    if (depth < 0) return -1;
    below = std::max(below, depth);
  }
  return below + 1;
}

class BoundingVolumesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Every primitive once, inside the box of its leaf, which is inside those of its ancestors.
  void holdEverything() {
    for (const char* name : {"shader-ball", "cloth", "torus"}) {
      const std::vector<AxisBox> boxes = boxesOf(*bundledMesh(name));
      const BoundingVolumes volumes = buildBoundingVolumes(boxes);
      std::vector<int> met(boxes.size(), 0);
      QCOMPARE(checkNode(volumes, 0, nullptr, boxes, met), volumes.depth);
      QVERIFY(std::ranges::all_of(met, [](int count) { return count == 1; }));
      // A ray that meets one triangle visits few nodes: a balanced tree of leaves of 4 has this depth twice at most.
      QVERIFY2(volumes.depth <= 2 * std::log2(double(boxes.size())), name);
    }
  }

  void fewAndEqualBoxes() {
    for (const std::size_t count : {1u, 2u, 4u, 5u, 1000u}) {
      const std::vector<AxisBox> boxes(count, {glm::vec3(0), glm::vec3(1, 2, 0)});
      const BoundingVolumes volumes = buildBoundingVolumes(boxes);
      std::vector<int> met(count, 0);
      QCOMPARE(checkNode(volumes, 0, nullptr, boxes, met), volumes.depth);
      QVERIFY(std::ranges::all_of(met, [](int times) { return times == 1; }));
    }
  }

  void theSameEachTime() {
    const std::vector<AxisBox> boxes = boxesOf(*bundledMesh("shader-ball"));
    const BoundingVolumes first = buildBoundingVolumes(boxes), second = buildBoundingVolumes(boxes);
    QVERIFY(first.order == second.order && first.nodes.size() == second.nodes.size());
  }
};

GONIO_TEST(BoundingVolumesTest)
}  // namespace bounding_volumes_test

#include "bounding_volumes_test.moc"
