// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Where the parts of the Interpolation panel stand, and what connects them.
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>

#include "app/gonio/document/material_files.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"
#include "widgets/interpolation/blend_pad.h"
#include "widgets/interpolation/blend_strip.h"
#include "widgets/interpolation/material_well.h"

namespace gonio::app {

namespace {
constexpr int wellEms = 17, placeEms = 17;

QString stepName(int step) {
  const QStringList names{"0", "1/6", "1/3", "1/2", "2/3", "5/6", "1"};
  return names[step];
}
}  // namespace

QSize InterpolationPanel::sizeHint() const { return QSize(80, 22) * fontMetrics().height(); }

QWidget* InterpolationPanel::buildWells() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 4, 0);
  column->setSpacing(4);
  for (int i = 0; i < widgets::mostBlended; ++i) {
    m_wells.push_back(new widgets::MaterialWell(QChar(u'A' + i)));
    column->addWidget(m_wells.back());
  }
  m_swap->setText(tr("S&wap A and B"));
  m_swap->setToolTip(tr("A takes the place of B, and B that of A"));
  m_add->setText(tr("Add a ma&terial"));
  m_add->setToolTip(tr("A third or a fourth material: a triangle or a square in place of the slider"));
  auto* buttons = new QHBoxLayout;
  for (QToolButton* button : {m_swap, m_add}) {
    button->setFocusPolicy(Qt::StrongFocus);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  column->addLayout(buttons);
  column->addStretch();
  auto* scroll = new QScrollArea;
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(wellEms * fontMetrics().height());
  return scroll;
}

QWidget* InterpolationPanel::buildPlace() {
  const QString toolTip = tr("t: 0 is A alone, 1 is B alone. Shift: fine, Ctrl: snap; arithmetic works in the field.");
  m_slider->setRange(0, 1, models::ParameterScale::linear);
  m_slider->setReference(0.5);
  m_slider->setAccessibleName(tr("t, from A to B"));
  m_slider->setToolTip(toolTip);
  m_number->setRange(0, 1);
  m_number->setStep(0.01);
  m_number->setAccessibleName(tr("t, from A to B"));
  m_number->setToolTip(toolTip);
  m_number->setFixedWidth(4 * fontMetrics().height());
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
  m_places->addWidget(line);
  m_places->addWidget(m_pad);
  return m_places;
}

QWidget* InterpolationPanel::buildChoice() {
  for (const auto space : m_spaces.spaces()) {
    m_spaceBox->addItem(widgets::spaceName(space), int(space));
    m_spaceBox->setItemData(m_spaceBox->count() - 1, widgets::spaceExplanation(space), Qt::ToolTipRole);
  }
  m_spaceBox->setAccessibleName(tr("Space of interpolation"));
  m_show->setToolTip(tr("The preview shows the blend and follows the hand; off: the open material"));
  m_show->setChecked(true);
  m_keep->setToolTip(
      tr("The blend becomes the open material, to be edited further, saved and exported.\n"
         "Undo brings back what was open."));
  auto* label = new QLabel(tr("Spa&ce"));
  label->setBuddy(m_spaceBox);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(m_spaceBox, 1);
  auto* choice = new QWidget;
  auto* column = new QVBoxLayout(choice);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addWidget(buildPlace(), 1);
  m_explanation->setWordWrap(true);
  m_explanation->setForegroundRole(QPalette::PlaceholderText);
  m_explanation->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::MinimumExpanding);
  m_explanation->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  column->addWidget(m_show);
  column->addWidget(m_keep);
  choice->setFixedWidth(placeEms * fontMetrics().height());
  auto* right = new QVBoxLayout;
  right->addWidget(m_strip, 1);
  right->addWidget(m_draw, 0, Qt::AlignLeft);
  m_draw->setToolTip(tr("Prepares and draws the spaces that were cancelled"));
  QStringList steps;
  for (int i = 0; i < BlendSpaces::pictureCount; ++i) steps << stepName(i);
  m_strip->setSteps(steps);
  m_strip->setEmptyText(
      tr("Drop a material of the library on A and one on B: every way of blending them is shown here, "
         "side by side.\nOr take the open material with Current."));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(fontMetrics().height());
  layout->addWidget(buildWells());
  layout->addWidget(choice);
  layout->addLayout(right, 1);
  return choice;
}

