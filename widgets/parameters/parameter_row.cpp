// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/parameter_row.h"

#include <QComboBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/inputs/icons.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/parameters/colour_swatch.h"
#include "widgets/parameters/parameter_line.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::widgets {

double linkedValue(const models::ParameterSpec& spec, const Rgb& channels) {
  // Equal channels are their own mean, without the rounding of the weights.
  if (channels.x == channels.y && channels.y == channels.z) return channels.x;
  return spec.hardMin >= 0 ? luminance(channels) : (channels.x + channels.y + channels.z) / 3;
}

Rgb withLinkedValue(const models::ParameterSpec& spec, const Rgb& channels, double target) {
  const double current = linkedValue(spec, channels);
  if (target == current) return channels;
  const bool scales = spec.hardMin >= 0 && current > 0;
  const bool grey = channels.x == channels.y && channels.y == channels.z;
  Rgb result = grey ? Rgb(target) : scales ? channels * (target / current) : channels + (target - current);
  for (int c = 0; c < 3; ++c) result[c] = std::clamp(result[c], spec.hardMin, spec.hardMax);
  return result;
}

bool isColour(const models::ParameterSpec& spec) {
  return spec.perChannel && spec.choices.empty() && spec.hardMin == 0 && spec.scale == models::ParameterScale::linear &&
         (spec.linear || spec.softMax == 1);
}

ParameterRow::ParameterRow(const models::ParameterSpec& spec, QWidget* parent) : QWidget(parent), m_spec(&spec) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  m_line = new ParameterLine(spec, toQString(spec.label), this);
  layout->addWidget(m_line);
  connectLine(m_line);
  if (!spec.choices.empty())
    buildChoice();
  else if (spec.perChannel)
    buildChannels();
  else
    buildNumber();
  describe();
  refresh();
}

void ParameterRow::connectLine(ParameterLine* line) {
  connect(line, &ParameterLine::editingStarted, this, &ParameterRow::editingStarted);
  connect(line, &ParameterLine::editingFinished, this, &ParameterRow::editingFinished);
}

void ParameterRow::offer(const Rgb& value) {
  m_value = value;
  refresh();
  Q_EMIT valueEdited(value);
}

void ParameterRow::buildNumber() {
  connect(m_line, &ParameterLine::valueEdited, this, [this](double value) { offer(Rgb(value)); });
  connect(m_line, &ParameterLine::resetRequested, this, &ParameterRow::resetRequested);
}

void ParameterRow::buildChannels() {
  connect(m_line, &ParameterLine::valueEdited, this,
          [this](double value) { offer(withLinkedValue(*m_spec, m_value, value)); });
  connect(m_line, &ParameterLine::resetRequested, this, &ParameterRow::resetRequested);

  m_disclosure = new QToolButton(this);
  m_disclosure->setCheckable(true);
  m_disclosure->setAutoRaise(true);
  m_disclosure->setIcon(themedIcon(QStringLiteral("collapsed")));
  m_disclosure->setToolTip(tr("Shows the red, green and blue values"));
  m_disclosure->setAccessibleName(tr("Channels of %1").arg(toQString(m_spec->label)));
  m_line->setLeading(m_disclosure);
  connect(m_disclosure, &QToolButton::toggled, this, &ParameterRow::setChannelsShown);

  const QString names[] = {tr("Red"), tr("Green"), tr("Blue")};
  for (int c = 0; c < 3; ++c) {
    auto* line = new ParameterLine(*m_spec, names[c], this);
    line->label()->setIndent(fontMetrics().height() / 2);
    layout()->addWidget(line);
    line->hide();
    connectLine(line);
    connect(line, &ParameterLine::valueEdited, this, [this, c](double value) {
      Rgb changed = m_value;
      changed[c] = value;
      offer(changed);
    });
    connect(line, &ParameterLine::resetRequested, this, [this, c] {
      if (m_value[c] == m_reference[c]) return;
      Rgb changed = m_value;
      changed[c] = m_reference[c];
      Q_EMIT editingStarted();
      offer(changed);
      Q_EMIT editingFinished();
    });
    m_channels[std::size_t(c)] = line;
  }
  if (!isColour(*m_spec)) return;
  m_swatch = new ColourSwatch(this);
  m_swatch->setAccessibleName(tr("Colour of %1").arg(toQString(m_spec->label)));
  m_swatch->setToolTip(tr("Opens a colour wheel for %1; its button \"Pick from Screen\" takes a colour from the "
                          "screen, such as from the "
                          "preview")
                           .arg(toQString(m_spec->label)));
  m_line->setTrailing(m_swatch);
  connect(m_swatch, &ColourSwatch::editingStarted, this, &ParameterRow::editingStarted);
  connect(m_swatch, &ColourSwatch::colourEdited, this, [this](const Rgb& value) { offer(value); });
  connect(m_swatch, &ColourSwatch::editingFinished, this, &ParameterRow::editingFinished);
}

