// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/support/published_fits.h"

#include <QFileInfo>
#include <QTest>
#include <cstdlib>
#include <map>

#include "core/fitting/fit_data.h"
#include "core/materials/material.h"
#include "tests/support/test_program.h"

namespace published_fits_test {
using namespace gonio;
using namespace gonio::fitting;

const QString shared = GONIO_SHARED_DIR;
const QString folder = QString(GONIO_TEST_OUTPUT_DIR) + "/near-measured";
constexpr double nganAngle = 80;  ///< deg; Ngan et al. leave out what is more grazing

const QStringList names{"alum-bronze", "red-fabric"};

/// A part of published_fits_study (tests/studies), which compares all materials and sets.
class PublishedFitsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    if (!QFileInfo::exists(shared + "/tools/make-merl")) QSKIP("the shared data are not there");
    bool isMade = true;
    for (const QString& name : names) isMade = isMade && QFileInfo::exists(folder + "/" + name + ".binary");
    // Not by QProcess, whose vfork() ends programs that have the thread sanitizer.
    const QString command = "'" + shared + "/tools/make-merl' '" + folder + "' merl " + names.join(' ');
    if (!isMade) QCOMPARE(std::system(qPrintable(command)), 0);
  }

  /// Figures of the tables, and what each author's conventions make of them.
  void conventions() {
    const auto sets = test::readPublishedSets((shared + "/data/tables").toStdString());
    const auto value = [&](const char* set, const char* parameter) {
      for (const test::PublishedSet& s : sets)
        for (const test::PublishedFit& fit : s.fits)
          if (s.name == set && fit.material == "alum-bronze")
            return fit.parameters.values[s.model->spec().find(parameter).value()];
      return Rgb(-1);
    };
    QCOMPARE(value("ngan-cook-torrance", "roughness").x, 0.0367);
    QCOMPARE(value("ngan-cook-torrance", "f0").x, 0.203);
    QCOMPARE(value("ngan-cook-torrance", "normalisation").x, 1.0);
    QVERIFY(glm::length(value("ngan-cook-torrance", "specular") - Rgb(0.118, 0.0698 * 1.15, 0.0371 * 1.66)) < 1e-12);
    QCOMPARE(value("ngan-ward", "roughness").x, 0.0357);
    QCOMPARE(value("ngan-blinn-phong", "specular").x, 4 * 0.015);
    QCOMPARE(value("loew-cook-torrance-e1", "normalisation").x, 2.0);
    QVERIFY(std::abs(value("loew-cook-torrance-e1", "f0").x - std::pow(0.46492 / 2.46492, 2)) < 1e-12);
    QCOMPARE(value("loew-microfacet-e2", "index-of-refraction").x, 2.236525);
    QCOMPARE(value("bagher-sgd", "f1").z, 0.476088);
  }

  void oursAreNotWorse_data() {
    QTest::addColumn<QString>("material");
    for (const QString& name : names) QTest::newRow(qPrintable(name)) << name;
  }
  void oursAreNotWorse() {
    QFETCH(QString, material);
    const auto table = materials::readMaterial((folder + "/" + material + ".binary").toStdString()).tabulated();
    std::map<metrics::BrdfMetric, FitData> data;
    for (const test::PublishedSet& set : test::readPublishedSets((shared + "/data/tables").toStdString()))
      for (const test::PublishedFit& published : set.fits) {
        if (published.material != material.toStdString() || set.name == "bagher-sgd") continue;
        const FitOptions options{.metric = set.metric, .maxPolarAngle = radians(nganAngle)};
        const FitData& at = data.try_emplace(set.metric, *table, options).first->second;
        const double ours = fit(at, *set.model, {}, published.parameters).errors[std::size_t(set.metric)];
        const double theirs = metrics::brdfError(set.metric, *table, *set.model->instantiate(published.parameters),
                                                 options.maxPolarAngle);
        QVERIFY2(ours <= theirs * 1.001, qPrintable(QString("%1: %2, %3").arg(set.name.c_str()).arg(ours).arg(theirs)));
      }
  }
};

GONIO_TEST(PublishedFitsTest)
}  // namespace published_fits_test

#include "published_fits_test.moc"
