// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <map>

#include "core/materials/material.h"
#include "core/models/model.h"
#include "core/study/accuracy_study.h"
#include "tests/support/test_program.h"

namespace quality_marks_test {
using namespace gonio;
using namespace gonio::study;

using Marks = std::map<std::string, double>;

/// The accuracy of fits, factors (10 terms) and codes (256 coefficients) on measured files: the rendered SNR against
/// the folded table, as it was on 25 November 2026. What loses a decibel fails; what gains one needs a new mark.
class QualityMarksTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void noDecibelIsLost_data() {
    QTest::addColumn<Marks>("marks");
    QTest::newRow("satin_purple") << Marks{
        {"ggx", 20.0}, {"layered", 22.9}, {"factors-2d", 28.3}, {"factors-3d", 37.5}, {"code", 41.9}};
    QTest::newRow("ilm_solo_m_68") << Marks{
        {"ggx", 11.4}, {"layered", 12.1}, {"factors-2d", 37.6}, {"factors-3d", 33.5}, {"code", 26.8}};
  }
  void noDecibelIsLost() {
    QFETCH(Marks, marks);
    const std::filesystem::path path =
        std::filesystem::path(GONIO_SHARED_DIR) / "data/rgl" / (std::string(QTest::currentDataTag()) + "_rgb.bsdf");
    if (!std::filesystem::exists(path)) QSKIP("the development data is absent");
    const auto table = materials::readMaterial(path).tabulated();
    RepresentationChoice choice;
    choice.families = {RepresentationFamily::fit, RepresentationFamily::factors, RepresentationFamily::code};
    choice.models = {&models::findModel("ggx"), &models::findModel("layered")};
    choice.terms = {10};
    choice.coefficients = {256};
    StudyOptions options;
    options.timed = false;
    options.picture = {.width = 64, .height = 64, .samples = 32};
    const std::vector<StudyRecord> records = runStudy({table, table}, representationsOf(choice), options);
    for (const StudyRecord& record : records) {
      const double mark = marks.at(record.representation.id);
      const QByteArray found = QByteArray::fromStdString(record.representation.id) + ": " +
                               QByteArray::number(record.renderedSnr, 'f', 2) + " dB, mark " +
                               QByteArray::number(mark, 'f', 1);
      qInfo("%s", found.data());
      QVERIFY2(record.renderedSnr > mark - 1 && record.renderedSnr < mark + 1, found);
    }
  }
};

GONIO_TEST(QualityMarksTest)
}  // namespace quality_marks_test

#include "quality_marks_test.moc"
