// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/sampling_plan.h"

#include <QTest>

#include "core/coordinates/grid_directions.h"
#include "core/io/csv_text.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace plan_file_test {
using namespace gonio;
using namespace gonio::io;
using namespace gonio::acquisition;
using acquisition::SamplingPlan;

const std::string names = "index,theta_i,phi_i,theta_o,phi_o\n";

std::string planError(const std::string& text) {
  return test::errorOf([&] { parsePlan(text); });
}

#define VERIFY_PLAN_ERROR(text, part) \
  QVERIFY2(test::contains(planError(text), part), qPrintable(QString::fromStdString("found: " + planError(text))))

class PlanFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Every nineteenth node of the whole grid above the horizon goes through the text and is the same node again.
  void everyNodeComesBack() {
    const HalfDifferenceGrid grid;
    const GridDirections directions(grid);
    SamplingPlan plan;
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < grid.size(); cell += 19) {
      if (!directions.at(cell).aboveHorizon || acquisition::pairNode(grid, cell) != cell) continue;
      cells.push_back(cell);
      plan.samples.push_back({int(cells.size()), directions.at(cell).pair, int(cells.size())});
    }
    const SamplingPlan found = parsePlan(planCsv(plan));
    QCOMPARE(found.samples.size(), cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (acquisition::nearestNode(grid, found.samples[i].directions) != cells[i])
        QFAIL(qPrintable(QString::number(cells[i])));
  }

  void roundTrip() {
    const HalfDifferenceGrid grid;
    const std::vector<std::uint32_t> cells{std::uint32_t(grid.index(10, 20, 30)), std::uint32_t(grid.index(0, 60, 90)),
                                           std::uint32_t(grid.index(50, 5, 179))};
    SamplingPlan plan = acquisition::planFor(grid, cells);
    plan.method = "somp";
    plan.basisDigest = "0123456789abcdef";
    const std::string text = planCsv(plan, {"learned from 3 materials"});
    QVERIFY(
        text.starts_with("# method: somp\n# basis, SHA-256: 0123456789abcdef\n# learned from 3 "
                         "materials\n# theta_i, phi_i: direction of the light; theta_o, phi_o: direction of the "
                         "viewer\nindex,theta_i,phi_i,theta_o,phi_o,theta_h,"));
    QVERIFY(test::contains(text, ",1.111111,20,30,"));
    const SamplingPlan found = parsePlan(text);
    QCOMPARE(found.method, plan.method);
    QCOMPARE(found.basisDigest, plan.basisDigest);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      QCOMPARE(found.samples[i].index, plan.samples[i].index);
      QCOMPARE(found.samples[i].order, plan.samples[i].order);
      QVERIFY(glm::length(found.samples[i].directions.wi - plan.samples[i].directions.wi) < 2e-8);
      QVERIFY(glm::length(found.samples[i].directions.wo - plan.samples[i].directions.wo) < 2e-8);
    }
    const auto path = test::outputPath("plan/plan.csv");
    writePlan(plan, path);
    QVERIFY(readPlan(path).samples == parsePlan(planCsv(plan)).samples);
  }

  /// As spreadsheets write it: a byte order mark, "\r\n", semicolons and decimal commas, quotes, spaces, rows and
  /// columns in another order, empty rows, empty fields at the end.
  void spreadsheets() {
    const SamplingPlan plain = parsePlan(names + "1,10.5,0,20,180\n2,30,45,40.25,-90\n");
    QCOMPARE(plain.samples.size(), std::size_t(2));
    QVERIFY(std::abs(degrees(polarAngle(plain.samples[1].directions.wo)) - 40.25) < 1e-12);
    QVERIFY(std::abs(degrees(azimuth(plain.samples[1].directions.wo)) + 90) < 1e-12);
    const std::string others[] = {
        "\xEF\xBB\xBFindex,theta_i,phi_i,theta_o,phi_o\r\n1,10.5,0,20,180\r\n2,30,45,40.25,-90\r\n",
        "index;theta_i;phi_i;theta_o;phi_o\n1;10,5;0;20;180\n2;30;45;40,25;-90",
        "index\ttheta_i\tphi_i\ttheta_o\tphi_o\r1\t10.5\t0\t20\t180\r2\t30\t45\t40.25\t-90\r",
        " \"Index\" , Theta_I,phi_i , theta_o,phi_o\n# a comment, with commas\n\n 1, 10.50 ,+0,\"20\",180\n,,,,\n"
        "2,3e1,45,40.25,-90\n",
        "note,phi_o,theta_o,phi_i,theta_i,index\nx,-90,40.25,45,30,2\ny,180,20,0,10.5,1\n",
        "index,theta_i,phi_i,theta_o,phi_o,,\n1,10.5,0,20,180,,\n2,30,45,40.25,-90,,\n"};
    for (const std::string& other : others) QVERIFY(parsePlan(other).samples == plain.samples);
  }

  /// Without an order the way is planned; one that is given must be whole.
  void order() {
    const SamplingPlan found = parsePlan(names + "3,60,0,60,180\n1,1.5,0,2,180\n2,30,0,30,180\n");
    for (int i = 0; i < 3; ++i) {
      QCOMPARE(found.samples[std::size_t(i)].index, i + 1);
      QCOMPARE(found.samples[std::size_t(i)].order, i + 1);
    }
    const std::string ordered = "index,theta_i,phi_i,theta_o,phi_o,order\n";
    QCOMPARE(parsePlan(ordered + "1,10,0,10,180,2\n2,50,0,50,180,1\n").samples[0].order, 2);
    VERIFY_PLAN_ERROR(ordered + "1,10,0,10,180,2\n2,50,0,50,180,1\n3,50,0,40,180,2\n",
                      "line 4: found the order 2 a second time (first in line 2)");
    VERIFY_PLAN_ERROR(ordered + "1,10,0,10,180,1\n2,50,0,50,180,3\n", "line 3: found the order 3, expected 1 to 2");
    VERIFY_PLAN_ERROR(ordered + "1,10,0,10,180,0\n2,50,0,50,180,1\n", "line 2: found the order 0, expected 1 to 2");
  }

  /// A plan near the normal is small enough for radians: its half-difference angles say that it is in degrees.
  void degreesNearTheNormal() {
    SamplingPlan plan;
    for (int i = 1; i <= 5; ++i)
      plan.samples.push_back({i, fromHalfDifference(radians(0.1 * i), radians(0.05 * i), radians(3.0 - 0.5 * i)), i});
    const std::string text = planCsv(plan);
    const SamplingPlan found = parsePlan(text);
    QCOMPARE(found.samples.size(), std::size_t(5));
    for (std::size_t i = 0; i < 5; ++i)
      QVERIFY(glm::length(found.samples[i].directions.wi - plan.samples[i].directions.wi) < 2e-8);
    // All in radians, and the angles of directions alone.
    std::string radianText = "index,theta_i,phi_i,theta_o,phi_o,theta_h,theta_d,phi_d\n", alone = names;
    for (int i = 1; i <= 5; ++i) {
      const DirectionPair pair{fromSpherical(0.25 * i, 0.1), fromSpherical(0.2 * i, -2.0)};
      const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
      std::string row = std::to_string(i);
      for (const double angle : {0.25 * i, 0.1, 0.2 * i, -2.0}) row += "," + decimalText(angle, 6);
      alone += row + "\n";
      for (const double angle : {at.thetaH, at.thetaD, at.phiD}) row += "," + decimalText(angle, 6);
      radianText += row + "\n";
    }
    VERIFY_PLAN_ERROR(radianText, "expected degrees");
    VERIFY_PLAN_ERROR(alone, "expected degrees");
  }

  void manySamples() {
    std::string text = names;
    for (int i = 1; i <= 65536; ++i) text += std::to_string(i) + ",10,0,20,180\n";
    QCOMPARE(parsePlan(text).samples.size(), std::size_t(65536));
    VERIFY_PLAN_ERROR(text + "65537,10,0,20,180\n", "found 65537 samples, expected at most 65536");
  }

  void errorsNameTheLine() {
    VERIFY_PLAN_ERROR("", "no header line with column names");
    VERIFY_PLAN_ERROR("# only\n", "no header line with column names");
    VERIFY_PLAN_ERROR(names, "no samples");
    VERIFY_PLAN_ERROR("index,theta_i,phi_i,theta_o\n1,2,3,4\n",
                      "line 1: found the columns index, theta_i, phi_i, theta_o");
    VERIFY_PLAN_ERROR("index,theta_i,phi_i,theta_o,phi_o,phi_o\n", "line 1: found two columns 'phi_o'");
    VERIFY_PLAN_ERROR(names + "1,10,0,20\n", "line 2: found 4 columns, expected 5");
    VERIFY_PLAN_ERROR(names + "1,10,0,20,0,5\n", "line 2: found 6 columns, expected 5");
    VERIFY_PLAN_ERROR(names + "\n1,10,0,20,0\n1,11,0,20,0\n",
                      "line 4: found the index 1 a second time (first in line 3)");
    VERIFY_PLAN_ERROR("index,theta_i,phi_i,theta_o,phi_o\r\n\r\n1,2,3,4,x\r\n", "line 3: ");
    VERIFY_PLAN_ERROR(names + "0,10,0,20,0\n", "line 2: found the index 0");
    VERIFY_PLAN_ERROR(names + "1.5,10,0,20,0\n", "line 2: found '1.5' for index, expected a whole number");
    VERIFY_PLAN_ERROR(names + "1,ten,0,20,0\n", "line 2: found 'ten' for theta_i, expected a finite number");
    VERIFY_PLAN_ERROR(names + "1,10,nan,20,0\n", "line 2: found 'nan' for phi_i");
    VERIFY_PLAN_ERROR(names + "1,10,0,inf,0\n", "line 2: found 'inf' for theta_o");
    VERIFY_PLAN_ERROR(names + "1,10,0,20,\n", "line 2: found '' for phi_o");
    VERIFY_PLAN_ERROR(names + "1,91,0,20,0\n", "line 2: found 91 for theta_i, expected degrees from 0 to 90");
    VERIFY_PLAN_ERROR(names + "1,10,0,-20,0\n", "line 2: found -20 for theta_o");
    VERIFY_PLAN_ERROR(names + "1,10,0,20,400\n", "line 2: found 400 for phi_o");
    VERIFY_PLAN_ERROR(names + "1,0.5,0.1,0.3,3.1\n2,1.2,0,0.7,-3.1\n3,1.5,1,0.2,2\n", "expected degrees");
    QCOMPARE(parsePlan(names + "1,90.000001,0,20,0\n").samples.size(), std::size_t(1));
    // Near the normal, in degrees.
    QCOMPARE(parsePlan(names + "1,0.5,90,0.3,-90\n2,1,0,1,180\n3,0,0,0.5,180\n").samples.size(), std::size_t(3));
    const std::string missing = test::errorOf([&] { readPlan(test::outputPath("plan/none.csv")); });
    QVERIFY(test::contains(missing, "none.csv"));
    const std::string bad = names + "1,10,0,20\n";
    const auto path = test::writeFile("plan/bad.csv", std::as_bytes(std::span(bad)));
    QVERIFY(test::contains(test::errorOf([&] { readPlan(path); }), "bad.csv: line 2: "));
  }

  void decimals() {
    QCOMPARE(decimalText(1.5, 6), std::string("1.5"));
    QCOMPARE(decimalText(-0.0000001, 6), std::string("0"));
    QCOMPARE(decimalText(100, 6), std::string("100"));
    QCOMPARE(decimalText(1.0 / 3, 6), std::string("0.333333"));
  }
};

GONIO_TEST(PlanFileTest)
}  // namespace plan_file_test

#include "plan_file_test.moc"
