// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/menu_text.h"

#include <algorithm>

namespace gonio::widgets {

QString oneLine(QString text) {
  constexpr qsizetype longest = 100;
  const auto breaksLine = [](QChar c) {
    return c.category() == QChar::Other_Control || c == QChar::LineSeparator || c == QChar::ParagraphSeparator;
  };
  std::ranges::replace_if(text, breaksLine, u' ');
  return text.size() <= longest ? text : text.left(longest / 2) + QChar(0x2026) + text.right(longest / 2);
}

QString spacedName(QString name) { return name.replace(u'_', u' '); }

QString menuText(const QString& name) { return oneLine(name).replace('&', QStringLiteral("&&")); }

QString withoutKeyMarks(const QString& menuText) {
  QString text;
  for (qsizetype i = 0; i < menuText.size(); ++i) {
    if (menuText[i] == u'&') ++i;  // what follows is shown, another '&' too
    if (i < menuText.size()) text += menuText[i];
  }
  return text;
}

QString titleText(const QString& name) {
  const QString mark = QStringLiteral("[*]");
  return oneLine(name).replace(mark, mark + mark);
}

}  // namespace gonio::widgets
