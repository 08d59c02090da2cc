// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_page_settings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include "core/figures/figure_layout.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

using figures::FigureDescription;
using figures::FigureInset;

namespace {

constexpr double usualMaximum = 0.1, insetStep = 0.05;

widgets::NumberField* numberField(double value, double step, const QString& name, const QString& toolTip) {
  auto* field = new widgets::NumberField;
  field->setStep(step);
  field->setValue(value);
  field->setAccessibleName(name);
  field->setToolTip(toolTip);
  return field;
}

QLabel* fieldLabel(const QString& text, QWidget* field) {
  auto* label = new QLabel(text);
  label->setBuddy(field);
  return label;
}

}  // namespace

FigurePageSettings::FigurePageSettings(QWidget* parent)
    : QWidget(parent),
      m_title(new QLineEdit),
      m_columns(new QComboBox),
      m_font(new QComboBox),
      m_inset(new QCheckBox(tr("In&set"))),
      m_maps(new QCheckBox(tr("Erro&r maps"))),
      m_fixed(new QCheckBox(tr("Fixed maxim&um"))) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  buildPage(*form);
  buildParts(*form);
  setDescription({});
  connectParts();
}

void FigurePageSettings::buildPage(QFormLayout& form) {
  m_title->setPlaceholderText(tr("None"));
  m_title->setToolTip(tr("Title above the figure; papers usually have a caption instead"));
  m_columns->addItems(
      {tr("One column, %1 mm").arg(figures::oneColumnWidth), tr("Two columns, %1 mm").arg(figures::twoColumnsWidth)});
  m_columns->setToolTip(tr("Width of the figure on a two-column page"));
  m_font->setEditable(true);
  m_font->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_font->setMinimumContentsLength(12);
  m_font->addItems(QFontDatabase::families());
  m_font->setToolTip(tr("Font family; if it is not installed, the system's substitute is used"));
  constexpr double step = 0.5;
  m_fontSize = new QDoubleSpinBox;
  m_fontSize->setDecimals(1);
  m_fontSize->setRange(FigureDescription::minFontSize - step, FigureDescription::maxFontSize);
  m_fontSize->setSingleStep(step);
  m_fontSize->setKeyboardTracking(false);
  m_fontSize->setToolTip(tr("Font size when the figure is placed at 100 %"));
  m_fontSize->setSuffix(tr(" pt"));
  m_fontSize->setSpecialValueText(tr("Auto"));
  form.addRow(tr("T&itle"), m_title);
  form.addRow(tr("&Width"), m_columns);
  form.addRow(tr("&Font"), m_font);
  form.addRow(tr("Fo&nt size"), m_fontSize);
}

void FigurePageSettings::buildParts(QFormLayout& form) {
  m_inset->setToolTip(
      tr("Magnifies a square part of every image; draw the square on an image of the page, or enter it "
         "in fractions of the image"));
  const FigureInset usual;
  m_x = numberField(usual.x, insetStep, tr("Inset, left edge"), tr("Left edge, in fractions of the image"));
  m_y = numberField(usual.y, insetStep, tr("Inset, top edge"), tr("Top edge, in fractions of the image"));
  m_side = numberField(usual.size, insetStep, tr("Inset, side"), tr("Side of the square, in fractions of the image"));
  m_side->setRange(FigureInset::minSize, 1);
  limitInset();
  auto* place = new QHBoxLayout;
  const std::pair<QString, widgets::NumberField*> fields[] = {
      {tr("Left"), m_x}, {tr("Top"), m_y}, {tr("Side"), m_side}};
  for (const auto& [text, field] : fields) {
    place->addWidget(fieldLabel(text, field));
    place->addWidget(field, 1);
  }
  m_maps->setToolTip(tr("Shows the absolute luminance difference from the reference, on one scale for all images"));
  m_fixed->setToolTip(
      tr("Maximum of the scale of the error maps, luminance difference. Default: the largest of the "
         "rows' 99.5th percentiles of the differences, rounded up"));
  m_maximum = numberField(usualMaximum, 0.05, tr("Error maximum"), m_fixed->toolTip());
  m_maximum->setRange(FigureDescription::minErrorMaximum, FigureDescription::maxErrorMaximum);
  auto* maximum = new QHBoxLayout;
  maximum->addWidget(m_fixed);
  maximum->addWidget(m_maximum, 1);
  form.addRow(m_inset);
  form.addRow(place);
  form.addRow(m_maps);
  form.addRow(maximum);
}