void InterpolationPanel::connectWells() {
  for (int i = 0; i < widgets::mostBlended; ++i) {
    widgets::MaterialWell* well = m_wells[std::size_t(i)];
    connect(well, &widgets::MaterialWell::materialDropped, this, [this, i](const QString& id) {
      touched();
      m_ends.read(i, id);
    });
    connect(well, &widgets::MaterialWell::currentWanted, this, [this, i] {
      touched();
      m_ends.takeCurrent(i);
    });
    connect(well, &widgets::MaterialWell::fileWanted, this, [this, i] { askForFile(i); });
    connect(well, &widgets::MaterialWell::clearWanted, this, [this, i] {
      if (m_ends.count() > widgets::fewestBlended)
        m_ends.removePlace(i);
      else
        m_ends.clear(i);
    });
  }
  connect(m_swap, &QToolButton::clicked, this, [this] { m_ends.swap(0, 1); });
  connect(m_add, &QToolButton::clicked, &m_ends, &BlendEnds::addPlace);
}

void InterpolationPanel::connectParts() {
  connectWells();
  connect(&m_ends, &BlendEnds::changed, this, &InterpolationPanel::endsChanged);
  connect(&m_ends, &BlendEnds::stateChanged, this, &InterpolationPanel::showWells);
  connect(&m_ends, &BlendEnds::failed, this, &InterpolationPanel::failed);
  connect(&m_spaces, &BlendSpaces::changed, this, [this](editing::InterpolationSpace space) {
    showRow(space);
    if (space == m_space) Q_EMIT subjectChanged();
  });
  connect(m_slider, &widgets::ParameterSlider::numberEdited, this, [this](double t) { moveTo({t, 0}); });
  connect(m_slider, &widgets::ParameterSlider::resetRequested, this, [this] { moveTo({0.5, 0}); });
  connect(m_number, &widgets::NumberField::valueEdited, this, [this](double t) { moveTo({t, 0}); });
  connect(m_pad, &widgets::BlendPad::placeEdited, this, &InterpolationPanel::moveTo);
  connect(m_spaceBox, &QComboBox::activated, this, [this](int index) {
    touched();
    setSpace(editing::InterpolationSpace(m_spaceBox->itemData(index).toInt()));
  });
  connect(m_strip, &widgets::BlendStrip::chosen, this, [this](int row, int step) {
    setSpace(m_spaces.spaces()[std::size_t(row)]);
    const double t = step / (BlendSpaces::pictureCount - 1.0);
    moveTo(step < 0 ? m_place : widgets::wayPlace(m_ends.count(), t));
  });
  connect(m_show, &QCheckBox::toggled, this, &InterpolationPanel::subjectChanged);
  connect(m_keep, &QPushButton::clicked, this, &InterpolationPanel::keep);
  connect(m_draw, &QPushButton::clicked, this, &InterpolationPanel::request);
  // What is edited or opened is what the user wants to see.
  for (const auto signal : {&Document::materialChanged, &Document::editChanged})
    connect(&m_document, signal, this, [this] { setShownInPreview(false); });
  connect(&m_document, &Document::materialChanged, this, &InterpolationPanel::materialChanged);
}

void InterpolationPanel::askForFile(int place) {
  auto* dialog = new QFileDialog(this, tr("Material %1").arg(QChar(u'A' + place)), {}, materialFilter());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this, place](const QString& path) {
    touched();
    m_ends.read(place, path);
  });
  dialog->open();
}

}  // namespace gonio::app
