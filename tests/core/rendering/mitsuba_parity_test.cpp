// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "tests/support/mitsuba_pictures.h"
#include "tests/support/test_program.h"

namespace mitsuba_parity_test {
using namespace gonio;

/// RGL materials look as in Mitsuba 3. All eight at the full count: tests/studies/mitsuba_parity_study.cpp.
class MitsubaParityTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void sameFileSamePicture_data() {
    QTest::addColumn<QString>("material");
    for (const char* name : {"satin_purple", "acrylic_felt_green", "paper_blue"}) QTest::newRow(name) << QString(name);
  }
  void sameFileSamePicture() {
    QFETCH(QString, material);
    const std::filesystem::path shared = GONIO_SHARED_DIR;
    if (!std::filesystem::exists(shared / "data/renderings")) QSKIP("the development data is absent");
    const auto found = test::parityWithMitsuba(shared, material.toStdString(), 32);
    const QString text = QString("error %1 with a standard error of %2").arg(found.error).arg(found.standardError);
    qInfo("%s", qPrintable(text));
    QVERIFY2(found.standardError < 1e-4, qPrintable(text));                    // else it would prove nothing
    QVERIFY2(found.error < 1e-4 + 2 * found.standardError, qPrintable(text));  // 40 dB
  }

  /// Read in the file's own order these materials, which are not reciprocal, look otherwise.
  void theOtherOrderIsAnother() {
    const std::filesystem::path shared = GONIO_SHARED_DIR;
    if (!std::filesystem::exists(shared / "data/renderings")) QSKIP("the development data is absent");
    QVERIFY(test::parityWithMitsuba(shared, "satin_purple", 4, IncidentDirection::light).error > 1e-2);
  }
};

GONIO_TEST(MitsubaParityTest)
}  // namespace mitsuba_parity_test

#include "mitsuba_parity_test.moc"
