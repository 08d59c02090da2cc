// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/interpolation/blend_position_editor.h"

#include <QLabel>
#include <QVBoxLayout>

#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"
#include "widgets/interpolation/blend_pad.h"

namespace gonio::app {

BlendPositionEditor::BlendPositionEditor(QWidget* parent)
    : QStackedWidget(parent),
      m_slider(new widgets::ParameterSlider),
      m_number(new widgets::NumberField),
      m_explanation(new QLabel),
      m_pad(new widgets::BlendPad) {
  addWidget(buildLine());
  addWidget(m_pad);
  connect(m_slider, &widgets::ParameterSlider::numberEdited, this, [this](double t) { Q_EMIT positionEdited({t, 0}); });
  connect(m_slider, &widgets::ParameterSlider::resetRequested, this, [this] { Q_EMIT positionEdited({0.5, 0}); });
  connect(m_number, &widgets::NumberField::valueEdited, this, [this](double t) { Q_EMIT positionEdited({t, 0}); });
  connect(m_pad, &widgets::BlendPad::placeEdited, this, &BlendPositionEditor::positionEdited);
}

QWidget* BlendPositionEditor::buildLine() {
  const QString toolTip =
      tr("t: 0 is A alone, 1 is B alone. Shift: fine, Ctrl: snap; the field accepts arithmetic, such as 1/3.");
  m_slider->setRange(0, 1, models::ParameterScale::linear);
  m_slider->setReference(0.5);
  m_slider->setAccessibleName(tr("t, from A to B"));
  m_slider->setToolTip(toolTip);
  m_number->setRange(0, 1);
  m_number->setStep(0.01);
  m_number->setAccessibleName(tr("t, from A to B"));
  m_number->setToolTip(toolTip);
  m_number->setFixedWidth(4 * fontMetrics().height());
  m_explanation->setWordWrap(true);
  m_explanation->setForegroundRole(QPalette::PlaceholderText);
  m_explanation->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::MinimumExpanding);
  m_explanation->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* line = new QWidget;
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("A")));
  row->addWidget(m_slider, 1);
  row->addWidget(new QLabel(tr("B")));
  row->addWidget(m_number);
  auto* column = new QVBoxLayout(line);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addWidget(m_explanation, 1);
  return line;
}

void BlendPositionEditor::setCorners(std::vector<widgets::BlendCorner> corners) {
  setCurrentIndex(int(corners.size()) > widgets::minBlended ? 1 : 0);
  m_pad->setCorners(std::move(corners));
}

void BlendPositionEditor::setPosition(const QPointF& position) {
  m_slider->setNumber(position.x());
  m_number->setValue(position.x());
  m_pad->setPlace(position);
}

void BlendPositionEditor::setExplanation(const QString& text) { m_explanation->setText(text); }

}  // namespace gonio::app

#include "moc_blend_position_editor.cpp"
