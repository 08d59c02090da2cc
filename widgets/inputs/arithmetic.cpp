// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/arithmetic.h"

#include <cmath>
#include <numbers>

namespace gonio::widgets {

namespace {

/// Recursive descent over sum > product > signed > power > atom. A failure leaves `failed` set; the depth is bounded
/// so that a pasted text of a million parentheses is refused and not a crash.
class Parser {
 public:
  explicit Parser(const QString& text) : text_(text) {}

  std::optional<double> parse() {
    const double value = sum();
    skipSpace();
    if (failed_ || at_ != text_.size() || !std::isfinite(value)) return std::nullopt;
    return value;
  }

 private:
  void skipSpace() {
    while (at_ < text_.size() && text_[at_].isSpace()) ++at_;
  }
  bool take(QChar wanted) {
    skipSpace();
    if (at_ >= text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }
  double sum() {
    double value = product();
    while (!failed_) {
      if (take('+'))
        value += product();
      else if (take('-'))
        value -= product();
      else
        break;
    }
    return value;
  }
  double product() {
    double value = signedPower();
    while (!failed_) {
      if (take('*'))
        value *= signedPower();
      else if (take('/'))
        value /= signedPower();
      else
        break;
    }
    return value;
  }
  double signedPower() {
    if (++depth_ > 100) failed_ = true;
    if (failed_) return 0;
    double value;
    if (take('-'))
      value = -signedPower();
    else if (take('+'))
      value = signedPower();
    else {
      value = atom();
      if (take('^')) value = std::pow(value, signedPower());
    }
    --depth_;
    return value;
  }
  double atom() {
    if (take('(')) {
      const double value = sum();
      if (!take(')')) failed_ = true;
      return value;
    }
    skipSpace();
    if (text_.mid(at_, 2) == QLatin1String("pi")) {
      at_ += 2;
      return std::numbers::pi;
    }
    return number();
  }
  double number() {
    const qsizetype begin = at_;
    const auto digits = [this] {
      while (at_ < text_.size() && text_[at_].isDigit()) ++at_;
    };
    digits();
    if (at_ < text_.size() && (text_[at_] == '.' || text_[at_] == ',')) ++at_;
    digits();
    if (at_ > begin && at_ < text_.size() && text_[at_].toLower() == 'e') {
      const qsizetype beforeExponent = at_++;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      const qsizetype exponent = at_;
      digits();
      if (at_ == exponent) at_ = beforeExponent;
    }
    bool ok = false;
    const double value = text_.mid(begin, at_ - begin).replace(',', '.').toDouble(&ok);
    if (!ok) failed_ = true;
    return value;
  }

  const QString text_;
  qsizetype at_ = 0;
  int depth_ = 0;
  bool failed_ = false;
};

}  // namespace

std::optional<double> evaluateArithmetic(const QString& text, const QString& unit) {
  QString expression = text.trimmed();
  for (const QString& suffix : {unit, unit == QStringLiteral("°") ? QStringLiteral("deg") : QString()})
    if (!suffix.isEmpty() && expression.endsWith(suffix)) expression.chop(suffix.size());
  return Parser(expression.trimmed()).parse();
}

}  // namespace gonio::widgets
