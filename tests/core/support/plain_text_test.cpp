// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/support/text.h"

#include <QStringDecoder>
#include <QTest>
#include <QXmlStreamReader>
#include <random>

#include "tests/support/hostile_names.h"
#include "tests/support/test_program.h"

namespace plain_text_test {
using namespace gonio;

bool isUtf8(const std::string& text) {
  QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
  [[maybe_unused]] const QString decoded = decoder(QByteArray::fromStdString(text));
  return !decoder.hasError();
}

class PlainTextTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Every character of Unicode, as Qt writes it, is one, and is kept where it is no control and no separator.
  void everyCharacterIsRead() {
    for (char32_t code = 0; code <= 0x10ffff; ++code) {
      if (QChar::isSurrogate(code)) continue;
      const std::string text = QStringView(QChar::fromUcs4(code)).toUtf8().toStdString();
      const Utf8Character character = firstCharacter(text + "x");
      QCOMPARE(std::uint32_t(character.code), std::uint32_t(code));
      QCOMPARE(character.bytes, text.size());
      const auto category = QChar::category(code);
      const bool isPlain = category != QChar::Other_Control && category != QChar::Separator_Line &&
                           category != QChar::Separator_Paragraph && code != 0xfffe && code != 0xffff;
      QCOMPARE(character.isPlain(), isPlain);
      QCOMPARE(plainText(text), isPlain ? text : " ");
    }
  }

  /// Of random bytes, those that Qt also decodes are unchanged, and others become text that it decodes.
  void otherBytesAreReplaced() {
    std::mt19937 random(3);
    int valid = 0;
    for (int i = 0; i < 100000; ++i) {
      std::string text;
      for (int k = 0; k < 4; ++k) text += char(k == 0 ? 0xc0 + random() % 0x40 : 0x80 + random() % 0x50);
      const std::string plain = plainText(text);
      QVERIFY(isUtf8(plain));
      QCOMPARE(plainText(plain), plain);
      const bool isReplaced = plain.find("\xef\xbf\xbd") != std::string::npos;
      QCOMPARE(isReplaced, !isUtf8(text));
      valid += !isReplaced;
    }
    QVERIFY(valid > 100);
    QCOMPARE(plainText("a\xe9z \xed\xa0\x80 \xf0\x9f"), std::string("a\uFFFDz \uFFFD\uFFFD\uFFFD \uFFFD\uFFFD"));
    QCOMPARE(plainText(std::string("a\0b\r\nc\u0085d\u2028e", 13)), std::string("a b  c d e"));
  }

  void xmlIsReadBack() {
    for (const test::HostileName& name : test::hostileNames()) {
      const std::string text = xmlText(name.text);
      QXmlStreamReader xml(QByteArray::fromStdString("<a b=\"" + text + "\">" + text + "</a>"));
      QVERIFY(xml.readNextStartElement());
      const QString expected = QString::fromStdString(plainText(name.text));
      QCOMPARE(xml.attributes().value("b").toString(), expected);
      QCOMPARE(xml.readElementText(), expected);
      QVERIFY2(!xml.hasError(), name.id);
    }
  }
};

GONIO_TEST(PlainTextTest)
}  // namespace plain_text_test

#include "plain_text_test.moc"
