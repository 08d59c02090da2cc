// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_picture_settings.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QSpinBox>

#include "app/gonio/scene/scene_panel.h"
#include "core/io/mesh_file.h"
#include "core/rendering/environment.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/scene_file.h"
#include "widgets/inputs/dialog_folder.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/open_file_dialog.h"

namespace gonio::app {

using figures::FigurePictures;

namespace {
/// Data of the last entry of a box; the data of the others are names.
const QString fileEntry = QStringLiteral("file...");
}  // namespace

FigurePictureSettings::FigurePictureSettings(QWidget* parent) : QWidget(parent) {
  m_scene = nameBox(sceneTitle(bundledComparisonScene), bundledSceneNames(), tr("Scene or mesh file..."));
  m_environment = nameBox(tr("From scene"), bundledEnvironmentNames(), tr("Environment file..."));
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
    if (name != bundledComparisonScene) box->addItem(sceneTitle(name), QString::fromStdString(name));
  box->addItem(file, fileEntry);
  return box;
}

void FigurePictureSettings::build() {
  m_scene->setToolTip(tr("Scene of the images and of the rendered SNR in this figure; all objects have the material. "
                         "Everywhere else, the rendered SNR uses the scene %1.")
                          .arg(sceneTitle(bundledComparisonScene)));
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
          .toneMap = ToneMap(m_toneMap->currentIndex())};
}

void FigurePictureSettings::setPictures(const FigurePictures& pictures) {
  const QSignalBlocker quiet(this);
  const bool isComparison = pictures.scene == comparisonSceneName || pictures.scene == bundledComparisonScene;
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

}  // namespace gonio::app

#include "moc_figure_picture_settings.cpp"
