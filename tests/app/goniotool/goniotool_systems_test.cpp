// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QRegularExpression>
#include <QTest>

#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_systems_test {
using namespace gonio;
using namespace gonio::test;

/// docs/systems.md contains only existing commands, options and kinds.
class GoniotoolSystemsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The help of each command contains its options and methods.
  void commandsOfThePageExist() {
    const QString page = QString::fromUtf8(bytesOf(QString(GONIO_DOCUMENTATION_DIR) + "/systems.md"));
    int commands = 0;
    auto spans = QRegularExpression("`goniotool ([^`]+)`").globalMatch(page);
    while (spans.hasNext()) {
      QStringList words = spans.next().captured(1).split(' ');
      if (words.last() == "...") words.removeLast();
      const bool isPair = words[0] == "dictionary" || words[0] == "photograph";
      const QStringList name = words.mid(0, isPair ? 2 : 1);
      const ToolResult help = runTool(name + QStringList{"--help"});
      VERIFY_SUCCESS(help);
      ++commands;
      for (qsizetype i = 0; i < words.size(); ++i) {
        if (!words[i].startsWith("--")) continue;
        QVERIFY2(help.out.contains(words[i]), qPrintable(words.join(' ')));
        if (words[i] != "--method") continue;
        QVERIFY2(words[i + 1] == "ID" || help.out.contains(words[i + 1]), qPrintable(words.join(' ')));
      }
    }
    QVERIFY(commands > 25);
  }

  /// The kinds in the column "study" are those of the study.
  void kindsOfTheStudyExist() {
    const QString page = QString::fromUtf8(bytesOf(QString(GONIO_DOCUMENTATION_DIR) + "/systems.md"));
    const ToolResult help = runTool({"study", "--help"});
    for (const char* kind : {"table", "fits", "factors", "codes", "components", "patches", "nonparametric",
                             "published-nonparametric", "baselines", "published", "neural"}) {
      QVERIFY2(page.contains(QString("| `%1` |").arg(kind)), kind);
      QVERIFY2(help.out.contains(kind), kind);
    }
  }

  /// Every subcommand has its table of options; so do the records. A name that does not exist is an error.
  void pagesAreCompleted() {
    const QString page = completePage("command-line");
    QVERIFY(!page.contains("<!-- "));
    for (const char* row :
         {"| `--threads` N (1 to 4096) | Number of threads [default: all cores] |",
          "| `--samples` N (1 to 4096) REQUIRED | Number of direction pairs |",
          "| `--size` N\\|WIDTHxHEIGHT | Size of the image, pixels: a number or WIDTHxHEIGHT [default: 256] |",
          "| `kautz-mccool` | ", "| `ciede2000` | ", "| `lab` | "})
      QVERIFY2(page.contains(row), row);
    const QRegularExpression command("^  ([a-z][a-z-]+) ", QRegularExpression::MultilineOption);
    const QString source = QString::fromUtf8(bytesOf(QString(GONIO_DOCUMENTATION_DIR) + "/command-line.md"));
    for (auto names = command.globalMatch(runTool({"--help"}).out); names.hasNext();) {
      const QString name = names.next().captured(1);
      QVERIFY2(source.contains("<!-- options: " + name), qPrintable(name));
    }
    const QString models = completePage("models");
    QVERIFY(models.contains("| `ggx` | k_d / pi + k_s D F G / (4 cos theta_i cos theta_o) | D = alpha^2 / (pi"));
    QVERIFY(models.contains("`roughness` alpha") && models.contains("| `edwards-disk` * |"));
    const TestFolder folder("goniotool-pages");
    folder.writeText("page.md", "# Page\n\n<!-- options: fitt -->\n");
    const ToolResult wrong = runTool({"--complete-page", folder.path("page.md")});
    QVERIFY(wrong.code == 1 && wrong.error.contains("no subcommand fitt"));
  }

  /// An option that writes a file but is not marked as an output could replace a file that the command reads.
  void optionsThatWriteAreOutputs() {
    const QRegularExpression command("^  ([a-z][a-z-]+) ", QRegularExpression::MultilineOption),
        writes("^  (--[a-z-]+) (?:FILE|FOLDER)[^-]*?(?:to write|to this file|(?:File|Folder) for )",
               QRegularExpression::MultilineOption),
        outputs("^Outputs:\n((?:  .*\n)+)", QRegularExpression::MultilineOption),
        option("^  (--[a-z-]+) ", QRegularExpression::MultilineOption);
    const auto allOf = [](const QRegularExpression& expression, const QString& text) {
      QStringList found;
      for (auto matches = expression.globalMatch(text); matches.hasNext();) found << matches.next().captured(1);
      found.sort();
      return found;
    };
    const QStringList names = allOf(command, runTool({"--help"}).out);
    QVERIFY(names.contains("factor") && names.contains("figure"));
    QStringList all;
    for (const QString& name : names) {
      const QString help = runTool({name, "--help"}).out;
      const QStringList marked = allOf(option, outputs.match(help).captured(1));
      QVERIFY2(marked == allOf(writes, help), qPrintable(name + ": " + marked.join(' ')));
      all << marked;
    }
    for (const char* known : {"--out", "--image", "--csv", "--latex", "--save", "--predict", "--decode"})
      QVERIFY2(all.contains(known), known);
  }

  /// The help names values by words, with ranges and defaults; MATERIAL is explained where it is an argument.
  void helpNamesTheValues() {
    const ToolResult plan = runTool({"plan", "--help"}), exported = runTool({"export", "--help"});
    VERIFY_SUCCESS(plan);
    VERIFY_SUCCESS(exported);
    for (const char* text :
         {"--samples N (1 to 4096) REQUIRED", "--train FILE|FOLDER ...", "[default: 85]", "Exit code: 0"})
      QVERIFY2(plan.out.contains(text), text);
    QVERIFY(!plan.out.contains("MATERIAL is one of"));
    for (const char* text : {"MATERIAL is one of", ".binary (MERL file, 360-degree MERL file)",
                             "--snr NUMBER (0 to 100)", "[default: 40]", "--scene [NAME|FILE]", "{mitsuba, pbrt,"})
      QVERIFY2(exported.out.contains(text), text);
    for (const char* type : {"TEXT", "INT", "FLOAT"}) QVERIFY2(!exported.out.contains(type), type);
  }
};

GONIO_TEST(GoniotoolSystemsTest)
}  // namespace goniotool_systems_test

#include "goniotool_systems_test.moc"
