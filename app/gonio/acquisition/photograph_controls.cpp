// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/photograph_controls.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "app/gonio/scene/scene_panel.h"
#include "core/rendering/environment.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

namespace {

constexpr double maxPixels = 1e5, minSphereDistance = 1.001, minDistance = 1e-3, maxDistance = 1e4, maxIrradiance = 1e6;
const QString environmentFolder = QStringLiteral("environment"), environmentFile = QStringLiteral("file");

/// Two widgets beside each other in one row of a form.
QWidget* pairOf(QWidget* first, QWidget* second) {
  auto* pair = new QWidget;
  auto* row = new QHBoxLayout(pair);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(first);
  row->addWidget(second);
  row->addStretch();
  return pair;
}

QLabel* photographLabel(const QString& text, QWidget* buddy) {
  auto* label = new QLabel(text);
  label->setBuddy(buddy);
  return label;
}

widgets::NumberField* pixelField(const QString& name, const QString& toolTip) {
  return rowField(name, toolTip, 0, maxPixels, 1, PhotographControls::tr("px"));
}

widgets::NumberField* angleField(const QString& name, const QString& toolTip, double limit) {
  return rowField(name, toolTip, -limit, limit, radians(1), QStringLiteral("°"), degrees(1));
}

}  // namespace

PhotographControls::PhotographControls(PhotographSession& session) : m_session(session) {
  m_form = new QFormLayout(this);
  m_form->setContentsMargins(0, 0, 4, 0);
  m_form->setVerticalSpacing(4);
  m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  buildFiles(*m_form);
  buildOutline(*m_form);
  buildCamera(*m_form);
  buildLight(*m_form);
  buildExposure(*m_form);
  connectFields();
  refresh();
}

void PhotographControls::buildFiles(QFormLayout& form) {
  auto* open = new QPushButton(tr("&Open..."));
  open->setToolTip(
      tr("Opens linear images of a sphere (EXR, Radiance HDR), or a JSON description of photographs.\n"
         "Images are added; a description replaces all photographs."));
  m_remove = new QPushButton(tr("&Remove"));
  m_remove->setToolTip(tr("Removes the current photograph; its file stays"));
  m_save = new QPushButton(tr("&Save..."));
  m_save->setAccessibleName(tr("Save Description"));
  m_save->setToolTip(
      tr("Saves a JSON description of all photographs with their outlines, cameras and lights, which this panel and "
         "goniotool photograph read"));
  auto* row = new QHBoxLayout;
  for (QPushButton* button : {open, m_remove, m_save}) row->addWidget(button);
  form.addRow(row);
  m_name = rowHeading({});
  m_name->setTextFormat(Qt::PlainText);
  m_name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  form.addRow(m_name);
  connect(open, &QPushButton::clicked, this, &PhotographControls::openRequested);
  connect(m_save, &QPushButton::clicked, this, &PhotographControls::saveRequested);
  connect(m_remove, &QPushButton::clicked, this, [this] {
    if (m_current >= 0) m_session.remove(std::size_t(m_current));
  });
}

void PhotographControls::buildOutline(QFormLayout& form) {
  m_x = pixelField(tr("Centre x"), tr("Centre of the sphere's outline, pixels from the left edge of the image"));
  m_y = pixelField(tr("Centre y"), tr("Centre of the sphere's outline, pixels from the top edge of the image"));
  m_radius = pixelField(tr("Radius"), tr("Radius of the sphere's outline, pixels"));
  m_radius->setRange(matching::minDiscRadius, maxPixels);
  m_find = new QPushButton(tr("&Find"));
  m_find->setToolTip(tr("Finds the outline of the sphere in the image again"));
  m_find->setFixedWidth(m_radius->width());
  form.addRow(photographLabel(tr("Outline x, y"), m_x), pairOf(m_x, m_y));
  form.addRow(photographLabel(tr("Outline radius"), m_radius), pairOf(m_radius, m_find));
}

void PhotographControls::buildCamera(QFormLayout& form) {
  m_distance =
      rowField(tr("Camera distance"),
               tr("Distance of the camera from the centre of the sphere or sample, in radii of the sphere or cylinder, "
                  "or in the unit of length of a flat sample"),
               minSphereDistance, maxDistance, 0.1, tr("radii"));
  m_azimuth = angleField(tr("Camera azimuth"),
                         tr("Azimuth of the camera in the axes of the light: 0° looks at the middle of an environment "
                            "map, positive angles are to the right"),
                         pi);
  m_elevation = angleField(tr("Camera elevation"),
                           tr("Elevation of the camera above the centre of the sphere or sample"), radians(89));
  form.addRow(photographLabel(tr("Camera distance"), m_distance), pairOf(m_distance, new QWidget));
  form.addRow(photographLabel(tr("Camera angles"), m_azimuth), pairOf(m_azimuth, m_elevation));
}

