// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>
#include <cmath>

#include "tests/core/models/model_test_support.h"
#include "tests/core/models/white_furnace.h"

using namespace gonio;
using namespace gonio::models;
using namespace gonio::models::test;

namespace {

/// As ModelSpec::conservesEnergy says: the linear parameters share 1, choices stand at their defaults, everything else
/// is drawn. Fresnel terms tend to 1 in every third draw.
ParameterValues claimedParameters(const ModelSpec& spec, int draw, std::mt19937_64& random) {
  std::exponential_distribution<double> exponential;
  ParameterValues values = randomParameters(spec, random);
  double sum = 0;
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const ParameterSpec& p = spec.parameters[i];
    values.values[i] = Rgb(p.linear ? exponential(random) : p.choices.empty() ? values.values[i].x : p.defaultValue);
    if (p.linear) sum += values.values[i].x;
    if (p.group == ParameterGroup::fresnel && draw % 3 == 0) values.values[i] = Rgb(p.softMax);
  }
  for (std::size_t i = 0; i < spec.parameters.size(); ++i)
    if (spec.parameters[i].linear) values.values[i] /= sum;
  return values;
}

}  // namespace

/// Models that say that they conserve energy do.
class EnergyClaimsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void hardCase47ClaimedAlbedosAreAtMostOne_data() {
    QTest::addColumn<QString>("id");
    for (const Model* model : allModels())
      if (model->spec().conservesEnergy)
        QTest::newRow(model->spec().id.data()) << QString::fromUtf8(model->spec().id.data());
  }
  void hardCase47ClaimedAlbedosAreAtMostOne() {
    QFETCH(QString, id);
    const Model& model = findModel(id.toStdString());
    std::mt19937_64 random(17);
    constexpr int draws = 6;
    for (int n = 0; n < draws; ++n) {
      const ParameterValues values = claimedParameters(model.spec(), n, random);
      const auto brdf = model.instantiate(values);
      for (const double theta : {0.0, 60.0, 86.0}) {
        const double albedo = whiteFurnaceAlbedo(*brdf, direction(theta, 0), 0.005);
        if (albedo < 1 + 2e-3) continue;
        QString text = QString("draw %1, %2 degrees: %3 with").arg(n).arg(theta).arg(albedo);
        for (std::size_t i = 0; i < values.values.size(); ++i)
          text += QString(" %1 = %2").arg(model.spec().parameters[i].id.data()).arg(values.values[i].x);
        QFAIL(qPrintable(text));
      }
    }
  }
};

QTEST_APPLESS_MAIN(EnergyClaimsTest)
#include "energy_claims_test.moc"
