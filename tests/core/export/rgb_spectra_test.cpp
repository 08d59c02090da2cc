// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/rgb_spectra.h"

#include <QTest>
#include <cmath>

#include "core/math/spectrum.h"
#include "tests/support/test_program.h"

namespace rgb_spectra_test {
using namespace gonio;

class RgbSpectraTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void seenAsThePrimaries() {
    const exports::SpectralBasis& basis = exports::spectralBasis();
    const auto observer = spectrumWeights(std::vector<double>(basis.nanometres.begin(), basis.nanometres.end()));
    QCOMPARE(basis.nanometres.size(), 18u);
    for (int channel = 0; channel < 3; ++channel) {
      Rgb seen(0);
      for (std::size_t k = 0; k < observer.size(); ++k) seen += basis.values[k][channel] * observer[k];
      for (int c = 0; c < 3; ++c)
        QVERIFY2(std::abs(seen[c] - (c == channel)) < 1e-6, qPrintable(QString::number(seen[c])));
    }
  }

  void energyIsKept() {
    for (const Rgb& values : exports::spectralBasis().values) {
      QVERIFY(values.x >= 0 && values.y >= 0 && values.z >= 0);
      const double sum = values.x + values.y + values.z;
      QVERIFY2(std::abs(sum - 1) < 1e-6, qPrintable(QString::number(sum)));
    }
  }
};

GONIO_TEST(RgbSpectraTest)

}  // namespace rgb_spectra_test

#include "rgb_spectra_test.moc"