void ParameterRow::buildChoice() {
  m_choice = new QComboBox(this);
  m_choice->setFocusPolicy(Qt::StrongFocus);
  for (const std::string_view& choice : m_spec->choices) m_choice->addItem(toQString(choice));
  m_line->replaceNumber(m_choice);
  connect(m_line, &ParameterLine::resetRequested, this, &ParameterRow::resetRequested);
  connect(m_choice, &QComboBox::activated, this, [this](int index) {
    if (double(index) == m_value.x) return;
    Q_EMIT editingStarted();
    offer(Rgb(index));
    Q_EMIT editingFinished();
  });
}

void ParameterRow::setValue(const Rgb& value, const Rgb& reference) {
  const bool refitted = reference != m_reference;
  if (!refitted && value == m_value) return;
  m_value = value;
  m_reference = reference;
  if (refitted) describe();  // a value is not in it
  refresh();
}

void ParameterRow::describe() {
  const QString name = toQString(m_spec->label);
  QString toolTip = parameterToolTip(*m_spec, &m_reference);
  if (!m_inactiveReason.isEmpty()) toolTip.prepend(QStringLiteral("<p>%1</p>").arg(m_inactiveReason.toHtmlEscaped()));
  m_line->setDescription(toolTip, name);
  for (std::size_t c = 0; c < 3; ++c)
    if (m_channels[c]) m_channels[c]->setDescription(toolTip, name + ' ' + m_channels[c]->label()->text());
  if (m_choice) {
    setRichToolTip(*m_choice, toolTip);
    m_choice->setAccessibleName(name);
  }
}

void ParameterRow::setActive(bool active, const QString& reason) {
  setEnabled(active);
  if (const QString shown = active ? QString() : reason; shown != std::exchange(m_inactiveReason, shown)) describe();
}

void ParameterRow::showUnits() {
  m_line->showUnit();
  for (ParameterLine* line : m_channels)
    if (line) line->showUnit();
  describe();
}

void ParameterRow::refresh() {
  m_line->setValue(linkedValue(*m_spec, m_value), linkedValue(*m_spec, m_reference));
  m_line->setModified(isModified());
  for (int c = 0; c < 3; ++c)
    if (ParameterLine* line = m_channels[std::size_t(c)]) line->setValue(m_value[c], m_reference[c]);
  if (m_swatch) m_swatch->setColour(m_value);
  if (m_choice) m_choice->setCurrentIndex(int(std::lround(m_value.x)));
}

void ParameterRow::setChannelsShown(bool shown) {
  m_disclosure->setIcon(themedIcon(shown ? QStringLiteral("expanded") : QStringLiteral("collapsed")));
  for (ParameterLine* line : m_channels) line->setVisible(shown);
}

}  // namespace gonio::widgets

#include "moc_parameter_row.cpp"
