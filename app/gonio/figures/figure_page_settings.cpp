// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_page_settings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFontDatabase>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>

#include "app/gonio/scene/scene_panel.h"
#include "core/figures/figure_layout.h"
#include "core/io/mesh_file.h"
#include "core/rendering/environment.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/scene_file.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

using figures::FigurePictures;

namespace {
/// Data of the last entry of a box; the data of the others are names.
const QString fileEntry = QStringLiteral("file...");
}  // namespace

FigurePictureSettings::FigurePictureSettings(QWidget* parent) : QWidget(parent) {
  m_scene = nameBox(sceneTitle(rendering::bundledComparisonScene), rendering::bundledSceneNames(),
                    tr("Scene or mesh file..."));
  m_environment = nameBox(tr("From scene"), rendering::bundledEnvironmentNames(), tr("Environment file..."));
  m_size = new QSpinBox;
  m_samples = new QSpinBox;
  m_exposure = new widgets::NumberField;
  m_toneMap = new QComboBox;
  build();
  setPictures({});
  const QString sceneFilter =
      tr("Scenes and meshes (*.json %1)").arg(QString::fromStdString(io::meshSuffixList("*")).remove(','));
  connect(m_scene, &QComboBox::activated, this, [this, sceneFilter] { choose(*m_scene, tr("Scene"), sceneFilter); });
  connect(m_environment, &QComboBox::activated, this,
          [this] { choose(*m_environment, tr("Environment"), tr("Environments (*.hdr *.exr)")); });
  for (QSpinBox* box : {m_size, m_samples})
    connect(box, &QSpinBox::valueChanged, this, &FigurePictureSettings::changed);
  connect(m_exposure, &widgets::NumberField::valueEdited, this, &FigurePictureSettings::changed);
  connect(m_toneMap, &QComboBox::currentIndexChanged, this, &FigurePictureSettings::changed);
}

QComboBox* FigurePictureSettings::nameBox(const QString& usual, const std::vector<std::string>& names,
                                          const QString& file) {
  auto* box = new QComboBox;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  box->addItem(usual, QString());
  for (const std::string& name : names)
    if (name != rendering::bundledComparisonScene) box->addItem(sceneTitle(name), QString::fromStdString(name));
  box->addItem(file, fileEntry);
  return box;
}

void FigurePictureSettings::build() {
  m_scene->setToolTip(tr("Scene of the images and of the rendered SNR in this figure; all objects have the material. "
                         "Everywhere else, the rendered SNR uses the scene %1.")
                          .arg(sceneTitle(rendering::bundledComparisonScene)));
  m_environment->setToolTip(tr("Replaces the light of the scene"));
  m_size->setRange(1, FigurePictures::maxSize);
  m_size->setSuffix(tr(" pixels"));
  m_size->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  m_size->setToolTip(tr("Width and height of the images; print needs about 300 pixels per inch"));
  m_samples->setRange(1, FigurePictures::maxSamples);
  m_samples->setSuffix(tr(" per pixel"));
  m_samples->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  m_samples->setToolTip(tr("More samples reduce the noise and take more time"));
  m_exposure->setRange(-FigurePictures::maxExposure, FigurePictures::maxExposure);
  m_exposure->setUnit(tr("EV"));
  m_exposure->setStep(0.5);
  m_exposure->setToolTip(tr("Exposure of the images in stops; error maps do not depend on it"));
  m_toneMap->addItems({tr("Clamp"), tr("Filmic")});
  m_toneMap->setToolTip(tr("Clamp clips values above 1; filmic compresses highlights"));
  // Typed numbers change the figure when they are complete.
  for (QSpinBox* box : {m_size, m_samples}) box->setKeyboardTracking(false);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("S&cene"), m_scene);
  form->addRow(tr("En&vironment"), m_environment);
  form->addRow(tr("Si&ze"), m_size);
  form->addRow(tr("Sam&ples"), m_samples);
  form->addRow(tr("E&xposure"), m_exposure);
  form->addRow(tr("Ton&e map"), m_toneMap);
}

FigurePictures FigurePictureSettings::pictures() const {
  return {.scene = m_sceneName,
          .environment = m_environmentName,
          .size = m_size->value(),
          .samples = m_samples->value(),
          .exposure = m_exposure->value(),
          .toneMap = rendering::ToneMap(m_toneMap->currentIndex())};
}

void FigurePictureSettings::setPictures(const FigurePictures& pictures) {
  const QSignalBlocker quiet(this);
  const bool isComparison =
      pictures.scene == rendering::comparisonSceneName || pictures.scene == rendering::bundledComparisonScene;
  selectName(*m_scene, m_sceneName = isComparison ? "" : pictures.scene);
  selectName(*m_environment, m_environmentName = pictures.environment);
  m_size->setValue(pictures.size);
  m_samples->setValue(pictures.samples);
  m_exposure->setValue(pictures.exposure);
  m_toneMap->setCurrentIndex(int(pictures.toneMap));
}

void FigurePictureSettings::selectName(QComboBox& box, const std::string& name) {
  const QString wanted = QString::fromStdString(name);
  int index = box.findData(wanted);
  if (index < 0) {
    index = box.count() - 1;
    box.insertItem(index, wanted.section('/', -1), wanted);
    box.setItemData(index, wanted, Qt::ToolTipRole);
  }
  box.setCurrentIndex(index);
}

void FigurePictureSettings::choose(QComboBox& box, const QString& title, const QString& filter) {
  std::string& name = &box == m_scene ? m_sceneName : m_environmentName;
  const QString chosen = box.currentData().toString();
  if (chosen != fileEntry) {
    name = chosen.toStdString();
    return Q_EMIT changed();
  }
  selectName(box, name);  // until a file is chosen
  const QString purpose = &box == m_scene ? QStringLiteral("scene") : QStringLiteral("environment");
  auto* dialog = new QFileDialog(this, title, widgets::dialogFolder(purpose), filter);
  dialog->setFileMode(QFileDialog::ExistingFile);
  widgets::openFileDialog(dialog, [this, &box, &name, purpose](const QString& path) {
    widgets::rememberDialogFolder(purpose, path);
    selectName(box, name = path.toStdString());
    Q_EMIT changed();
  });
}

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
