// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/editing/edit.h"
#include "core/fitting/fit.h"
#include "core/materials/bundled_library.h"
#include "core/models/registry.h"
#include "core/rendering/render_picture.h"
#include "tests/support/test_program.h"

namespace edit_noise_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::editing;

/// Root mean square difference of two renderings with noise of their own, relative to the picture, over the sphere.
double relativeNoise(const Brdf& brdf) {
  const auto material = pictureMaterial(brdf, {});
  const auto picture = [&](std::uint64_t seed) {
    return renderPicture(material, comparisonScene(), {.width = 64, .height = 64, .samples = 16, .seed = seed});
  };
  const Image a = picture(1), b = picture(2);
  double noise = 0, signal = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (!a.alpha.empty() && a.alpha[i] < 1) continue;  // at the rim the noise is that of the silhouette
    const Rgb one(a.pixels[i]), other(b.pixels[i]);
    noise += glm::dot(one - other, one - other) / 2;
    signal += glm::dot(one, other);
  }
  return std::sqrt(noise / signal);
}

class EditNoiseTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Edits are sampled by their own values: at equal samples no edit has more than 1.1 times the noise of a measurement
  /// with these values, a table with a density of its own.
  void anEditConvergesAsItsMaterial() {
    for (const char* path : {"library:merl-copy/alum-bronze", "library:merl-copy/blue-metallic-paint",
                             "library:merl-copy/red-fabric", "library:rgl/satin_purple"}) {
      const auto base = materials::readLibraryMaterial(path).brdf;
      const auto table = bakeTable(*base, {.thetaHCount = 45, .thetaDCount = 30, .phiDCount = 60});
      for (const models::Model* model : {&models::ggx(), &models::layered()}) {
        DifferentialEdit change;
        change.model = model;
        change.fitted = change.edited = fitting::fit(*table, *model).parameters;
        change.composition = defaultComposition(*model);
        for (const double factor : {0.5, 2.0}) {
          change.controls.values[std::size_t(ArtistControl::roughness)] = Rgb(factor);
          const Edit edit{change};
          const auto edited = applyEdits(base, std::span(&edit, 1));
          const double found = relativeNoise(*edited), measured = relativeNoise(*bakeTable(*edited, {}));
          qInfo("%s by %s, %g times: %.4f, as a table %.4f: %.2f", path, model->spec().id.data(), factor, found,
                measured, found / measured);
          QVERIFY2(found < 1.1 * measured, path);
        }
      }
    }
  }
};

GONIO_TEST(EditNoiseTest)
}  // namespace edit_noise_test

#include "edit_noise_test.moc"
