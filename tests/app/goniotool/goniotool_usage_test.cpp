// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QRegularExpression>
#include <QTest>
#include <map>

#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_usage_test {
using namespace gonio;
using namespace gonio::test;

/// An option of a subcommand, as its help describes it.
struct HelpOption {
  QStringList command;  ///< "dictionary", "train"
  QString name, word;   ///< "--light", "X Y Z"
};

QRegularExpression lines(const char* pattern) {
  return QRegularExpression(pattern, QRegularExpression::MultilineOption);
}

QStringList subcommandsOf(const QString& help) {
  const qsizetype begin = help.indexOf("Subcommands:");
  QStringList names;
  if (begin < 0) return names;
  auto found = lines("^  ([a-z][a-z-]*) ").globalMatch(help.mid(begin, help.indexOf("\n\n", begin) - begin));
  while (found.hasNext()) names << found.next().captured(1);
  return names;
}

/// Of the command and its subcommands, but flags.
void addOptions(const QStringList& command, std::vector<HelpOption>& options) {
  const QString help = runTool(command + QStringList{"--help"}).out;
  for (const QString& name : subcommandsOf(help)) addOptions(command + QStringList{name}, options);
  auto found = lines("^  (?:-\\w,)?--([a-z0-9-]+)(?:,--[a-z-]+)? (\\[?[A-Z{][^ ]*(?: [A-Z]+\\b)*)").globalMatch(help);
  while (found.hasNext()) {
    const auto match = found.next();
    options.push_back(
        {command, "--" + match.captured(1), match.captured(2).remove('[').remove(']').remove(" REQUIRED")});
  }
}

const std::vector<HelpOption>& allOptions() {
  static const std::vector<HelpOption> options = [] {
    std::vector<HelpOption> found;
    addOptions({}, found);
    return found;
  }();
  return options;
}

/// Words of options whose values are not numbers.
bool isText(const QString& word) {
  static const QRegularExpression names("^(\\{.*|(NAME|FILE|FOLDER|MATERIAL|ID)(\\|.*)?|TEXT)$");
  return names.match(word).hasMatch();
}

/// The values of an option in which a number is `number`.
QStringList valuesWith(const QString& word, const QString& number) {
  static const std::map<QString, const char*> forms{
      {"NAME=VALUE", "roughness=%1"}, {"RANGES", "theta_o=%1:90"}, {"I/N", "1/%1"}, {"N|WIDTHxHEIGHT", "64x%1"}};
  const auto form = forms.find(word);
  if (form != forms.end()) return {QString(form->second).arg(number)};
  return QStringList(word.split(' ').size(), number);
}

