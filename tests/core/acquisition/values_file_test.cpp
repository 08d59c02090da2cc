// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/measured_values.h"

#include <QTest>

#include "core/math/colour.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace values_file_test {
using namespace gonio;
using namespace gonio::acquisition;
using acquisition::MeasuredValues;
using acquisition::SamplingPlan;

/// Three samples with indices that are not those of their places.
SamplingPlan plan() {
  SamplingPlan result;
  for (const int index : {2, 5, 7}) result.samples.push_back({index, {}, index});
  return result;
}

std::string valuesError(const std::string& text) {
  return test::errorOf([&] { parseValues(text, plan()); });
}

#define VERIFY_VALUES_ERROR(text, part) \
  QVERIFY2(test::contains(valuesError(text), part), qPrintable(QString::fromStdString("found: " + valuesError(text))))

class ValuesFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// To the last bit.
  void roundTrip() {
    MeasuredValues values{{Rgb(0.1, 1.0 / 3, 0), Rgb(1e-12, 7e5, 2), Rgb(3, 4, 5)}, {}};
    QCOMPARE(valuesCsv(plan(), values), std::string("index,r,g,b\n2,0.1,0.3333333333333333,0\n5,1e-12,7e+05,2\n"
                                                    "7,3,4,5\n"));
    QVERIFY(parseValues(valuesCsv(plan(), values), plan()).rgb == values.rgb);
    QVERIFY(parseValues(valuesCsv(plan(), values), plan()).noise.empty());
    values.noise = {Rgb(0.01), Rgb(1, 2, 3), Rgb(0)};
    const auto path = test::outputPath("values/values.csv");
    writeValues(plan(), values, path);
    const MeasuredValues found = readValues(path, plan());
    QVERIFY(found.rgb == values.rgb && found.noise == values.noise);
  }

  void whatCannotBeReadAgainIsNotWritten() {
    const std::vector<Rgb> good(3, Rgb(1));
    const auto path = test::outputPath("values/refused.csv");
    for (const MeasuredValues& values :
         {MeasuredValues{{Rgb(1), Rgb(NAN, 0, 0), Rgb(1)}, {}}, MeasuredValues{{Rgb(1), Rgb(INFINITY), Rgb(1)}, {}},
          MeasuredValues{good, {Rgb(0), Rgb(0), Rgb(0, 0, NAN)}}, MeasuredValues{{Rgb(1), Rgb(-1), Rgb(1)}, {}},
          MeasuredValues{{Rgb(1)}, {}}, MeasuredValues{good, {Rgb(0)}}})
      QVERIFY(!test::errorOf([&] { writeValues(plan(), values, path); }).empty() && !std::filesystem::exists(path));
  }

  /// Rows in any order, columns that nobody asked for, one noise for all channels, a spreadsheet's form.
  void forms() {
    const std::vector<Rgb> expected{Rgb(1, 2, 3), Rgb(0.5, 0, 4), Rgb(6)};
    for (const std::string text : {"index,r,g,b\n7,6,6,6\n2,1,2,3\n5,.5,0,4\n",
                                   "\xEF\xBB\xBFtime;Index;B;G;R\r\n1;2;3;2;1\r\n2;5;4;0;0,5\r\n3;7;6;6;6\r\n"})
      QVERIFY(parseValues(text, plan()).rgb == expected);
    const MeasuredValues noisy = parseValues("index,r,g,b,noise\n2,1,1,1,0.1\n5,1,1,1,0\n7,1,1,1,0.3\n", plan());
    QVERIFY(noisy.noise == (std::vector<Rgb>{Rgb(0.1), Rgb(0), Rgb(0.3)}));
  }

  /// Named by wavelength, in any order; a grey stays grey; the noise of one wavelength spreads by the weights.
  void spectra() {
    const std::string rows = "2,0.5,0.5,0.5,0.5,0.1\n5,0,1,0,0,0\n7,0.1,0.2,0.3,0.4,1\n";
    const MeasuredValues found = parseValues("index,600,450nm,500 nm,700,noise\n" + rows, plan());
    QVERIFY(glm::length(found.rgb[0] - Rgb(0.5)) < 1e-12);
    QVERIFY(found.rgb[1].z > 0.3 && found.rgb[1].x >= 0 && found.rgb[1].y >= 0);
    const std::vector<Rgb> weights = spectrumWeights(std::vector<double>{450, 500, 600, 700});
    const Rgb expected = 0.2 * weights[0] + 0.3 * weights[1] + 0.1 * weights[2] + 0.4 * weights[3];
    QVERIFY(glm::length(found.rgb[2] - expected) < 1e-12);
    Rgb squares(0);
    for (const Rgb& weight : weights) squares += weight * weight;
    QVERIFY(glm::length(found.noise[2] - glm::sqrt(squares)) < 1e-12);
    QVERIFY(glm::length(found.noise[0] - 0.1 * glm::sqrt(squares)) < 1e-12);
    // Beside r, g, b they are columns that nobody asked for.
    QVERIFY(parseValues("index,r,g,b,450,550,650\n2,1,1,1,0,0,0\n5,1,1,1,0,0,0\n7,1,1,1,0,0,0\n", plan()).rgb[0] ==
            Rgb(1));
    VERIFY_VALUES_ERROR("index,450,550\n", "expected one named r");
    VERIFY_VALUES_ERROR("index,450,550,550nm,650\n", "two columns of 550 nm");
    VERIFY_VALUES_ERROR("index,450,550,650\n2,1,-1,1\n5,1,1,1\n7,1,1,1\n", "line 2: found -1 for 550");
    VERIFY_VALUES_ERROR("index,580,640,700\n2,1.79e308,0,0\n5,1,1,1\n7,1,1,1\n", "too large");
  }

  void errorsNameTheLine() {
    const std::string names = "index,r,g,b\n", good = "2,1,1,1\n5,1,1,1\n7,1,1,1\n";
    QVERIFY(valuesError(names + good).empty());
    VERIFY_VALUES_ERROR(names, "found no row for index 2, 5, 7");
    VERIFY_VALUES_ERROR(names + "2,1,1,1\n7,1,1,1\n", "found no row for index 5, expected one for each sample");
    VERIFY_VALUES_ERROR(names + good + "5,1,1,1\n", "line 5: found the index 5 a second time (first in line 3)");
    VERIFY_VALUES_ERROR(names + good + "3,1,1,1\n", "line 5: found the index 3, expected an index of the plan");
    VERIFY_VALUES_ERROR(names + "2,1,1,1\n5,1,-0.5,1\n7,1,1,1\n",
                        "line 3: found -0.5 for g, expected a number, 0 or more");
    for (const char* bad : {"nan", "inf", "-inf", "1e999", "abc", "", "0x1p3", "1.2.3", "1 2"})
      VERIFY_VALUES_ERROR(names + "2,1,1,1\n5,1,1," + bad + "\n7,1,1,1\n",
                          std::string("line 3: found '") + bad + "' for b");
    VERIFY_VALUES_ERROR(names + "2,1,1\n5,1,1,1\n7,1,1,1\n", "line 2: found 3 columns, expected 4");
    VERIFY_VALUES_ERROR("index,r,g\n", "expected one named b");
    VERIFY_VALUES_ERROR("r,g,b\n1,1,1\n", "expected one named index");
    VERIFY_VALUES_ERROR("index,r,g,b,noise_r\n2,1,1,1,0\n5,1,1,1,0\n7,1,1,1,0\n", "expected one named noise_g");
    VERIFY_VALUES_ERROR("index,r,g,b,noise\n2,1,1,1,0\n5,1,1,1,-1\n7,1,1,1,0\n", "line 3: found -1 for noise");
    const std::string bad = names + "9,1,1,1\n";
    const auto path = test::writeFile("values/bad.csv", std::as_bytes(std::span(bad)));
    QVERIFY(test::contains(test::errorOf([&] { readValues(path, plan()); }), "bad.csv: line 2: "));
  }
};

GONIO_TEST(ValuesFileTest)
}  // namespace values_file_test

#include "values_file_test.moc"
