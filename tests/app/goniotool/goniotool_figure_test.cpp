// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "tests/app/goniotool/interruption.h"
#include "tests/support/test_program.h"

namespace goniotool_figure_test {
using namespace gonio;
using namespace gonio::test;

/// goniotool figure.
class GoniotoolFigureTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic); }

  /// Saved from arguments, then made again from the file: the same bytes, and the numbers of the study.
  void madeAgainFromItsDescription() {
    const QString saved = folder_.path("figure.json");
    const QStringList first{"--out",   folder_.path("a.pdf"), folder_.path("a.svg"), "--csv", folder_.path("a.csv"),
                            "--latex", folder_.path("a.tex")};
    const ToolResult made = runJson(arguments() << first << "--save" << saved);
    VERIFY_SUCCESS(made);
    QCOMPARE(made.json["records"].size(), std::size_t(2));
    QCOMPARE(made.json["out"].size(), std::size_t(5));
    QVERIFY(made.json["errorMaximum"].get<double>() > 0);
    VERIFY_SUCCESS(runJson({"figure", saved, "--out", folder_.path("b.pdf"), folder_.path("b.svg"), "--csv",
                            folder_.path("b.csv"), "--latex", folder_.path("b.tex")}));
    for (const char* suffix : {"pdf", "svg", "csv", "tex"}) {
      const QByteArray bytes = bytesOf(folder_.path(QString("a.") + suffix));
      QVERIFY(!bytes.isEmpty());
      QVERIFY2(bytes == bytesOf(folder_.path(QString("b.") + suffix)), suffix);
    }
    // In the comparison scene, the numbers do not depend on the size of the images.
    const ToolResult study = runJson({"study", plastic_, "--out", folder_.path("study"), "--representations",
                                      "fits,factors", "--models", "ggx", "--terms", "1"});
    VERIFY_SUCCESS(study);
    for (const auto& record : made.json["records"])
      for (const auto& alone : study.json["records"])
        if (alone["representation"] == record["representation"]) {
          QCOMPARE(record["numbers"]["rendered-snr"].get<double>(), alone["renderedSnr"].get<double>());
          QCOMPARE(record["numbers"]["bytes"].get<double>(), alone["bytes"].get<double>());
          QCOMPARE(record["numbers"]["log"].get<double>(), alone["errors"]["log"].get<double>());
        }
    QVERIFY(bytesOf(folder_.path("a.csv")).contains("plastic,factors-3d,"));
  }

  void optionsReplaceTheDescription() {
    const QString saved = folder_.path("changed.json");
    VERIFY_SUCCESS(runTool(arguments() << "--save" << saved));
    const QString again = folder_.path("again.json");
    VERIFY_SUCCESS(runTool({"figure", saved, "--columns", "one", "--inset", "0.25", "0.5", "0.25", "--no-error-maps",
                            "--numbers", "flip", "--title", "T", "--environment", "sky", "--save", again}));
    const auto json = nlohmann::json::parse(bytesOf(again).toStdString());
    QCOMPARE(json["columns"].get<std::string>(), std::string("one"));
    QCOMPARE(json["inset"]["y"].get<double>(), 0.5);
    QCOMPARE(json["errorMaps"].get<bool>(), false);
    QVERIFY(json["numbers"] == nlohmann::json::array({"flip"}));
    QCOMPARE(json["pictures"]["environment"].get<std::string>(), std::string("sky"));
    QCOMPARE(json["pictures"]["size"].get<int>(), 16);
    QCOMPARE(json["materials"][0]["path"].get<std::string>(), std::string("plastic.binary"));
  }

  void textForPeople() {
    const ToolResult result = runTool(arguments() << "--out" << folder_.path("text.png"));
    VERIFY_SUCCESS(result);
    QVERIFY(result.out.contains("plastic\n  GGX: SNR "));
    QVERIFY(bytesOf(folder_.path("text.png")).startsWith("\x89PNG"));
  }

  void wrongFiguresAreRefused() {
    const auto fails = [&](const QStringList& wrong, int code, const char* text) {
      const ToolResult result = runTool(QStringList{"figure"} + wrong);
      QVERIFY2(result.code == code, qPrintable(result.error));
      QVERIFY2(result.error.contains(text), qPrintable(result.error));
      QCOMPARE(result.errorLines(), 1);
    };
    const QString out = folder_.path("none.pdf");
    const QStringList good{"--materials", plastic_, "--representations", "ggx"};
    fails(good, 2, "no output was given");
    fails({"--materials", plastic_, "--out", out}, 2, "no representations were given");
    fails({"--representations", "ggx", "--out", out}, 2, "no materials were given");
    fails({"--materials", plastic_, "--representations", "factors-3d:x", "--out", out}, 2, "'factors-3d:x'");
    fails({"--materials", plastic_, "--representations", "code", "--out", out}, 1, "no budget");
    fails(good + QStringList{"--out", folder_.path("none.eps")}, 1, "'.eps', expected .pdf, .svg or .png");
    fails(good + QStringList{"--out", out, "--csv", out}, 2, "two outputs have the same name");
    fails(good + QStringList{"--numbers", "psnr", "--out", out}, 1, "numbers[0]: found the quantity 'psnr'");
    fails(good + QStringList{"--out", folder_.path("absent/a.pdf")}, 1, "absent/a.pdf");
    folder_.writeText("wrong.json", R"({"format": "gonio figure", "version": 1, "materials": []})");
    fails({folder_.path("wrong.json"), "--out", out}, 1, "wrong.json: materials: found");
    QVERIFY(!QFile::exists(out));
  }

  /// Not the description, and not the materials that it names.
  void inputsAreNeverReplaced() {
    const QString saved = folder_.path("kept.json");
    VERIFY_SUCCESS(runTool(arguments() << "--save" << saved));
    const QByteArray description = bytesOf(saved), table = bytesOf(plastic_);
    for (const QString& taken : {saved, plastic_}) {
      const ToolResult result = runTool({"figure", saved, "--csv", taken});
      QCOMPARE(result.code, 1);
      QVERIFY2(result.error.contains("the command reads this file"), qPrintable(result.error));
    }
    QVERIFY(bytesOf(saved) == description && bytesOf(plastic_) == table);
  }

  void anInterruptLeavesNoFile() {
    const QString out = folder_.path("interrupted.pdf"), saved = folder_.path("interrupted.json");
    const Interruption run = interrupt({"figure", "--materials", plastic_, "--representations", "ggx", "sgd",
                                        "--samples", "100000", "--out", out, "--save", saved, "--progress"},
                                       SIGINT, "measuring");
    QCOMPARE(run.endedBySignal, SIGINT);
    QVERIFY(run.error.contains("interrupted"));
    QVERIFY(!QFile::exists(out) && !QFile::exists(saved));
  }

  void zEveryKeyIsDocumented() { QCOMPARE(undocumentedKeys(), QString()); }

 private:
  QStringList arguments() const {
    return {"figure",    "--materials", plastic_,    "--representations",     "ggx", "factors-3d:1", "--size", "16",
            "--samples", "4",           "--numbers", "rendered-snr,log,bytes"};
  }

  TestFolder folder_{"goniotool-figure"};
  QString plastic_;
};

GONIO_TEST(GoniotoolFigureTest)
}  // namespace goniotool_figure_test

#include "goniotool_figure_test.moc"