void PhotographControls::buildLight(QFormLayout& form) {
  m_kind = rowBox(tr("Light of the photograph: an environment map, or one distant light"));
  m_kind->addItems({tr("Environment"), tr("Distant light"), tr("As described")});  // in the order of Kind
  m_kind->setItemData(int(PhotographLight::Kind::other), tr("The lights of the description"), Qt::ToolTipRole);
  m_useForAll = new QPushButton(tr("For &All"));
  m_useForAll->setToolTip(tr("Gives all photographs the light of this one"));
  auto* row = new QHBoxLayout;
  row->addWidget(m_kind, 1);
  row->addWidget(m_useForAll);
  form.addRow(photographLabel(tr("&Light"), m_kind), row);
  m_environment = rowBox(tr("Environment: a bundled one, or a latitude-longitude map of radiance (EXR, HDR)"));
  for (const std::string& name : rendering::bundledEnvironmentNames())
    m_environment->addItem(sceneTitle(name), QString::fromStdString(name));
  m_environment->addItem(tr("File..."), environmentFile);
  form.addRow(photographLabel(tr("&Environment"), m_environment), m_environment);
  m_rotation = angleField(tr("Rotation"),
                          tr("Rotation of the environment about the vertical axis; positive angles move its middle to "
                             "the right"),
                          2 * pi);
  form.addRow(photographLabel(tr("Rotation"), m_rotation), m_rotation);
  m_lightAzimuth = angleField(tr("Light azimuth"),
                              tr("Azimuth toward the light: 0° is the side of a camera with "
                                 "azimuth 0°, positive angles are to the right"),
                              pi);
  m_lightElevation = angleField(tr("Light elevation"), tr("Elevation toward the light"), halfPi);
  m_lightDirection = pairOf(m_lightAzimuth, m_lightElevation);
  form.addRow(photographLabel(tr("Light angles"), m_lightAzimuth), m_lightDirection);
  m_irradiance = rowField(tr("Irradiance"),
                          tr("Irradiance by the light, perpendicular to its direction, in the unit of the image times "
                             "sr; mean of red, green and blue"),
                          0, maxIrradiance, 0.1, {});
  form.addRow(photographLabel(tr("Irradiance"), m_irradiance), m_irradiance);
}

void PhotographControls::buildExposure(QFormLayout& form) {
  m_exposure =
      rowBox(tr("Known: pixel values are radiances in the unit of the light.\n"
                "Unknown: all photographs have a common unknown factor, which is estimated."));
  m_exposure->addItems({tr("Known"), tr("Unknown")});
  form.addRow(photographLabel(tr("E&xposure"), m_exposure), m_exposure);
  m_ofItem = {m_remove,       m_save,           m_x,          m_y,       m_radius,      m_find,
              m_distance,     m_azimuth,        m_elevation,  m_kind,    m_environment, m_rotation,
              m_lightAzimuth, m_lightElevation, m_irradiance, m_exposure};
}

void PhotographControls::connectFields() {
  for (widgets::NumberField* field : {m_x, m_y, m_radius})
    connect(field, &widgets::NumberField::valueEdited, this, &PhotographControls::editDisc);
  for (widgets::NumberField* field : {m_distance, m_azimuth, m_elevation})
    connect(field, &widgets::NumberField::valueEdited, this, &PhotographControls::editCamera);
  for (widgets::NumberField* field : {m_rotation, m_lightAzimuth, m_lightElevation, m_irradiance})
    connect(field, &widgets::NumberField::valueEdited, this, &PhotographControls::editLight);
  connect(m_kind, &QComboBox::activated, this, &PhotographControls::editLight);
  connect(m_environment, &QComboBox::activated, this, &PhotographControls::chooseEnvironment);
  connect(m_exposure, &QComboBox::activated, this, [this](int index) { m_session.setExposureKnown(index == 0); });
  connect(m_find, &QPushButton::clicked, this, [this] { m_session.findOutline(std::size_t(m_current)); });
  connect(m_useForAll, &QPushButton::clicked, this, [this] { m_session.useLightForAll(std::size_t(m_current)); });
}

void PhotographControls::setCurrent(int index) {
  m_current = index;
  refresh();
}

void PhotographControls::refresh() {
  const PhotographInputs& inputs = m_session.inputs();
  const bool hasItem = m_current >= 0 && std::size_t(m_current) < inputs.size();
  for (QWidget* part : m_ofItem) part->setEnabled(hasItem);
  m_useForAll->setEnabled(hasItem && inputs.size() > 1);
  m_exposure->setCurrentIndex(inputs.isExposureKnown() ? 0 : 1);
  showItem(hasItem ? inputs[std::size_t(m_current)] : PhotographItem());
}

