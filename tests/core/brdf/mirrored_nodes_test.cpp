// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/bake_table.h"

#include <QTest>
#include <algorithm>

#include "tests/support/test_program.h"

namespace mirrored_nodes_test {
using namespace gonio;

/// Depends on the order of the directions, but on no side; counts the pairs.
class CountedBrdf final : public Brdf {
 public:
  explicit CountedBrdf(bool mirrorSymmetric) : mirrorSymmetric_(mirrorSymmetric) {}
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    count += pairs.size();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [wi, wo] = pairs[i];
      values[i] = Rgb(1 + wi.z, 2 + glm::dot(wi, wo), 3 + wi.z * wo.z * wo.z);
    }
  }
  bool isReciprocal() const override { return false; }
  bool isMirrorSymmetric() const override { return mirrorSymmetric_; }

  mutable std::size_t count = 0;

 private:
  bool mirrorSymmetric_;
};

struct Nodes {
  std::vector<std::size_t> indices;
  std::vector<DirectionPair> pairs;
};

/// Every node but some, from the middle of a row on.
Nodes nodesOf(const HalfDifferenceGrid& grid) {
  Nodes nodes;
  for (std::size_t i = 3; i < grid.size(); ++i) {
    if (i % 5 == 0) continue;
    nodes.indices.push_back(i);
    nodes.pairs.push_back(grid.directions(i));
  }
  return nodes;
}

std::vector<Rgb> valuesOf(const Brdf& brdf, const HalfDifferenceGrid& grid, const Nodes& nodes, bool bothOrders) {
  std::vector<Rgb> values(nodes.indices.size());
  evaluateNodes(brdf, grid, nodes.indices, nodes.pairs, values, bothOrders);
  return values;
}

bool areNear(std::span<const Rgb> a, std::span<const Rgb> b) {
  return std::ranges::equal(a, b, [](const Rgb& x, const Rgb& y) { return glm::length(x - y) < 1e-12; });
}

class MirroredNodesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// On the whole circle of phi_d: every value is right, and few more than half of them are computed.
  void mirroredNodesShareTheirValue() {
    for (const int phiDCount : {24, 25}) {
      const HalfDifferenceGrid grid{4, 5, phiDCount, false};
      const Nodes nodes = nodesOf(grid);
      const CountedBrdf symmetric(true), other(false);
      const auto values = valuesOf(symmetric, grid, nodes, false);
      QVERIFY(areNear(values, valuesOf(other, grid, nodes, false)));
      QCOMPARE(other.count, nodes.indices.size());
      QVERIFY(symmetric.count < other.count * 7 / 10);
    }
  }

  /// With phi_d folded to half the circle, the mirrored node has the directions in the other order.
  void foldedGridsExchangeTheDirections() {
    const HalfDifferenceGrid grid{4, 5, 8, true};
    const Nodes nodes = nodesOf(grid);
    const CountedBrdf symmetric(true), other(false);
    QVERIFY(areNear(valuesOf(symmetric, grid, nodes, false), valuesOf(other, grid, nodes, false)));
    QCOMPARE(symmetric.count, nodes.indices.size());
    QVERIFY(!areNear(valuesOf(symmetric, grid, nodes, true), valuesOf(other, grid, nodes, true)));
    // Both orders together do not depend on which of them is first.
    Nodes exchanged = nodes;
    for (DirectionPair& pair : exchanged.pairs) std::swap(pair.wi, pair.wo);
    const auto mean = [&](const Brdf& brdf) {
      std::vector<Rgb> sums = valuesOf(brdf, grid, nodes, true);
      const std::vector<Rgb> others = valuesOf(brdf, grid, exchanged, true);
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += others[i];
      return sums;
    };
    QVERIFY(areNear(mean(symmetric), mean(other)));
  }
};

GONIO_TEST(MirroredNodesTest)
}  // namespace mirrored_nodes_test

#include "mirrored_nodes_test.moc"