/// Messages about wrong command lines: they name what was found, and what is expected.
class GoniotoolUsageTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic); }

  void numbersAreFinite_data() {
    QTest::addColumn<QString>("number");
    for (const char* number : {"nan", "NAN", "inf", "-inf", "infinity", "1e999", "-1e999"})
      QTest::newRow(number) << number;
  }
  /// Every option of every subcommand that takes a number, with nan; every tenth with the other numbers, which the same
  /// function refuses. Options are checked before required arguments are missed.
  void numbersAreFinite() {
    QFETCH(QString, number);
    int numeric = 0;
    std::set<QString> commands;
    for (const HelpOption& option : allOptions()) {
      if (isText(option.word)) continue;
      ++numeric;
      commands.insert(option.command.join(' '));
      if (number != "nan" && numeric % 10 != 1) continue;
      const ToolResult result = runTool(option.command + QStringList{option.name} + valuesWith(option.word, number));
      const QString what = (option.command + QStringList{option.name, option.word, result.error}).join(' ');
      QVERIFY2(result.code == 2 && result.errorLines() == 1, qPrintable(what));
      for (const QString& part : {option.name, number, QString("expected")})
        QVERIFY2(result.error.contains(part), qPrintable(what));
    }
    QVERIFY2(numeric >= 85 && commands.size() >= 16, qPrintable(QString("%1 %2").arg(numeric).arg(commands.size())));
  }

  void integersAreWithinTheirType() {
    for (const char* number : {"-1", "99999999999999999999999", "1.5", "1e3", "x", ""}) {
      const ToolResult result = runTool({"render", "--seed", number});
      QVERIFY2(result.code == 2 && result.error.contains("--seed: found "), qPrintable(result.error));
    }
    const ToolResult large = runTool({"figure", "--samples", "5000000000"});
    QVERIFY2(large.error.contains("--samples: found '5000000000', expected an integer"), qPrintable(large.error));
  }

  void wrongUsageIsExplained_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const QStringList& arguments, const QString& message) {
      QTest::newRow(name) << arguments << message;
    };
    row("nothing", {}, "goniotool: found no subcommand, expected info, evaluate, check,");
    row("unknown subcommand", {"nosuch"}, "goniotool: found the subcommand 'nosuch', expected info, evaluate,");
    row("misspelt subcommand", {"--json", "redner", "x"}, "found the subcommand 'redner' (did you mean render?), ");
    row("inner subcommand", {"dictionary", "trian"},
        "dictionary: found the subcommand 'trian' (did you mean train?), expected train, info; see goniotool "
        "dictionary "
        "--help");
    row("no inner subcommand", {"dictionary"}, "dictionary: found no subcommand, expected train, info");
    row("misspelt option", {"edit", "x", "--strenght", "0.5"},
        "edit: unknown option --strenght (did you mean --strength?); see goniotool edit --help");
    row("instead of a required one", {"edit", "x", "--model", "ggx", "--ouput=y"},
        "edit: unknown option --ouput (did you mean --out?); ");
    row("option before the subcommand", {"--strength", "1", "edit", "x"},
        "edit: the option --strength belongs behind the subcommand");
    row("argument too many", {"info", "x", "y"}, "info: found 'y', expected no further argument");
    row("missing argument", {"info"}, "info: MATERIAL is required; see goniotool info --help");
    row("missing value", {"edit", "x", "--out"}, "edit: --out: found 0 values, expected 1: FILE");
    row("option as a value", {"edit", "x", "--out", "--model", "ggx"},
        "edit: --out: found the option --model, expected a value");
    row("too few values", {"render", "x", "--light", "1", "2"}, "--light: found 2 values, expected 3: X Y Z");
    row("given twice", {"edit", "x", "--strength", "0.5", "--strength", "0.7"},
        "edit: --strength is given 2 times, expected once");
    row("one material", {"interpolate", "x", "--out", "y"}, "interpolate: MATERIAL: found 1 value, expected 2 to 16");
    row("model", {"fit", "x", "--model", "GGXX"}, "fit: --model: found 'GGXX' (did you mean ");
    row("target", {"export", "x", "y", "--for", "mitsbua"},
        "export: --for: found 'mitsbua' (did you mean mitsuba?), expected ");
    row("range", {"edit", "x", "--strength", "2"}, "edit: --strength: found '2', expected a number from 0 to 1;");
    row("small limit", {"render", "x", "--remainder", "2"},
        "--remainder: found '2', expected a number from 1e-9 to 1;");
    row("positive", {"encode", "x", "--bytes", "0"}, "--bytes: found '0', expected an integer above 0");
    row("empty name", {"info", ""}, "info: MATERIAL: found an empty text, expected a value");
    row("empty output", {"convert", "x", ""}, "convert: OUT: found an empty text, expected a value");
    row("value of a parameter", {"edit", "x", "--model", "ggx", "--set", "f0=nan", "--out", "y"},
        "edit: --set: found 'f0=nan', expected finite numbers");
    row("channels", {"edit", "x", "--model", "ggx", "--set", "f0=1,0,1", "--out", "y.gonio"},
        "edit: found 'f0=1,0,1', expected one number, which is for all channels");
    row("no number", {"edit", "x", "--model", "ggx", "--set", "f0=a", "--out", "y.gonio"},
        "edit: found 'f0=a', expected name=value or name=red,green,blue with finite numbers");
    row("one of a list", {"interpolate", "x", "y", "--weights", "0.5,nan", "--out", "z"},
        "interpolate: --weights: found 'nan', expected a finite number");
    row("region", {"plan", "--forbid", "theta_o=0:inf"}, "plan: --forbid: found 'theta_o=0:inf', expected ranges such");
  }
  void wrongUsageIsExplained() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, message);
    const ToolResult result = runTool(arguments);
    QVERIFY2(result.code == 2 && result.errorLines() == 1 && result.out.isEmpty(), qPrintable(result.error));
    QVERIFY2(result.error.startsWith("goniotool: ") && result.error.contains(message), qPrintable(result.error));
  }

  /// A title may be empty: it removes that of a description.
  void freeTextMayBeEmpty() {
    const ToolResult result = runTool({"figure", "--title", "", "--out", "x.png"});
    QVERIFY2(result.error.contains("no materials were given"), qPrintable(result.error));
  }

  void directionsOfFilesAreFinite() {
    for (const char* number : {"nan", "inf", "1e999"}) {
      folder_.writeText("directions.csv", QByteArray("theta_i,phi_i,theta_o,phi_o\n10,0,") + number + ",180\n");
      const ToolResult result = runTool(
          {"evaluate", plastic_, "--directions", folder_.path("directions.csv"), "--out", folder_.path("values.csv")});
      QVERIFY2(result.code == 1 && result.error.contains("directions.csv: line 2: found '" + QString(number) +
                                                         "' for theta_o, expected a finite number"),
               qPrintable(result.error));
    }
  }

  /// As ulimit -f of a shell or batch system sets it: writing ends with an error, not the program.
  void theLimitOfFileSizesIsReported_data() {
    QTest::addColumn<QString>("out");
    for (const char* name : {"limited.binary", "limited.exr", "limited.png"}) QTest::newRow(name) << name;
  }
  void theLimitOfFileSizesIsReported() {
    QFETCH(QString, out);
    const QString path = folder_.path(out);
    const QStringList command = out.endsWith(".binary")
                                    ? QStringList{"fit", plastic_, "--model", "lambert", "--out", path}
                                    : QStringList{"render", plastic_, "--samples", "1", "--out", path};
    const QStringList before = QDir(folder_.path()).entryList(QDir::Files);
    const ToolResult result = runTool(command, 1024);
    QVERIFY2(result.code == 1 && result.errorLines() == 1, qPrintable(QString::number(result.code) + result.error));
    QVERIFY2(result.error.contains(path + ": cannot be written: File too large"), qPrintable(result.error));
    QCOMPARE(QDir(folder_.path()).entryList(QDir::Files), before);
    VERIFY_SUCCESS(runTool(command));
  }

 private:
  TestFolder folder_{"goniotool-usage"};
  QString plastic_;
};

GONIO_TEST(GoniotoolUsageTest)
}  // namespace goniotool_usage_test

#include "goniotool_usage_test.moc"
