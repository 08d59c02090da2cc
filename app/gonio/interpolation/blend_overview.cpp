// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/interpolation/blend_overview.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"
#include "widgets/interpolation/blend_pad.h"
#include "widgets/interpolation/blend_strip.h"

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

BlendOverview::BlendOverview(const BlendSpaces& spaces)
    : m_spaces(spaces), m_strip(new widgets::BlendStrip), m_draw(new QPushButton(tr("Resume Ren&dering"))) {
  m_draw->setToolTip(tr("Resumes the cancelled preparation and rendering"));
  const QStringList steps{"0", "1/6", "1/3", "1/2", "2/3", "5/6", "1"};
  static_assert(BlendSpaces::pictureCount == 7);
  m_strip->setSteps(steps);
  m_strip->setEmptyText(
      tr("Drop a material from the library on each slot to compare all methods of blending side by side.\nPress "
         "Current in a slot to use the open material."));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_strip, 1);
  column->addWidget(m_draw, 0, Qt::AlignLeft);
  connect(&m_spaces, &BlendSpaces::changed, this, &BlendOverview::showSpace);
  connect(m_strip, &widgets::BlendStrip::chosen, this, [this](int row, int step) {
    Q_EMIT chosen(m_spaces.spaces()[std::size_t(row)], step < 0 ? -1 : step / (BlendSpaces::pictureCount - 1.0));
  });
  connect(m_draw, &QPushButton::clicked, this, &BlendOverview::drawRequested);
}

void BlendOverview::showSpaces() {
  std::vector<widgets::BlendStrip::Row> rows;
  if (m_spaces.hasMaterials()) rows.resize(m_spaces.spaces().size());
  m_strip->setRows(std::move(rows));
  for (const auto space : m_spaces.spaces()) showSpace(space);
}

void BlendOverview::showSpace(BlendSpaces::Space space) {
  using State = BlendSpaces::State;
  const auto& spaces = m_spaces.spaces();
  m_draw->setVisible(std::ranges::any_of(spaces, [this](auto one) { return m_spaces.state(one) == State::cancelled; }));
  const auto row = std::size_t(std::ranges::find(spaces, space) - spaces.begin());
  if (row >= m_strip->rows().size()) return;
  widgets::BlendStrip::Row content{widgets::spaceName(space), widgets::spaceExplanation(space),
                                   m_spaces.pictures(space)};
  content.pictures.resize(BlendSpaces::pictureCount);
  switch (m_spaces.state(space)) {
    case State::failed:
      content.note = m_spaces.failure(space);
      content.failed = true;
      content.pictures.clear();
      break;
    case State::cancelled:
      content.note = tr("Cancelled");
      content.pictures.clear();
      break;
    case State::running:
      content.note = m_spaces.prepared(space) ? tr("Rendering...") : tr("Preparing...");
      break;
    default:
      break;
  }
  m_strip->setRow(int(row), std::move(content));
}

}  // namespace gonio::app

#include "moc_blend_overview.cpp"
