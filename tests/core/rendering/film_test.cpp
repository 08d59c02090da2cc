// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/film.h"

#include <QTest>
#include <cmath>
#include <random>

#include "tests/support/test_program.h"

namespace film_test {
using namespace gonio;
using namespace gonio::rendering;

class FilmTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void picturesAreMeans() {
    Film film(2, 1);
    QVERIFY(film.image().pixels[0] == glm::vec3(0) && film.image().alpha[0] == 0);
    film.samples = 4;
    film.radiance = {Rgb(2, 4, 8), Rgb(0)};
    film.coverage = {4, 1};
    const Image image = film.image();
    QVERIFY(image.pixels[0] == glm::vec3(0.5f, 1, 2) && image.pixels[1] == glm::vec3(0));
    QVERIFY(image.alpha[0] == 1 && image.alpha[1] == 0.25f);
  }

  /// Sums from a threshold on against plain ones, each sample within a 16th; the order does not count.
  void luminancesAreCounted() {
    std::mt19937_64 random(1);
    std::lognormal_distribution<double> drawn(0, 4);
    SampleLuminances all, first, second;
    std::vector<double> values;
    for (int i = 0; i < 20000; ++i) {
      values.push_back(drawn(random));
      all.add(values.back());
      (i % 3 ? first : second).add(values.back());
    }
    second += first;
    QCOMPARE(all.largest(), *std::ranges::max_element(values));
    QCOMPARE(second.largest(), all.largest());
    for (const double threshold : {0.0, 0.1, 1.0, 50.0, 1e4}) {
      double least = 0, most = 0;
      for (const double value : values) {
        least += value >= threshold * 17 / 16 ? value : 0;
        most += value >= threshold * 16 / 17 ? value : 0;
      }
      QVERIFY(all.sumFrom(threshold) > least * 16 / 17 && all.sumFrom(threshold) < most * 17 / 16);
      QCOMPARE(second.sumFrom(threshold), all.sumFrom(threshold));
    }
  }

  void numbersOfAnySize() {
    SampleLuminances extreme;
    for (const double value : {0.0, -1.0, 1e-300, 1e300, std::nan("")}) extreme.add(value);
    QCOMPARE(extreme.largest(), 1e300);
    QVERIFY(std::isfinite(extreme.sumFrom(0)));
  }

  /// 999 samples of 1 and one of 9001: the mean is 10, so one is 900 means and nine tenths of all light.
  void aFirefly() {
    Film film(10, 10);
    film.samples = 10;
    for (std::size_t i = 0; i < 100; ++i) {
      film.radiance[i] = Rgb(i == 37 ? 9010 : 10);
      film.coverage[i] = 10;
    }
    for (int i = 0; i < 999; ++i) film.luminances.add(1);
    film.luminances.add(9001);
    const Fireflies found = film.fireflies();
    QVERIFY(std::abs(found.brightest - 900.1) < 1e-6);
    QVERIFY(std::abs(found.fraction - 0.9001) < 0.07);
    QVERIFY(Film(4, 4).fireflies().brightest == 0 && Film().fireflies().fraction == 0);
  }
};

GONIO_TEST(FilmTest)
}  // namespace film_test

#include "film_test.moc"
