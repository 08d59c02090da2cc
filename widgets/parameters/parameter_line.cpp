// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/parameter_line.h"

#include <QEvent>
#include <QHBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/inputs/icons.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::widgets {

namespace {

/// The end of a slider that begins at `start` and has `value` at four fifths.
double endBeyond(double start, double value, models::ParameterScale scale) {
  constexpr double stretch = 1.25;
  if (scale == models::ParameterScale::logarithmic && start > 0 && value > 0)
    return start * std::pow(value / start, stretch);
  return start + stretch * (value - start);
}

}  // namespace

std::pair<double, double> sliderRange(const models::ParameterSpec& spec, double fitted) {
  double low = spec.softMin, high = spec.softMax;
  if (fitted > high) high = std::min(spec.hardMax, endBeyond(low, fitted, spec.scale));
  if (fitted < low) low = std::max(spec.hardMin, endBeyond(high, fitted, spec.scale));
  return {low, high};
}

namespace {
/// The longest label of a control has room on one line, in bold, too.
constexpr int labelCharacters = 17;
/// Arrow keys in the number field step by this fraction of the slider's range.
constexpr double fieldStepFraction = 0.01;
}  // namespace

ParameterLine::ParameterLine(const models::ParameterSpec& spec, const QString& label, QWidget* parent)
    : QWidget(parent),
      m_spec(spec),
      m_layout(new QHBoxLayout(this)),
      m_label(new QLabel(label, this)),
      m_slider(new ParameterSlider(this)),
      m_field(new NumberField(this)),
      m_leading(new QWidget(this)),
      m_trailing(new QWidget(this)),
      m_reset(new QToolButton(this)) {
  const int em = fontMetrics().height();
  QFont bold = font();
  bold.setBold(true);
  m_label->setFixedWidth(QFontMetrics(bold).averageCharWidth() * labelCharacters);
  m_label->setWordWrap(true);
  m_label->installEventFilter(this);
  m_field->setRange(spec.hardMin, spec.hardMax);
  showUnit();
  m_field->setStep((spec.softMax - spec.softMin) * fieldStepFraction);
  m_reset->setIcon(themedIcon(QStringLiteral("reset")));
  m_reset->setAutoRaise(true);
  m_reset->setFocusPolicy(Qt::TabFocus);
  QSizePolicy policy = m_reset->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  m_reset->setSizePolicy(policy);
  m_reset->hide();
  m_leading->setFixedWidth(em);
  m_trailing->setFixedWidth(em + 4);

  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setSpacing(em / 3);
  m_layout->addWidget(m_leading);
  m_layout->addWidget(m_label);
  m_layout->addWidget(m_slider, 1);
  m_layout->addWidget(m_field);
  m_layout->addWidget(m_trailing);
  m_layout->addWidget(m_reset);
  m_slider->setRange(spec.softMin, spec.softMax, spec.scale);

  connect(m_slider, &ParameterSlider::editingStarted, this, &ParameterLine::editingStarted);
  connect(m_slider, &ParameterSlider::numberEdited, this, &ParameterLine::valueEdited);
  connect(m_slider, &ParameterSlider::editingFinished, this, &ParameterLine::editingFinished);
  connect(m_slider, &ParameterSlider::resetRequested, this, &ParameterLine::resetRequested);
  connect(m_reset, &QToolButton::clicked, this, &ParameterLine::resetRequested);
  connect(m_field, &NumberField::valueEdited, this, [this](double value) {
    Q_EMIT editingStarted();
    Q_EMIT valueEdited(value);
    Q_EMIT editingFinished();
  });
}

void ParameterLine::showUnit() {
  const QString unit = displayUnit(m_spec);
  m_field->setUnit(unit, displayFactor(m_spec), displayPower(m_spec));
  const int em = fontMetrics().height();
  m_field->setFixedWidth(em * 9 / 2 + (unit.isEmpty() ? 0 : 3 * em / 2));
}

void ParameterLine::setValue(double value, double reference) {
  const auto [low, high] = sliderRange(m_spec, reference);
  m_slider->setRange(low, high, m_spec.scale);
  m_slider->setNumber(value);
  m_slider->setReference(reference);
  m_field->setValue(value);
  setModified(value != reference);
}

void ParameterLine::setModified(bool modified) {
  m_modified = modified;
  QFont labelFont = font();
  labelFont.setBold(modified);
  m_label->setFont(labelFont);
  m_slider->setModified(modified);
  m_reset->setVisible(modified);
}

void ParameterLine::setLeading(QWidget* widget) {
  widget->setFixedWidth(m_leading->minimumWidth());
  delete m_layout->replaceWidget(m_leading, widget);
  delete m_leading;
  m_leading = widget;
}

void ParameterLine::setTrailing(QWidget* widget) {
  widget->setFixedWidth(m_trailing->minimumWidth());
  delete m_layout->replaceWidget(m_trailing, widget);
  delete m_trailing;
  m_trailing = widget;
}

void ParameterLine::replaceNumber(QWidget* widget) {
  delete m_layout->replaceWidget(m_slider, widget);
  m_slider->hide();
  m_field->hide();
}

void ParameterLine::setDescription(const QString& toolTip, const QString& accessibleName) {
  for (QWidget* widget : std::initializer_list<QWidget*>{m_label, m_slider, m_field}) {
    setRichToolTip(*widget, toolTip);
    widget->setAccessibleName(accessibleName);
  }
  m_reset->setToolTip(tr("Resets %1 to its fitted value (Backspace, or double-click the label)").arg(accessibleName));
  m_reset->setAccessibleName(tr("Reset %1").arg(accessibleName));
}

bool ParameterLine::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_label && event->type() == QEvent::MouseButtonDblClick) {
    Q_EMIT resetRequested();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace gonio::widgets

#include "moc_parameter_line.cpp"
