// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QDir>
#include <QTest>
#include <cmath>

#include "core/acquisition/reconstruction.h"
#include "core/acquisition/sampling_plan.h"
#include "core/materials/basis_file.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_acquisition_test {
using namespace gonio;
using namespace gonio::test;

/// goniotool plan, measure and reconstruct: from materials to a plan, to values, to a material.
class GoniotoolAcquisitionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    for (int i = 0; i < 4; ++i)
      folder_.writeTable(QString("train%1.binary").arg(i), "ggx",
                         {{Rgb(0.1 + 0.1 * i, 0.3, 0.5 - 0.1 * i), Rgb(0.9 - 0.2 * i), Rgb(0.1 + 0.15 * i), Rgb(0.1)}},
                         HalfDifferenceGrid());
    plan_ = folder_.path("plan.csv");
    planned_ = runJson({"plan", "--train", folder_.path(), "--samples", "12", "--max-polar", "80", "--min-separation",
                        "3", "--forbid", "theta_o=60:90", "--method", "somp", "--out", plan_});
    VERIFY_SUCCESS(planned_);
  }

  void plan() {
    QCOMPARE(planned_.json["method"].get<std::string>(), std::string("somp"));
    QCOMPARE(planned_.json["signals"].get<int>(), 12);
    QCOMPARE(planned_.json["materials"].get<int>(), 4);
    const auto plan = acquisition::readPlan(plan_.toStdString());
    QCOMPARE(plan.samples.size(), planned_.json["samples"].get<std::size_t>());
    QCOMPARE(plan.method, std::string("somp"));
    for (const acquisition::PlannedSample& sample : plan.samples) {
      QVERIFY(polarAngle(sample.directions.wi) < radians(80.001));
      QVERIFY(polarAngle(sample.directions.wo) < radians(60));
      QVERIFY(glm::length(sample.directions.wi - sample.directions.wo) > 2 * std::sin(radians(1.49)));
    }
    const ToolResult automatic =
        runJson({"plan", "--train", folder_.path(), "--samples", "12", "--out", folder_.path("automatic.csv")});
    VERIFY_SUCCESS(automatic);
    QCOMPARE(automatic.json["method"].get<std::string>(), std::string("a-optimal"));
    const auto basis = materials::readBasis(std::filesystem::path(planned_.json["basis"].get<std::string>()));
    QCOMPARE(QString::fromStdString(planned_.json["basis"]), folder_.path("plan.basis"));
    QCOMPARE(basis->learnedFrom.size(), std::size_t(4));
    QCOMPARE(basis->components.count(), planned_.json["components"].get<int>());
  }

  /// With the three arguments alone: the basis beside the plan. A material of the training set comes back with a small
  /// ridge, by the basis or by learning again.
  void reconstructs() {
    const QString values = folder_.path("values.csv"), out = folder_.path("out.binary");
    const QString material = folder_.path("train1.binary");
    VERIFY_SUCCESS(runJson({"measure", material, "--plan", plan_, "--out", values}));
    const ToolResult plain =
        runJson({"reconstruct", "--plan", plan_, "--values", values, "--out", out, "--ridge", "40"});
    VERIFY_SUCCESS(plain);
    QCOMPARE(plain.json["ridge"].get<double>(), 40.0);
    QCOMPARE(plain.json["assumption"].get<std::string>(), std::string(acquisition::assumedOrders));
    const auto errorOf = [&] { return metrics::brdfErrors(*readTable(material), *readTable(out))[0]; };
    const double published = errorOf();
    QVERIFY(!plain.json["equalNoise"].get<bool>());
    // Published method: eta = 40, as many components as samples, equal weights. The separate options give the same
    // bytes.
    const ToolResult printed =
        runJson({"reconstruct", "--plan", plan_, "--values", values, "--out", out, "--as-published"});
    VERIFY_SUCCESS(printed);
    QCOMPARE(printed.json["ridge"].get<double>(), 40.0);
    QCOMPARE(printed.json["components"].get<int>(),
             std::min(printed.json["samples"].get<int>(), planned_.json["components"].get<int>()));
    QVERIFY(printed.json["equalNoise"].get<bool>());
    const QByteArray whole = bytesOf(out);
    VERIFY_SUCCESS(runJson({"reconstruct", "--plan", plan_, "--values", values, "--out", out, "--ridge", "40",
                            "--equal-noise", "--components", QString::number(printed.json["components"].get<int>())}));
    QVERIFY(bytesOf(out) == whole);
    const QString uncertainty = folder_.path("uncertainty.binary");
    const ToolResult exact = runJson({"reconstruct", "--plan", plan_, "--values", values, "--out", out, "--ridge",
                                      "1e-6", "--uncertainty", uncertainty});
    VERIFY_SUCCESS(exact);
    QVERIFY2(errorOf() < 0.02 * published, qPrintable(QString::number(errorOf() / published)));
    QVERIFY(exact.json["medianDeviation"].get<double>() < plain.json["medianDeviation"].get<double>());
    QCOMPARE(readTable(uncertainty)->validCount(), readTable(out)->validCount());
    VERIFY_SUCCESS(runJson({"reconstruct", "--plan", plan_, "--values", values, "--out", out, "--ridge", "1e-6",
                            "--train", folder_.path(), "--exclude", "out,uncertainty"}));
    QVERIFY(errorOf() < 0.02 * published);
    const ToolResult automatic = runJson({"reconstruct", "--plan", plan_, "--values", values, "--out", out});
    VERIFY_SUCCESS(automatic);
    QVERIFY(automatic.json["ridge"].get<double>() < 40);
    QCOMPARE(automatic.json["components"].get<int>(), planned_.json["components"].get<int>());
    QCOMPARE(automatic.json["method"].get<std::string>(), "local-ridge");
    const QByteArray local = bytesOf(out);
    VERIFY_SUCCESS(
        runJson({"reconstruct", "--plan", plan_, "--values", values, "--out", out, "--method", "local-ridge"}));
    QVERIFY(bytesOf(out) == local);
    const ToolResult named =
        runJson({"reconstruct", "--plan", plan_, "--values", values, "--out", out, "--ridge", "auto"});
    QCOMPARE(named.json["method"].get<std::string>(), "ridge");
    QCOMPARE(runTool({"reconstruct", "--plan", plan_, "--values", values, "--out", out, "--method", "local-ridge",
                      "--ridge", "40"})
                 .code,
             2);
    VERIFY_SUCCESS(runJson(
        {"reconstruct", "--plan", plan_, "--values", values, "--out", out, "--method", "sparse", "--atoms", "3"}));
    for (const char* name : {"out.binary", "uncertainty.binary"}) QFile::remove(folder_.path(name));
  }

  /// The prior is learned from the materials of --train; if more than their mean is known, what was measured
  /// is nearer than another material.
  void inTheDictionaries() {
    const QString values = folder_.path("values.csv"), out = folder_.path("dictionaries.binary");
    VERIFY_SUCCESS(runJson({"measure", folder_.path("train1.binary"), "--plan", plan_, "--out", values}));
    QStringList command{"reconstruct", "--plan", plan_, "--values", values, "--out", out, "--method", "dictionaries"};
    QCOMPARE(runTool(command).code, 2);
    for (int i = 0; i < 4; ++i) command << "--train" << folder_.path(QString("train%1.binary").arg(i));
    const ToolResult found = runJson(command);
    VERIFY_SUCCESS(found);
    QCOMPARE(found.json["method"].get<std::string>(), std::string("dictionaries"));
    const int dictionary = found.json["dictionary"].get<int>();
    QVERIFY(dictionary >= 0 && dictionary < 32 && found.json["noise"].get<double>() > 0);
    const auto errorOf = [&](const char* other) {
      return metrics::brdfErrors(*readTable(folder_.path(other)), *readTable(out))[0];
    };
    QVERIFY(errorOf("train1.binary") < 0.5 * std::min(errorOf("train0.binary"), errorOf("train2.binary")));
    QCOMPARE(runTool(command + QStringList{"--ridge", "40"}).code, 2);
    QFile::remove(out);
  }

  void noise() {
    const QString values = folder_.path("noisy.csv"), again = folder_.path("again.csv");
    const QStringList measure{"measure",        folder_.path("train2.binary"),
                              "--plan",         plan_,
                              "--noise",        "0.1",
                              "--floor",        "0.001",
                              "--misalignment", "0.5",
                              "--out"};
    VERIFY_SUCCESS(runJson(measure + QStringList{values}));
    VERIFY_SUCCESS(runJson(measure + QStringList{again}));
    QVERIFY(bytesOf(values).startsWith("index,r,g,b,noise_r,noise_g,noise_b\n") && bytesOf(values) == bytesOf(again));
    VERIFY_SUCCESS(runJson(measure + QStringList{again, "--seed", "2"}));
    QVERIFY(bytesOf(values) != bytesOf(again));
    const ToolResult found =
        runJson({"reconstruct", "--plan", plan_, "--values", values, "--out", folder_.path("noisy.binary")});
    VERIFY_SUCCESS(found);
    QFile::remove(folder_.path("noisy.binary"));
  }

  void mistakesAreTold() {
    const QString values = folder_.path("bad.csv"), out = folder_.path("never.binary");
    folder_.writeText("bad.csv", "index,r,g,b\n1,1,1,1\n1,2,2,2\n");
    const ToolResult twice = runTool({"reconstruct", "--plan", plan_, "--values", values, "--out", out});
    QCOMPARE(twice.code, 1);
    QCOMPARE(twice.errorLines(), 1);
    QVERIFY(twice.error.contains("bad.csv") && twice.error.contains("line 3"));
    folder_.writeText("alone.csv", "index,theta_i,phi_i,theta_o,phi_o\n1,20,0,30,180\n");
    folder_.writeText("one.csv", "index,r,g,b\n1,1,1,1\n");
    const QStringList alone{"reconstruct", "--plan", folder_.path("alone.csv"), "--values", folder_.path("one.csv"),
                            "--out",       out};
    const ToolResult noBasis = runTool(alone);
    QCOMPARE(noBasis.code, 1);
    QVERIFY(noBasis.error.contains("alone.basis"));
    VERIFY_SUCCESS(runTool(alone + QStringList{"--basis", folder_.path("plan.basis")}));
    QVERIFY(QFile::remove(out));
    QCOMPARE(runTool(alone + QStringList{"--ridge", "much"}).code, 2);
    QCOMPARE(runTool(alone + QStringList{"--method", "sparse", "--uncertainty", out}).code, 2);
    const QStringList plan{"plan", "--train", folder_.path("train0.binary"), "--samples", "3", "--out"};
    QCOMPARE(runTool(plan + QStringList{folder_.path("x.csv"), "--forbid", "theta=1:2"}).code, 2);
    QCOMPARE(runTool(plan + QStringList{folder_.path("x.basis")}).code, 2);
    QCOMPARE(runTool({"plan", "--samples", "0", "--out", folder_.path("x.csv")}).code, 2);
    QVERIFY(!QFile::exists(folder_.path("x.csv")) && !QFile::exists(out));
  }

  /// A plan knows its basis; one that is named is taken as it is. The basis keeps as many components as are asked for.
  void basisOfThePlan() {
    const QString folder = folder_.path("bases"), plan = folder + "/p.csv", basis = folder + "/p.basis";
    QVERIFY(QDir().mkpath(folder));
    const QStringList command{
        "plan",  "--train", folder_.path("train0.binary"), folder_.path("train1.binary"), "--samples", "4",
        "--out", plan};
    const ToolResult few = runJson(command + QStringList{"--basis-components", "2"});
    VERIFY_SUCCESS(few);
    QCOMPARE(few.json["components"].get<int>(), 2);
    QCOMPARE(materials::readBasis(std::filesystem::path(basis.toStdString()))->components.count(), 2);
    QCOMPARE(acquisition::readPlan(plan.toStdString()).basisDigest.size(), std::size_t(16));
    const QString values = folder + "/v.csv", out = folder + "/out.binary";
    VERIFY_SUCCESS(runTool({"measure", folder_.path("train0.binary"), "--plan", plan, "--out", values}));
    const QStringList reconstruct{"reconstruct", "--plan", plan, "--values", values, "--out", out};
    VERIFY_SUCCESS(runTool(reconstruct));
    QVERIFY(QFile::remove(basis) && QFile::copy(folder_.path("plan.basis"), basis) && QFile::remove(out));
    const ToolResult other = runTool(reconstruct);
    QCOMPARE(other.code, 1);
    QVERIFY(other.error.contains("p.basis") && other.error.contains("SHA-256") && !QFile::exists(out));
    VERIFY_SUCCESS(runTool(reconstruct + QStringList{"--basis", basis}));
  }

  /// What cannot be written is reported before anything is learned: the materials to learn from need not even be there.
  void destinationsAreCheckedFirst() {
    const ToolResult absent =
        runTool({"plan", "--train", "/nowhere", "--samples", "3", "--out", folder_.path("absent/plan.csv")});
    QCOMPARE(absent.code, 1);
    QVERIFY(absent.error.contains("absent/plan") && absent.error.contains("cannot be written"));
    QVERIFY(QDir().mkpath(folder_.path("taken.basis")));
    const ToolResult taken =
        runTool({"plan", "--train", "/nowhere", "--samples", "3", "--out", folder_.path("taken.csv")});
    QVERIFY(taken.code == 1 && taken.error.contains("taken.basis"));
  }

  /// No option is passed over in silence.
  void optionsThatDoNotGoTogether() {
    const QStringList plan{"plan", "--train", folder_.path("train0.binary"), "--samples",
                           "3",    "--out",   folder_.path("x.csv")};
    const ToolResult twice = runTool(plan + QStringList{"--forbid", "theta_i=0:60,theta_i=80:90"});
    QCOMPARE(twice.code, 2);
    QVERIFY(twice.error.contains("theta_i twice"));
    QVERIFY(!QFile::exists(folder_.path("x.csv")));
    const QStringList reconstruct{
        "reconstruct", "--plan", plan_, "--values", folder_.path("values.csv"), "--out", folder_.path("never.binary")};
    for (const QStringList& wrong :
         {QStringList{"--exclude", "train0"},
          QStringList{"--basis", folder_.path("plan.basis"), "--train", folder_.path()}, QStringList{"--atoms", "3"},
          QStringList{"--equal-noise", "--method", "sparse"}, QStringList{"--as-published", "--ridge", "3"}}) {
      const ToolResult result = runTool(reconstruct + wrong);
      QVERIFY2(result.code == 2 && result.error.contains(wrong[0]), qPrintable(result.error));
    }
  }

  void zEveryKeyIsDocumented() { QCOMPARE(undocumentedKeys(), QString()); }

 private:
  TestFolder folder_{"goniotool-acquisition"};
  QString plan_;
  ToolResult planned_;
};

GONIO_TEST(GoniotoolAcquisitionTest)
}  // namespace goniotool_acquisition_test

#include "goniotool_acquisition_test.moc"