void PhotographControls::showItem(const PhotographItem& item) {
  const bool hasItem = !item.entry.is_null();
  m_name->setText(hasItem ? item.name() : tr("No photograph"));
  m_name->setToolTip(hasItem ? item.path() : QString());
  const matching::Disc disc = hasItem ? item.disc() : matching::Disc();
  if (hasItem) {
    m_x->setRange(0, item.size.width());
    m_y->setRange(0, item.size.height());
  }
  m_x->setValue(disc.x);
  m_y->setValue(disc.y);
  m_radius->setValue(disc.radius);
  const bool hasOutline = !hasItem || item.hasOutline();
  for (const widgets::NumberField* field : {m_x, m_radius}) m_form->setRowVisible(field->parentWidget(), hasOutline);
  const bool isFlat = !hasOutline && item.entry["shape"].contains("flat");
  m_distance->setRange(isFlat ? minDistance : minSphereDistance, maxDistance);
  m_distance->setUnit(isFlat ? QString() : tr("radii"));
  const PhotographCamera camera = hasItem ? item.camera() : PhotographCamera();
  m_distance->setValue(camera.distance);
  m_azimuth->setValue(camera.azimuth);
  m_elevation->setValue(camera.elevation);
  showLight(item);
}

void PhotographControls::showLight(const PhotographItem& item) {
  using Kind = PhotographLight::Kind;
  PhotographLight light, described;
  if (!item.entry.is_null()) {
    light = item.light();
    PhotographItem asRead = item;
    asRead.entry["lights"] = item.describedLights;
    described = asRead.light();
  }
  m_kind->setCurrentIndex(int(light.kind));
  hideItem(*m_kind, int(Kind::other), described.kind != Kind::other);
  m_form->setRowVisible(m_environment, light.kind == Kind::environment);
  m_form->setRowVisible(m_rotation, light.kind == Kind::environment);
  m_form->setRowVisible(m_lightDirection, light.kind == Kind::distant);
  m_form->setRowVisible(m_irradiance, light.kind == Kind::distant);
  showEnvironment(light.environment);
  m_rotation->setValue(light.rotation);
  m_lightAzimuth->setValue(light.azimuth);
  m_lightElevation->setValue(light.elevation);
  m_irradiance->setValue(light.irradiance);
}

void PhotographControls::showEnvironment(const QString& name) {
  int index = m_environment->findData(name);
  if (index < 0) {
    index = m_environment->count() - 1;  // before "File..."
    m_environment->insertItem(index, name.section('/', -1), name);
    m_environment->setItemData(index, name, Qt::ToolTipRole);
  }
  m_environment->setCurrentIndex(index);
}

void PhotographControls::editDisc() {
  if (m_current >= 0) m_session.setDisc(std::size_t(m_current), {m_x->value(), m_y->value(), m_radius->value()});
}

void PhotographControls::editCamera() {
  if (m_current >= 0)
    m_session.setCamera(std::size_t(m_current), {m_distance->value(), m_azimuth->value(), m_elevation->value()});
}

void PhotographControls::editLight() {
  if (m_current < 0) return;
  PhotographLight light = m_session.inputs()[std::size_t(m_current)].light();
  const PhotographLight::Kind before = light.kind;
  light.kind = PhotographLight::Kind(m_kind->currentIndex());
  light.rotation = m_rotation->value();
  light.azimuth = m_lightAzimuth->value();
  light.elevation = m_lightElevation->value();
  light.irradiance = m_irradiance->value();
  if (light.kind == PhotographLight::Kind::distant && before != light.kind) {
    // A white diffuse surface that faces the light has the radiance 1.
    light.irradiance = pi;
    light.elevation = radians(45);
  }
  m_session.setLight(std::size_t(m_current), light);
}

void PhotographControls::chooseEnvironment(int index) {
  const QString name = m_environment->itemData(index).toString();
  if (name == environmentFile) {
    refresh();  // until a file is chosen, the box shows the environment that is
    return askForEnvironment();
  }
  PhotographLight light = m_session.inputs()[std::size_t(m_current)].light();
  light.environment = name;
  m_session.setLight(std::size_t(m_current), light);
}

void PhotographControls::askForEnvironment() {
  auto* dialog = new QFileDialog(this, tr("Environment of the Photograph"), widgets::dialogFolder(environmentFolder),
                                 tr("Environments (*.hdr *.exr);;All files (*)"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  widgets::openFileDialog(dialog, [this, current = m_current](const QString& path) {
    widgets::rememberDialogFolder(environmentFolder, path);
    if (current < 0 || std::size_t(current) >= m_session.inputs().size()) return;
    PhotographLight light = m_session.inputs()[std::size_t(current)].light();
    light.kind = PhotographLight::Kind::environment;
    light.environment = path;
    m_session.setLight(std::size_t(current), light);
  });
}

}  // namespace gonio::app

#include "moc_photograph_controls.cpp"
