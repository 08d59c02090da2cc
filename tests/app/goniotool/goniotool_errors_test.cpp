// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <sys/stat.h>

#include <QTest>
#include <limits>

#include "core/io/image_io.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_errors_test {
using namespace gonio;
using namespace gonio::test;

/// What goniotool says when it cannot do what was asked: exit codes, one line, the name of the file.
class GoniotoolErrorsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic); }

  void wrongUsageIsTwo_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("nothing") << QStringList{};
    QTest::newRow("unknown subcommand") << QStringList{"dance"};
    QTest::newRow("no file") << QStringList{"info"};
    QTest::newRow("unknown option") << QStringList{"info", plastic_, "--wings"};
    QTest::newRow("unknown model") << QStringList{"fit", plastic_, "--model", "phong-2077"};
    QTest::newRow("unknown metric") << QStringList{"fit", plastic_, "--model", "ggx", "--metric", "taste"};
    QTest::newRow("model and all") << QStringList{"fit", plastic_, "--model", "ggx", "--all"};
    QTest::newRow("no model") << QStringList{"fit", plastic_};
    QTest::newRow("metric that no fit minimises") << QStringList{"fit", plastic_, "--model", "ggx", "--metric", "lab"};
    QTest::newRow("gamma of another metric") << QStringList{"fit", plastic_, "--model", "ggx", "--gamma", "2"};
    for (const char* gamma : {"3.5", "two", "nan"})
      QTest::addRow("gamma %s", gamma) << QStringList{"fit",      plastic_, "--model", "ggx",
                                                      "--metric", "gamma",  "--gamma", gamma};
    QTest::newRow("gamma of all") << QStringList{"fit", plastic_, "--all", "--metric", "gamma", "--gamma", "auto"};
    QTest::newRow("order of one") << QStringList{"fit", plastic_, "--model", "ggx", "--sort", "snr"};
    QTest::newRow("no threads") << QStringList{"info", plastic_, "--threads", "0"};
    QTest::newRow("unknown parameter") << QStringList{"edit",  plastic_,  "--model", "ggx",
                                                      "--set", "gloss=1", "--out",   folder_.path("x.binary")};
    QTest::newRow("no value") << QStringList{"edit",  plastic_, "--model", "ggx",
                                             "--set", "f0=",    "--out",   folder_.path("x.binary")};
    QTest::newRow("two values") << QStringList{"edit",  plastic_,      "--model", "ggx",
                                               "--set", "diffuse=1,2", "--out",   folder_.path("x.binary")};
    QTest::newRow("channels of a shared parameter")
        << QStringList{"edit", plastic_, "--model", "ggx", "--set", "f0=1,0,1", "--out", folder_.path("x.binary")};
    QTest::newRow("size") << QStringList{"render", plastic_, "--size", "12y9", "--out", folder_.path("x.png")};
    QTest::newRow("two lights") << QStringList{"render", plastic_,        "--light", "1",     "1",
                                               "1",      "--environment", "studio",  "--out", folder_.path("x.png")};
    QTest::newRow("picture format") << QStringList{"render", plastic_, "--out", folder_.path("x.jpg")};
  }
  void wrongUsageIsTwo() {
    QFETCH(QStringList, arguments);
    const ToolResult result = runTool(arguments);
    QCOMPARE(result.code, 2);
    QVERIFY(!result.error.isEmpty());
    QVERIFY(result.out.isEmpty());
  }

  /// An output never replaces a file that the command reads, under whatever name it is given, nor the file that a
  /// document edits; with --force it does.
  void anInputIsNeverReplaced() {
    const QString own = folder_.writeTable("own.binary", "ggx", plastic), document = folder_.path("own.gonio");
    const QByteArray before = bytesOf(own);
    const QString link = folder_.path("link.binary");
    QVERIFY(QFile::link(own, link));
    const ToolResult edited = runTool({"edit", own, "--model", "ggx", "--control", "roughness=2", "--out", document});
    QCOMPARE(edited.code, 0);
    const QByteArray written = bytesOf(document);
    const QString series = folder_.writeTable("series-1.binary", "ggx", plastic);
    QCOMPARE(bytesOf(series), before);
    for (const QStringList& arguments :
         {QStringList{"convert", own, own}, QStringList{"convert", own, link}, QStringList{"convert", document, own},
          QStringList{"edit", own, "--model", "ggx", "--control", "roughness=2", "--out", own},
          QStringList{"edit", document, "--model", "ggx", "--control", "roughness=2", "--out", document},
          QStringList{"fit", own, "--model", "ggx", "--out", own}, QStringList{"render", own, "--out", own},
          QStringList{"interpolate", own, plastic_, "--out", own},
          QStringList{"factor", own, "--terms", "1", "--decode", own},
          QStringList{"interpolate", series, plastic_, "--steps", "3", "--out", folder_.path("series.binary")},
          QStringList{"export", document, folder_.path("own"), "--for", "merl"}}) {
      const ToolResult result = runTool(arguments);
      QVERIFY2(result.code == 1 && result.error.count('\n') == 1, qPrintable(arguments.join(' ') + result.error));
      QVERIFY2(result.error.contains("the command reads this file"), qPrintable(result.error));
      QVERIFY(bytesOf(own) == before && bytesOf(document) == written && bytesOf(series) == before);
    }
    QCOMPARE(runTool({"convert", document, own, "--force"}).code, 0);
    QVERIFY(bytesOf(own) != before);
  }

  void failuresAreOneLine_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("names");
    const QString garbage = folder_.path("garbage.binary"), missing = folder_.path("missing.binary");
    const QString shortened = folder_.path("short.binary"), document = folder_.path("garbage.gonio");
    folder_.writeText("garbage.binary", "this is no material");
    folder_.writeText("short.binary", bytesOf(plastic_).left(5000));
    folder_.writeText("garbage.gonio", "{\"format\": \"other\"}");
    QTest::newRow("missing") << QStringList{"info", missing} << "missing.binary";
    QTest::newRow("folder") << QStringList{"info", folder_.path()} << "goniotool";
    // Nobody writes to it: it is not waited for.
    const QString pipe = folder_.path("pipe.binary");
    QVERIFY(::mkfifo(qPrintable(pipe), 0600) == 0);
    QTest::newRow("pipe") << QStringList{"info", pipe} << "pipe.binary: found a folder, a device, a pipe or a socket";
    QTest::newRow("pipe as document") << QStringList{"render", pipe, "--out", folder_.path("x.png")} << "pipe.binary";
    QTest::newRow("pipe as output") << QStringList{"convert", plastic_, pipe} << "pipe.binary: cannot be written";
    QTest::newRow("garbage") << QStringList{"fit", garbage, "--model", "ggx"} << "garbage.binary";
    QTest::newRow("short") << QStringList{"check", shortened} << "short.binary";
    QTest::newRow("document") << QStringList{"info", document} << "garbage.gonio";
    QTest::newRow("suffix") << QStringList{"convert", plastic_, folder_.path("out.xyz")}
                            << "out.xyz: found the suffix '.xyz', expected .binary, .bsdf or .bin";
    QTest::newRow("no folder") << QStringList{"convert", plastic_, folder_.path("no/out.binary")} << "out.binary";
    QTest::newRow("environment") << QStringList{"render", plastic_, "--environment",
                                                garbage,  "--out",  folder_.path("x.png")}
                                 << "garbage.binary";
    QTest::newRow("directions") << QStringList{"evaluate", plastic_, "--directions",
                                               missing,    "--out",  folder_.path("x.csv")}
                                << "missing.binary";
    const QString dictionary = folder_.path("missing.dictionary");
    QTest::newRow("dictionary") << QStringList{"encode", plastic_, "--dictionary", dictionary} << "missing.dictionary";
    const QString broken = folder_.path("broken.exr");
    Image image(2, 1);
    image.pixels[1] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    io::writeExr(image, broken.toStdString());
    QTest::newRow("environment with NaN")
        << QStringList{"render", plastic_, "--environment", broken, "--out", folder_.path("x.png")} << "broken.exr";
    const QByteArray nested = QByteArray(250'000, '[') + QByteArray(250'000, ']');
    folder_.writeText("nested.json", nested);
    folder_.writeText("nested.gonio", "{\"format\": \"gonio document\", \"view\": " + nested + "}");
    QTest::newRow("nested scene") << QStringList{"render",  plastic_,
                                                 "--scene", folder_.path("nested.json"),
                                                 "--out",   folder_.path("x.png")}
                                  << "nested.json: found JSON nested deeper than 64 levels";
    QTest::newRow("nested document") << QStringList{"info", folder_.path("nested.gonio")}
                                     << "nested.gonio: found JSON nested deeper than 64 levels";
  }
  void failuresAreOneLine() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, names);
    const ToolResult result = runJson(arguments);
    QCOMPARE(result.code, 1);
    QCOMPARE(result.errorLines(), 1);
    const QString reported = result.error.mid(QString("goniotool: ").size());
    QVERIFY2(result.error.startsWith("goniotool: ") && reported.count(names) == 1, qPrintable(result.error));
    QVERIFY(result.out.isEmpty());
  }

  /// Bytes of a damaged file that an error quotes: line breaks of any kind would make two lines, and escape sequences
  /// would control the terminal.
  void quotedBytesAreHarmless() {
    const QString environment = folder_.path("readings.csv");
    folder_.writeText("readings.csv",
                      "# method: factors\n# \x1b[31m\x0b\xc2\x85\xe2\x80\xa8\xff\xe4,a,b\n1,2,3,4,5,6,7,8\n");
    const ToolResult result =
        runTool({"measure", "--factors", "half-out", "--values", environment, "--predict", folder_.path("x.pdv")});
    QCOMPARE(result.code, 1);
    QCOMPARE(result.errorLines(), 1);
    for (const QChar c : result.error.trimmed())
      QVERIFY2(c.isPrint() && c.category() != QChar::Separator_Line, qPrintable(result.error));
  }

  /// A black material has no signal to compare with.
  void undefinedNumbersAreNamed() {
    const QString black = folder_.writeTable("black.binary", "lambert", {{Rgb(0)}}, HalfDifferenceGrid{});
    const ToolResult result = runTool({"encode", black, "--out", folder_.path("black.code")});
    QCOMPARE(result.code, 0);
    QVERIFY2(result.out.contains("BRDF SNR undefined") && !result.out.contains("nan"), qPrintable(result.out));
  }

  void progressIsOnStandardErrorOnly() {
    const ToolResult shown = runJson({"fit", plastic_, "--model", "ggx", "--progress"});
    VERIFY_SUCCESS(shown);
    QVERIFY(shown.json.is_object());
    QVERIFY(shown.error.contains("fitting ggx 100 %"));
    QVERIFY(runJson({"fit", plastic_, "--model", "lambert"}).error.isEmpty());
  }

 private:
  TestFolder folder_{"goniotool-errors"};
  QString plastic_;
};

GONIO_TEST(GoniotoolErrorsTest)
}  // namespace goniotool_errors_test

#include "goniotool_errors_test.moc"
