// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/csv_text.h"

#include <QTest>
#include <array>

#include "core/support/text.h"
#include "tests/core/io/test_files.h"
#include "tests/support/hostile_names.h"
#include "tests/support/spreadsheet.h"
#include "tests/support/test_program.h"

namespace csv_text_test {
using namespace gonio;
using namespace gonio::test;

constexpr std::array<std::string_view, 2> names{"x", "y"};
using Strings = std::vector<std::string>;

/// Files of plans test what spreadsheets write (plan_file_test.cpp); here is what all tables share.
class CsvTextTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void namesAndRows() {
    const io::CsvText csv = io::readCsvText("# note\nName,Value\na, 1\n\n\"b\",+2e1\r\n");
    QCOMPARE(csv.comments, Strings{"note"});
    QCOMPARE(csv.names, (Strings{"name", "value"}));
    QCOMPARE(csv.rows.size(), std::size_t(2));
    QCOMPARE(csv.rows[1].line, std::size_t(5));
    QCOMPARE(csv.rows[1].fields[csv.requiredColumn("name")], std::string("b"));
    QCOMPARE(csv.number(csv.rows[1], 1), 20.0);
    QCOMPARE(csv.integer(csv.rows[0], 1), 1);
    QVERIFY(!csv.column("other"));
  }

  /// A first line of numbers is a row where the names are given; more columns than these are named by their number.
  void tablesWithoutNames() {
    const io::CsvText csv = io::readCsvText("# note\n1.5,2,a\n3,4,b\n", names);
    QCOMPARE(csv.names, (Strings{"x", "y", "3"}));
    QCOMPARE(csv.rows.size(), std::size_t(2));
    QCOMPARE(csv.number(csv.rows[0], csv.requiredColumn("x")), 1.5);
    QCOMPARE(csv.rows[1].fields[2], std::string("b"));
    const io::CsvText commas = io::readCsvText("1,5;2\n", names);
    QCOMPARE(commas.number(commas.rows[0], 0), 1.5);
    const io::CsvText named = io::readCsvText("y,x\n1,2\n", names);
    QCOMPARE(named.number(named.rows[0], named.requiredColumn("x")), 2.0);
    QVERIFY(contains(errorOf([] { io::readCsvText("1\n", names); }), "line 1: found 1 columns, expected 2: x, y"));
    QCOMPARE(io::readCsvText("1,2\n").names, (Strings{"1", "2"}));
  }

  /// Rows may have another separator than the names; numbers have one decimal sign.
  void separatorsAndDecimalSigns() {
    for (const char* text : {"x,y\n1,5;2\n", "x;y\n1,5;2\n", "x\ty\n1,5\t2\n", "x y\n1.5  2\n", "x,y\n1,5 2\n",
                             "x,y\n\"1,5\",2\n", "\"x; a\",y\n1.5,2\n"}) {
      const io::CsvText csv = io::readCsvText(text);
      QCOMPARE(csv.names.size(), std::size_t(2));
      QCOMPARE(csv.number(csv.rows[0], 0), 1.5);
      QCOMPARE(csv.number(csv.rows[0], 1), 2.0);
    }
    QCOMPARE(io::readCsvText("x;y\n1,5;2\n").notationText(), std::string("separated by semicolons, decimal commas"));
    QCOMPARE(errorOf([] { io::readCsvText("x;y\n1,234;2\n3;0.5\n"); }),
             std::string("found '1,234' in line 2 and '0.5' in line 3, expected one decimal sign"));
    QVERIFY(contains(errorOf([] { io::readCsvText("x,y\n1,5,2,5\n"); }), "if commas are decimal signs"));
  }

  void quotedFieldsContainSeparators() {
    const io::CsvText csv = io::readCsvText("name,value\n\"a,\"\"b\"\"\" ,\" 5 \"\n\"\",1\n'=x,'y\nfive\" x,\"6\n");
    QCOMPARE(csv.rows[0].fields, (Strings{"a,\"b\"", "5"}));
    QCOMPARE(csv.rows[1].fields, (Strings{"", "1"}));
    QCOMPARE(csv.rows[2].fields, (Strings{"=x", "'y"}));
    QCOMPARE(csv.rows[3].fields, (Strings{"five\" x", "6"}));
  }

