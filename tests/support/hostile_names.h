// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

namespace gonio::test {

/// A name that a file or a document may give to a material, an edit, a scene or an environment.
struct HostileName {
  const char* id;    ///< of the row of a test
  std::string text;  ///< bytes; not always UTF-8
};

/// Names that are code, markup, a separator or no text at all in one of the formats that Gonio writes or shows.
inline std::vector<HostileName> hostileNames() {
  using namespace std::string_literals;
  return {
      {"quotes", R"(it's "gold" \ paint `x`)"},
      {"prolog", "<?xml version=\"1.0\"?><h1>gold</h1>"},
      {"markup", R"(<b>&amp;</b> <img src="/dev/zero"> ]]> --> <!-- <?x?>)"},
      {"script", "</script><script>alert(1)</script>"},
      {"newline", "first\nimport os; os.abort()\n# second\r\nthird\rfourth"},
      {"nul", "before\0after"s},
      {"control", "bell\x07 tab\t escape\x1b[31m delete\x7f feed\x0c"},
      {"invalid", "latin \xe9 cut \xf0\x9f overlong \xc0\xaf surrogate \xed\xa0\x80"},
      {"marks", "right \u202e left \u200f mark \u2066 line \u2028 paragraph \u2029 bom \ufeff next \u0085"},
      {"wide", "gold 金 émail \U0001f600"},
      {"triple", R"(""" ''' \""" \)"},
      {"coding", "coding: unicode_escape \\u000aimport os\\u000aos.abort()"},
      {"cookie", "-*- coding: utf-7 -*- +AAo-import os"},
      {"option", "[10pt] gold"},
      {"title", "gold[*]"},
      {"latex", R"(\input{/etc/passwd} 50% $x^2$ {a}_b ~ # & \\ ?` -- <<)"},
      {"number", "#1 gold"},
      {"semicolon", "gold;=1"},
      {"command", "=cmd()|'/c calc'!A1,=2+3;=4"},
      {"plus", "+1+1"},
      {"minus", "-2+3"},
      {"at", "@SUM(1,2)"},
      {"comment", "*/ int x; /* // # % -- \\"},
      {"path", "../../etc/passwd"},
      {"percent", "%s %n %1 %2 %L1 ${HOME} $(id) `id`"},
      {"mnemonic", "a&b\tCtrl+C"},
      {"ampersand", "R&D && <A> \"B\""},
      {"empty", ""},
      {"blank", " \t "},
      {"long", std::string(10000, 'x')},
  };
}

}  // namespace gonio::test