void FigurePageSettings::connectParts() {
  connect(m_title, &QLineEdit::textChanged, this, &FigurePageSettings::changed);
  connect(m_columns, &QComboBox::currentIndexChanged, this, &FigurePageSettings::changed);
  connect(m_font, &QComboBox::currentTextChanged, this, &FigurePageSettings::changed);
  connect(m_fontSize, &QDoubleSpinBox::valueChanged, this, [this](double size) {
    m_exactFontSize = size < FigureDescription::minFontSize ? 0 : size;
    Q_EMIT changed();
  });
  for (widgets::NumberField* field : {m_x, m_y, m_maximum})
    connect(field, &widgets::NumberField::valueEdited, this, &FigurePageSettings::changed);
  connect(m_side, &widgets::NumberField::valueEdited, this, [this] {
    limitInset();
    Q_EMIT changed();
  });
  for (QCheckBox* box : {m_inset, m_maps, m_fixed})
    connect(box, &QCheckBox::toggled, this, [this] {
      refresh();
      Q_EMIT changed();
    });
}

void FigurePageSettings::limitInset() {
  const double most = 1 - m_side->value();
  for (widgets::NumberField* field : {m_x, m_y}) {
    field->setRange(0, most);
    if (field->value() > most) field->setValue(most);
  }
}

void FigurePageSettings::showInset(const FigureInset& inset) {
  m_side->setValue(inset.size);
  m_x->setValue(inset.x);
  m_y->setValue(inset.y);
  limitInset();
}

void FigurePageSettings::setInset(const FigureInset& inset) {
  showInset(inset);
  if (m_inset->isChecked()) return Q_EMIT changed();
  m_inset->setChecked(true);
}

void FigurePageSettings::apply(FigureDescription& description) const {
  description.title = m_title->text().toStdString();
  description.width = figures::FigureWidth(m_columns->currentIndex());
  description.font = m_font->currentText().toStdString();
  description.fontSize = m_exactFontSize;
  description.inset.reset();
  if (m_inset->isChecked()) description.inset = FigureInset{m_x->value(), m_y->value(), m_side->value()};
  description.errorMaps = m_maps->isChecked();
  description.errorMaximum.reset();
  if (m_fixed->isChecked()) description.errorMaximum = m_maximum->value();
}

void FigurePageSettings::setDescription(const FigureDescription& description) {
  const QSignalBlocker quiet(this);
  m_title->setText(QString::fromStdString(description.title));
  m_columns->setCurrentIndex(int(description.width));
  m_font->setCurrentText(QString::fromStdString(description.font));
  m_fontSize->setValue(description.fontSize > 0 ? description.fontSize : m_fontSize->minimum());
  m_exactFontSize = description.fontSize;  // the box shows one decimal
  m_inset->setChecked(description.inset.has_value());
  if (description.inset) showInset(*description.inset);
  m_maps->setChecked(description.errorMaps);
  m_fixed->setChecked(description.errorMaximum.has_value());
  if (description.errorMaximum) m_maximum->setValue(*description.errorMaximum);
  refresh();
}

void FigurePageSettings::refresh() {
  for (widgets::NumberField* field : {m_x, m_y, m_side}) field->setEnabled(m_inset->isChecked());
  m_fixed->setEnabled(m_maps->isChecked());
  m_maximum->setEnabled(m_maps->isChecked() && m_fixed->isChecked());
}

}  // namespace gonio::app

#include "moc_figure_page_settings.cpp"
