// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "tests/support/test_program.h"
#include "widgets/preview/gl/textures.h"

namespace environment_texels_test {
using namespace gonio;
using namespace gonio::rendering;
using widgets::EnvironmentTexels;

class EnvironmentTexelsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The map contains the radiance and the density of its pixels, the pool draws with that density.
  void texelsAreThoseOfTheEnvironment() {
    const auto environment = skyEnvironment();
    const auto texels = widgets::environmentTexels(environment);
    QCOMPARE(texels->width, environment->image().width);
    for (const auto& [x, y] : {std::pair{0, 0}, {100, 40}, {511, 255}}) {
      const glm::vec4 texel = texels->map[environment->image().index(x, y)];
      QVERIFY(glm::vec3(texel) == environment->image().at(x, y));
      const Direction centre = EnvironmentMap::directionAt((x + 0.5) / texels->width, (y + 0.5) / texels->height);
      QCOMPARE(texel.a, float(environment->pdf(centre)));
    }
    QCOMPARE(texels->poolDirection.size(), std::size_t(EnvironmentTexels::poolSide * EnvironmentTexels::poolSide));
    // The mean of radiance / density over the draws is the integral of the radiance over the sphere.
    double drawn = 0, integral = 0;
    for (std::size_t i = 0; i < texels->poolDirection.size(); ++i)
      drawn += texels->poolRadiance[i].g / texels->poolDirection[i].a / double(texels->poolDirection.size());
    for (int y = 0; y < texels->height; ++y)
      for (int x = 0; x < texels->width; ++x)
        integral += environment->image().at(x, y).g * std::sin(pi * (y + 0.5) / texels->height) *
                    (pi / texels->height) * (2 * pi / texels->width);
    QVERIFY2(std::abs(drawn / integral - 1) < 0.01, qPrintable(QString::number(drawn / integral)));
  }

  /// Computed once while the environment lives.
  void knownTexelsAreHandedOut() {
    auto environment = std::make_shared<const EnvironmentMap>(Image(8, 4), "black");
    const auto texels = widgets::environmentTexels(environment);
    QCOMPARE(widgets::environmentTexels(environment), texels);
    const auto another = std::make_shared<const EnvironmentMap>(Image(8, 4), "black");
    QVERIFY(widgets::environmentTexels(another) != texels);
  }
};

GONIO_TEST(EnvironmentTexelsTest)
}  // namespace environment_texels_test

#include "environment_texels_test.moc"
