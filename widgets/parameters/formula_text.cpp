// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/formula_text.h"

#include <QHash>
#include <QStringView>

namespace gonio::widgets {

namespace {

/// Symbols that are written in letters.
const QHash<QString, QString>& symbols() {
  static const QHash<QString, QString> table{
      {"alpha", "α"}, {"beta", "β"},   {"gamma", "γ"}, {"delta", "δ"},  {"Delta", "Δ"}, {"epsilon", "ε"},
      {"eta", "η"},   {"theta", "θ"},  {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"},    {"nu", "ν"},
      {"pi", "π"},    {"rho", "ρ"},    {"sigma", "σ"}, {"tau", "τ"},    {"phi", "φ"},   {"psi", "ψ"},
      {"Gamma", "Γ"}, {"Lambda", "Λ"}, {"Omega", "Ω"}, {"omega", "ω"},  {"Dp", "Δp"},   {"sum", "Σ"}};
  return table;
}

/// Translates from left to right; exponents and indices are formulas themselves.
class FormulaReader {
 public:
  explicit FormulaReader(QStringView text) : m_text(text) {}

  QString html() {
    while (m_at < m_text.size()) translateNext();
    return m_html;
  }

 private:
  bool follows(QStringView token) const { return m_text.sliced(m_at).startsWith(token); }
  /// Whether the sign stands between letters: "half-vector".
  bool isInWord() const {
    return m_at > 0 && m_at + 1 < m_text.size() && m_text[m_at - 1].isLetter() && m_text[m_at + 1].isLetter();
  }
  void replace(QStringView token, QStringView html) {
    m_html += html;
    m_at += token.size();
  }

  void translateNext() {
    const QChar next = m_text[m_at];
    if (next.isLetter()) return translateWord();
    if (next == u'_') return translateScript(QStringLiteral("sub"));
    if (next == u'^') return translateScript(QStringLiteral("sup"));
    if (follows(u"<=")) return replace(u"<=", u"≤");
    if (follows(u">=")) return replace(u">=", u"≥");
    if (follows(u" . ")) return replace(u" . ", u" · ");
    if (next == u'-') return replace(u"-", isInWord() ? u"-" : u"−");
    // Means stand in angle brackets.
    if (next == u'<') return replace(u"<", u"⟨");
    if (next == u'>') return replace(u">", u"⟩");
    if (next == u'\'') return replace(u"'", u"′");
    m_html += QString(next).toHtmlEscaped();
    ++m_at;
  }

  void translateWord() {
    qsizetype end = m_at;
    while (end < m_text.size() && m_text[end].isLetter()) ++end;
    const QString word = m_text.sliced(m_at, end - m_at).toString();
    m_at = end;
    if (word == QLatin1String("sqrt")) {
      m_html += QStringLiteral("√");
      if (follows(u" ")) ++m_at;
    } else if (word.size() == 1) {
      m_html += QStringLiteral("<i>%1</i>").arg(word);
    } else {
      m_html += symbols().value(word, word);
      if (word == QLatin1String("Delta") && follows(u" ")) ++m_at;
    }
  }

  /// The end of an index or exponent: an expression in parentheses, or all that is not an operator.
  qsizetype endOfScript() const {
    qsizetype end = m_at;
    if (m_text[end] == u'(') {
      for (int depth = 0; end < m_text.size(); ++end) {
        depth += m_text[end] == u'(' ? 1 : m_text[end] == u')' ? -1 : 0;
        if (depth == 0) return end + 1;
      }
      return end;
    }
    if (m_text[end] == u'-') ++end;
    while (end < m_text.size() && (m_text[end].isLetterOrNumber() || m_text[end] == u'\'')) ++end;
    return end;
  }

  void translateScript(const QString& tag) {
    if (++m_at == m_text.size()) return;
    const qsizetype end = endOfScript();
    QStringView script = m_text.sliced(m_at, end - m_at);
    if (script.startsWith(u'(') && script.endsWith(u')')) script = script.sliced(1, script.size() - 2);
    m_at = end;
    m_html += QStringLiteral("<%1>%2</%1>").arg(tag, FormulaReader(script).html());
  }

  QStringView m_text;
  qsizetype m_at = 0;
  QString m_html;
};

}  // namespace

QString formulaHtml(std::string_view formula) {
  const QString text = QString::fromUtf8(formula.data(), qsizetype(formula.size()));
  return FormulaReader(text).html();
}

QString metricToolTip(std::string_view formula, std::string_view reference) {
  const QString source = QString::fromUtf8(reference.data(), qsizetype(reference.size()));
  return QStringLiteral("<p>%1</p><p>%2</p>").arg(formulaHtml(formula), source.toHtmlEscaped());
}

}  // namespace gonio::widgets
