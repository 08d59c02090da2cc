// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/json_text.h"

#include <QJsonDocument>
#include <QTest>

#include "tests/core/io/test_files.h"
#include "tests/support/hostile_names.h"
#include "tests/support/test_program.h"

namespace json_text_test {
using namespace gonio;
using test::contains;

/// A value in so many lists, or in so many objects.
std::string nested(bool objects, int levels) {
  std::string text;
  for (int i = 0; i < levels; ++i) text += objects ? "{\"a\":" : "[";
  return text + "1" + std::string(std::size_t(levels), objects ? '}' : ']');
}

class JsonTextTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void valuesAreRead() {
    const nlohmann::json json = io::parseJson(R"({"a": [1, 2.5, "x"], "b": {"c": null}})");
    QVERIFY(json == (nlohmann::json{{"a", {1, 2.5, "x"}}, {"b", {{"c", nullptr}}}}));
  }

  void depthIsLimited_data() {
    QTest::addColumn<bool>("objects");
    QTest::newRow("lists") << false;
    QTest::newRow("objects") << true;
  }
  void depthIsLimited() {
    QFETCH(bool, objects);
    const std::string limit = nested(objects, io::maxJsonDepth);
    QCOMPARE(io::parseJson(limit).dump(), limit);
    for (const int levels : {io::maxJsonDepth + 1, 250'000}) {
      const std::string error = test::errorOf([&] { io::parseJson(nested(objects, levels)); });
      QCOMPARE(error, std::string("found JSON nested deeper than 64 levels, the limit"));
    }
    // Without an end, beside values that are fine, and where the depth is in one of many members.
    QVERIFY(contains(test::errorOf([&] { io::parseJson(std::string(250'000, '[')); }), "nested"));
    QVERIFY(contains(test::errorOf([&] { io::parseJson("[1, {}, " + nested(objects, 64) + "]"); }), "nested"));
    QVERIFY(io::parseJson("[1, [], " + nested(objects, 63) + ", {}]").size() == 4);
  }

  void textsAreReadBack() {
    for (const test::HostileName& name : test::hostileNames()) {
      const nlohmann::ordered_json json{{"edits", {{{"name", name.text}}}}};
      const QJsonDocument read = QJsonDocument::fromJson(QByteArray::fromStdString(io::jsonText(json)));
      QVERIFY2(read.isObject(), name.id);
      const QString error =
          QString::fromStdString(test::errorOf([&] { QCOMPARE(io::exactJsonText(json), io::jsonText(json)); }));
      if (name.id == std::string("invalid"))
        QCOMPARE(error.left(40), QString("edits[0].name: found the string \"latin \uFFFD"));
      else
        QCOMPARE(read["edits"][0]["name"].toString(), QString::fromStdString(name.text));
    }
    QCOMPARE(io::jsonText(nlohmann::json{{"b", 1}, {"a", 2}}, 1), std::string("{\n \"a\": 2,\n \"b\": 1\n}"));
  }

  void otherTextIsRefused() {
    for (const char* text : {"", "nul", "[NaN]", "[Infinity]", "[-inf]", "[1,]", "\xff", "\xef\xbb[]"})
      QVERIFY2(contains(test::errorOf([&] { io::parseJson(text); }), "found text that is not JSON"), text);
    for (const char* number : {"1e999", "-1e999"})
      QCOMPARE(test::errorOf([&] { io::parseJson("{\"a\": " + std::string(number) + "}"); }),
               "found a number that is too large: '" + std::string(number) + "'");
  }

  /// However much of the text the parser has read last.
  void errorsAreShort() {
    for (const std::string& text : {"[\"" + std::string(100'000, 'x'), "[" + std::string(100'000, '9') + "e999]"})
      QVERIFY(test::errorOf([&] { io::parseJson(text); }).size() < 300);
  }

  void aByteOrderMarkIsSkipped() {
    QVERIFY(io::parseJson("\xef\xbb\xbf {\"a\": 1}") == (nlohmann::json{{"a", 1}}));
    QCOMPARE(io::parseJson("\xef\xbb\xbf[\"\xef\xbb\xbf\"]")[0].get<std::string>(), std::string("\xef\xbb\xbf"));
  }
};

GONIO_TEST(JsonTextTest)

}  // namespace json_text_test

#include "json_text_test.moc"
