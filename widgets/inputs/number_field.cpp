// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/number_field.h"

#include <QKeyEvent>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/types.h"

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

QString formatNumber(double value) { return QString::number(value == 0 ? 0.0 : value, 'g', 4); }

QString degreesText(double radians) { return QStringLiteral("%1°").arg(degrees(radians), 0, 'f', 1); }

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
  setAlignment(Qt::AlignRight);
  setFocusPolicy(Qt::StrongFocus);
  connect(this, &QLineEdit::editingFinished, this, &NumberField::commit);
  setValue(0);
}

void NumberField::setRange(double hardMin, double hardMax) {
  m_min = hardMin;
  m_max = hardMax;
}

void NumberField::setUnit(const QString& unit, double displayFactor, double displayPower) {
  m_unit = unit;
  m_displayFactor = displayFactor;
  m_displayPower = displayPower;
  setValue(m_value);
}

void NumberField::setValue(double value) {
  m_value = value;
  restore();
  // As after Enter: what is typed next replaces the number, and letters are shortcuts.
  if (hasFocus()) selectAll();
}

QString NumberField::formatted(double value) const {
  const QString number = formatNumber(std::pow(value, m_displayPower) * m_displayFactor);
  return m_unit.isEmpty() ? number : number + QChar(0x202f) + m_unit;
}

QSize NumberField::sizeHint() const {
  const QSize hint = QLineEdit::sizeHint();
  return {fontMetrics().horizontalAdvance(QStringLiteral("-0.00000 1/sr")), hint.height()};
}

void NumberField::restore() {
  m_shown = formatted(m_value);
  setText(m_shown);
  setCursorPosition(0);
}

void NumberField::commit() {
  if (text() == m_shown) return;
  const auto typed = evaluateArithmetic(text(), m_unit);
  if (!typed) return restore();
  const double shown = *typed / m_displayFactor;
  // Outside the domain of the power the lower limit is the nearest that there is.
  offer(m_displayPower == 1 ? shown : std::pow(std::max(shown, 0.0), 1 / m_displayPower));
}

void NumberField::offer(double value) {
  const double used = std::clamp(value, m_min, m_max);
  const bool changed = used != m_value;
  setValue(used);
  if (used != value) Q_EMIT clamped(value, used);
  if (changed) Q_EMIT valueEdited(used);
}

void NumberField::stepBy(double steps) { offer(m_value + steps * m_step); }

bool NumberField::isStrayLetter(const QKeyEvent& event) const {
  const QString typed = event.text();
  const bool isLetter = typed.size() == 1 && typed[0].isLetter() && typed.compare("p", Qt::CaseInsensitive) != 0;
  return isLetter && (text().isEmpty() || selectedText() == text());
}

bool NumberField::event(QEvent* event) {
  // Esc belongs to the field while something is typed in it, to the window (cancel the topmost task) otherwise.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
      text() != m_shown) {
    event->accept();
    return true;
  }
  // A letter begins no number, so that it remains the shortcut of the window that it is.
  if (event->type() == QEvent::ShortcutOverride && isStrayLetter(*static_cast<QKeyEvent*>(event))) {
    event->ignore();
    return true;
  }
  return QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  const double fine = event->modifiers() & Qt::ShiftModifier ? 0.1 : 1;
  switch (event->key()) {
    case Qt::Key_Escape:
      restore();
      selectAll();
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      commit();
      selectAll();
      return;
    case Qt::Key_Up:
      return stepBy(fine);
    case Qt::Key_Down:
      return stepBy(-fine);
    default:
      if (isStrayLetter(*event)) return event->ignore();
      QLineEdit::keyPressEvent(event);
  }
}

void NumberField::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  const double fine = event->modifiers() & Qt::ShiftModifier ? 0.1 : 1;
  // Shift turns a vertical wheel into a horizontal one on some platforms.
  const int delta = event->angleDelta().y() ? event->angleDelta().y() : event->angleDelta().x();
  stepBy(fine * delta / 120.0);
  event->accept();
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  // After the press that gave the focus has set the cursor.
  QTimer::singleShot(0, this, [this] {
    if (hasFocus() && text() == m_shown) selectAll();
  });
}

}  // namespace gonio::widgets

#include "moc_number_field.cpp"
