// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/number_field.h"

#include <QTest>

#include "tests/support/test_program.h"

namespace arithmetic_test {
using gonio::widgets::evaluateArithmetic;

class ArithmeticTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void accepts_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value");
    QTest::newRow("number") << "0.25" << 0.25;
    QTest::newRow("product") << "0.3*2" << 0.3 * 2;
    QTest::newRow("comma") << "0,5 + 1" << 1.5;
    QTest::newRow("precedence") << "1+2*3" << 7.0;
    QTest::newRow("left to right") << "8/4/2-1-1" << -1.0;
    QTest::newRow("parentheses") << "(1+2)*3" << 9.0;
    QTest::newRow("power of a sign") << "-2^2" << -4.0;
    QTest::newRow("negative power") << "2^-1" << 0.5;
    QTest::newRow("exponent") << "1.5e-3" << 1.5e-3;
    QTest::newRow("unit") << "0.5 1/sr" << 0.5;
    QTest::newRow("pi") << "pi/2" << 1.5707963267948966;
    QTest::newRow("leading point") << ".5" << 0.5;
  }
  void accepts() {
    QFETCH(QString, text);
    QFETCH(double, value);
    const auto result = evaluateArithmetic(text, QStringLiteral("1/sr"));
    QVERIFY(result.has_value());
    QCOMPARE(*result, value);
  }

  void degrees() {
    for (const char* text : {"2 * 15", "30\u00b0", "30 deg"})
      QCOMPARE(evaluateArithmetic(QString::fromUtf8(text), QStringLiteral("°")), std::optional(30.0));
    QVERIFY(!evaluateArithmetic(QStringLiteral("30 deg"), QStringLiteral("1/sr")));
  }

  void refuses_data() {
    QTest::addColumn<QString>("text");
    for (const char* text : {"", "abc", "1+", "1 2", "1/0", "(1", "1)", "1..2", "0/0", "1e", "--", "inf", "nan"})
      QTest::newRow(text) << QString::fromLatin1(text);
    QTest::newRow("deep") << QString(1000000, '(');
    QTest::newRow("many signs") << QString(1000000, '-') + "1";
  }
  void refuses() {
    QFETCH(QString, text);
    QVERIFY(!evaluateArithmetic(text).has_value());
  }
};

GONIO_TEST(ArithmeticTest)
}  // namespace arithmetic_test

#include "arithmetic_test.moc"
