// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QJsonDocument>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>
#include <cstring>
#include <fstream>

#include "core/figures/figure_formats.h"
#include "core/figures/figure_tables.h"
#include "core/plots/svg_drawing.h"
#include "core/support/text.h"
#include "tests/core/figures/small_figure.h"
#include "tests/support/hostile_names.h"
#include "tests/support/spreadsheet.h"
#include "tests/support/test_program.h"

/// Names of any content in every file of a figure, read by the parser of its format, or by one written here by its
/// rules.
namespace figure_names_test {
using namespace gonio;
using namespace gonio::figures;

FigureDescription figureNamed(const std::string& name) {
  FigureDescription figure = test::smallFigure();
  figure.title = figure.materials[1].label = figure.representations[1].label = name;
  figure.font = figure.pictures.scene = figure.pictures.environment = name;
  return figure;
}

QString textOf(const std::string& text) { return QString::fromStdString(text); }

/// What LaTeX typesets of a cell, with straight quotes; "wrong: ..." where it reads a command, a ligature or an option.
std::string typeset(const std::string& latex) {
  const std::vector<std::pair<std::string, std::string>> commands{{"\\textbackslash{}", "\\"},
                                                                  {"\\textasciitilde{}", "~"},
                                                                  {"\\textasciicircum{}", "^"},
                                                                  {"\\textless{}", "<"},
                                                                  {"\\textgreater{}", ">"},
                                                                  {"\\textbar{}", "|"},
                                                                  {"\\symbol{34}", "\""},
                                                                  {"\\symbol{96}", "`"},
                                                                  {"\\&", "&"},
                                                                  {"\\%", "%"},
                                                                  {"\\$", "$"},
                                                                  {"\\#", "#"},
                                                                  {"\\_", "_"},
                                                                  {"\\{", "{"},
                                                                  {"\\}", "}"},
                                                                  {"{[}", "["},
                                                                  {"{}", ""}};
  std::string shown;
  for (std::size_t at = 0; at < latex.size();) {
    const auto command = std::ranges::find_if(
        commands, [&](const auto& known) { return latex.compare(at, known.first.size(), known.first) == 0; });
    if (command != commands.end()) {
      shown += command->second;
      at += command->first.size();
      continue;
    }
    const char c = latex[at++];
    const bool isLigature =
        std::string_view("-',").find(c) != std::string_view::npos && latex.substr(at).starts_with(c);
    const bool isOption = c == '[' && shown.find_first_not_of(' ') == std::string::npos;
    if (isLigature || isOption || std::string_view("\\{}&%$#_~^<>|\"`\n\r").find(c) != std::string_view::npos)
      return "wrong: " + latex.substr(at - 1);
    shown += c;
  }
  return shown;
}

class FigureNamesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyFileIsReadAsItIs_data() {
    QTest::addColumn<std::string>("name");
    for (const test::HostileName& name : test::hostileNames()) QTest::newRow(name.id) << name.text;
  }
  void everyFileIsReadAsItIs() {
    QFETCH(std::string, name);
    const FigureDescription figure = figureNamed(name);
    const FigureMeasurement measurement = test::madeUpMeasurement(figure);
    const std::string shown = name.empty() ? figure.materials[1].path : plainText(name);
    checkCsv(io::toCsv(figureCsv(figure, measurement)), shown);
    checkLatex(figureLatex(figure, measurement), shown);
    checkJson(figure, name);
    if (name.size() > 1000) return;  // a page has no place for it
    checkSvg(figureFile(figure, measurement, FigureFormat::svg), shown);
    const std::vector<std::byte> pdf = figureFile(figure, measurement, FigureFormat::pdf);
    QVERIFY(pdf.size() > 4 && std::memcmp(pdf.data(), "%PDF", 4) == 0);
    QVERIFY(!figureFile(figure, measurement, FigureFormat::png, 50).empty());
  }

