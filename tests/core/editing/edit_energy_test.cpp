// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit_plausibility.h"

#include <QTest>
#include <cmath>

#include "core/models/registry.h"
#include "tests/support/test_program.h"

namespace edit_energy_test {
using namespace gonio;
using namespace gonio::editing;

/// A change of a Lambertian body from 0.4 to `albedo`.
Edit bodyEdit(const Rgb& albedo) {
  const models::Model& model = models::lambert();
  DifferentialEdit edit;
  edit.model = &model;
  edit.fitted.values = {Rgb(0.4)};
  edit.edited.values = {albedo};
  return {edit};
}

class EditEnergyTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The albedo of a Lambertian surface is its parameter at every angle.
  void ofLambertianSurfacesItIsTheAlbedo() {
    const std::shared_ptr<const Brdf> base = models::lambert().instantiate({{Rgb(0.4)}});
    Edit hidden = bodyEdit(Rgb(0.9));
    hidden.enabled = false;
    const std::vector<Edit> edits{bodyEdit(Rgb(0.4, 0.5, 0.6)), hidden, bodyEdit(Rgb(0.3))};
    const std::vector<Energy> energies = energiesThrough(base, edits);
    const double coloured = luminance(Rgb(0.4, 0.5, 0.6));
    const double expected[] = {0.4, coloured, coloured, coloured - 0.1};
    QCOMPARE(energies.size(), std::size(expected));
    for (std::size_t i = 0; i < energies.size(); ++i) {
      QVERIFY(std::abs(energies[i].headOn - expected[i]) < 1e-3);
      QVERIFY(std::abs(energies[i].grazing - expected[i]) < 1e-3);
    }
  }

  void cancelling() {
    const std::shared_ptr<const Brdf> base = models::lambert().instantiate({{Rgb(0.4)}});
    const std::vector<Edit> edits{bodyEdit(Rgb(0.5))};
    std::stop_source source;
    source.request_stop();
    QVERIFY_EXCEPTION_THROWN(energiesThrough(base, edits, {source.get_token(), {}}), Cancelled);
  }
};

GONIO_TEST(EditEnergyTest)
}  // namespace edit_energy_test

#include "edit_energy_test.moc"