  /// As itself by Gonio, without a formula by spreadsheets.
  void fieldsAreReadBack() {
    auto hostile = hostileNames();
    for (const char* text :
         {"'=1", "''=1", "'a'", " =1", "\"=1\"", "#1 gold", "a;b", "a;'=b", "a; =1", "a;\"=1\"", "\uff1d1", "-"})
      hostile.push_back({text, text});
    for (const HostileName& name : hostile) {
      const std::string field = io::csvField(name.text), plain = plainText(name.text);
      const io::CsvText csv = io::readCsvText("name,value\n" + field + ",1\n");
      QVERIFY2(csv.rows.size() == 1, name.id);
      QCOMPARE(QString::fromStdString(csv.rows[0].fields[0]).trimmed(), QString::fromStdString(plain).trimmed());
      const SpreadsheetRows rows = spreadsheetRows("1," + field + ",1\n");
      QVERIFY2(rows.size() == 1 && rows[0].size() == 3 && !hasCalculatedCell(rows), field.c_str());
      std::string cell = rows[0][1], expected = plain;
      for (std::string* text : {&cell, &expected}) std::erase(*text, '\'');
      QCOMPARE(cell, expected);
      const SpreadsheetRows others = spreadsheetRows("1," + field + ",1\n2\n", ';');
      QVERIFY2(others.size() == 2 && !hasCalculatedCell(others), field.c_str());
    }
  }

  void harmlessFieldsAreUnchanged() {
    for (const char* text : {"chrome", "it's 5 a - b", "1/sr", ""}) QCOMPARE(io::csvField(text), std::string(text));
    QCOMPARE(io::csvField("a, \"b\""), std::string("\"a, \"\"b\"\"\""));
  }

  /// One line, and no cell of it begins a formula or a quoted field.
  void commentsAreText() {
    auto hostile = hostileNames();
    for (const char* text : {"a, =1", "a,\"=1\"", "a;@b", "a,\"b", "a, \"b"}) hostile.push_back({text, text});
    for (const HostileName& name : hostile) {
      const std::string comment = io::csvComment(name.text);
      for (const char separator : {',', ';', '\t'}) {
        const SpreadsheetRows rows = spreadsheetRows(comment + "1,2;3\t4\n", separator);
        QVERIFY2(rows.size() == 2 && !hasCalculatedCell(rows), comment.c_str());
      }
      QCOMPARE(io::readCsvText(comment + "name\n").comments.size(), std::size_t(1));
    }
    QCOMPARE(io::csvComment("a, b: c = 1, -2"), std::string("# a, b: c = 1,' -2\n"));
  }

  void errorsStateLineAndColumn() {
    const io::CsvText csv = io::readCsvText("name,value\na,1e400\nb,1.5\n");
    QCOMPARE(errorOf([&] { csv.number(csv.rows[0], 1); }),
             std::string("line 2: found '1e400' for value, expected a finite number"));
    QCOMPARE(errorOf([&] { csv.integer(csv.rows[1], 1); }),
             std::string("line 3: found '1.5' for value, expected a whole number"));
    QCOMPARE(errorOf([&] { csv.requiredColumn("size"); }),
             std::string("line 1: found the columns name, value, expected one named size"));
    QCOMPARE(errorOf([] { io::readCsvText("a,b\n1\n"); }), std::string("line 2: found 1 columns, expected 2: a, b"));
    QVERIFY(contains(errorOf([] { io::readCsvText("# only\n"); }), "no header line with column names"));
    QVERIFY(contains(errorOf([] { io::readText(outputPath("io/no_such_table.csv")); }), "cannot be opened"));
  }

  void tablesAreWritten() {
    const std::string text =
        io::toCsv({{"first", "two\nlines"}, {{"theta, \"x\"", {0.1, 1e-300}}, {"f [1/sr]", {std::nan(""), -2}}}});
    QCOMPARE(text, std::string("# first\n# two lines\n\"theta, \"\"x\"\"\",f [1/sr]\n0.1,\n1e-300,-2\n"));
    QCOMPARE(io::toCsv({}), std::string("\n"));
  }
};

GONIO_TEST(CsvTextTest)
}  // namespace csv_text_test

#include "csv_text_test.moc"