  void drawings() {
    for (const test::HostileName& name : test::hostileNames()) {
      plots::SvgDrawing svg(10, 10, {.unit = {}, .fontFamily = name.text});
      svg.marker(plots::Marker::circle, {5, 5}, 1, "#000000", false, name.text + "x");
      svg.text({5, 5}, name.text);
      QXmlStreamReader xml(QByteArray::fromStdString(svg.str()));
      QStringList texts;
      while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.attributes().hasAttribute("font-family")) texts << xml.attributes().value("font-family").toString();
        if (xml.name() == QLatin1String("title") || xml.name() == QLatin1String("text")) texts << xml.readElementText();
      }
      QVERIFY2(!xml.hasError(), name.id);
      const QString plain = textOf(plainText(name.text));
      QCOMPARE(texts, (QStringList{plain, plain + "x", plain}));
    }
  }

  /// Without an error, a page with the tables of all names that its fonts have.
  void latexReadsTheTables() {
    if (QStandardPaths::findExecutable("pdflatex").isEmpty()) QSKIP("pdflatex is not installed");
    QTemporaryDir folder;
    std::ofstream document(folder.filePath("a.tex").toStdString());
    document << "\\documentclass{article}\n\\usepackage{booktabs}\n\\begin{document}\n";
    for (const test::HostileName& name : test::hostileNames()) {
      if (name.id == std::string("wide") || name.id == std::string("marks") || name.id == std::string("invalid"))
        continue;
      const FigureDescription figure = figureNamed(name.text);
      document << figureLatex(figure, test::madeUpMeasurement(figure)) << "\n";
    }
    document << "\\end{document}\n";
    document.close();
    QProcess latex;
    latex.setWorkingDirectory(folder.path());
    latex.start("pdflatex", {"-halt-on-error", "-interaction=nonstopmode", "a.tex"});
    QVERIFY(latex.waitForFinished(120000));
    QVERIFY2(latex.exitCode() == 0, latex.readAllStandardOutput().constData());
  }

 private:
  /// Its lines, without the spaces at which they are broken.
  static void checkSvg(const std::vector<std::byte>& bytes, const std::string& shown) {
    QXmlStreamReader xml(QByteArray(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())));
    QString all;
    while (!xml.atEnd())
      if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QLatin1String("text"))
        all += xml.readElementText();
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QVERIFY(all.remove(' ').contains(textOf(shown).remove(' ')));
  }

  static void checkCsv(const std::string& csv, const std::string& shown) {
    for (const char separator : {',', ';', '\t'})
      QVERIFY(!test::hasCalculatedCell(test::spreadsheetRows(csv, separator)));
    const test::SpreadsheetRows rows = test::spreadsheetRows(csv);
    QCOMPARE(qsizetype(rows.size()), QByteArray::fromStdString(csv).count('\n'));
    const std::vector<std::string>& last = rows.back();
    QCOMPARE(last.size(), rows[rows.size() - 5].size());  // the titles
    std::string cell = last[0], expected = shown;
    for (std::string* text : {&cell, &expected}) std::erase(*text, '\'');
    QCOMPARE(cell, expected);
  }

  static void checkLatex(const std::string& latex, const std::string& shown) {
    const QStringList lines = textOf(latex).split('\n');
    QCOMPARE(lines.size(), 14);
    QVERIFY(lines[0].startsWith("% Pictures: ") && lines[1].startsWith("% Needs") && lines[2].startsWith("\\begin"));
    const QString row = lines[9];  // the first of the second material
    QVERIFY2(lines[8] == "\\midrule" && row.endsWith(" \\\\"), qPrintable(row));
    const auto end = QRegularExpression(" & GGX & ").match(row).capturedStart();
    QCOMPARE(textOf(typeset(row.left(end).toStdString())), textOf(shown));
  }

  static void checkJson(const FigureDescription& figure, const std::string& name) {
    try {
      const std::string text = figureDescriptionText(figure, "a.json");
      const QString title = QJsonDocument::fromJson(QByteArray::fromStdString(text))["title"].toString();
      QCOMPARE(title, textOf(name));
    } catch (const Error& error) {
      QVERIFY2(plainText(name) != name && std::string(error.what()).starts_with("title: found "), error.what());
    }
  }
};

GONIO_TEST(FigureNamesTest)
}  // namespace figure_names_test

#include "figure_names_test.moc"
