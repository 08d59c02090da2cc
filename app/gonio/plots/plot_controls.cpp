// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/plots/plot_controls.h"

#include <QActionGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSettings>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>

#include "widgets/inputs/flow_layout.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"
#include "widgets/plots/plot_series.h"

namespace gonio::app {

using plots::SectionAxis;
using plots::SliceCoordinates;
using widgets::NumberField;

namespace {

const QString stateKey = QStringLiteral("plots/%1"), logarithmicKey = QStringLiteral("plots/logarithmic/%1");

QComboBox* comboBox(const QStringList& entries, const QString& name, const QString& toolTip) {
  auto* box = new QComboBox;
  box->addItems(entries);
  box->setAccessibleName(name);
  box->setToolTip(toolTip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  return box;
}

}  // namespace

widgets::PlotSettings PlotChoices::settingsOf(PlotKind of) const {
  widgets::PlotSettings result = settings;
  result.logarithmic = logarithmic[std::size_t(of)];
  return result;
}

plots::Section PlotChoices::section() const {
  return {.axis = axis,
          .thetaI = settings.thetaI,
          .planeAzimuth = planeAzimuth,
          .thetaH = thetaH,
          .thetaD = settings.thetaI,
          .phiD = phiD,
          .cosine = settings.cosine};
}

PlotControls::PlotControls(QWidget* parent) : QWidget(parent) {
  constexpr int margin = 4, space = 4;
  auto* layout = new widgets::FlowLayout(this);  // all of it stays in sight in a narrow window
  layout->setContentsMargins(margin, margin / 2, margin, margin / 2);
  layout->setSpacing(space);
  addKinds();
  addSections();
  addIncidence();
  addValues();
  addExport();
  show(m_choices);
}

template <class Change>
void PlotControls::change(Change change) {
  PlotChoices choices = m_choices;
  change(choices);
  setChoices(choices);
}

void PlotControls::setChoices(const PlotChoices& choices) {
  const bool same = choices == m_choices;
  m_choices = choices;
  show(m_choices);
  if (!same) Q_EMIT changed();
}

void PlotControls::setThetaI(double thetaI) {
  change([thetaI](PlotChoices& choices) { choices.settings.thetaI = std::clamp(thetaI, 0.0, widgets::maxThetaI); });
}

void PlotControls::addKinds() {
  m_kinds = new QTabBar;
  m_kinds->setDrawBase(false);
  m_kinds->setExpanding(false);
  m_kinds->setUsesScrollButtons(false);
  m_kinds->setAccessibleName(tr("Kind of plot"));
  const std::pair<QString, QString> kinds[] = {
      {tr("Polar"), tr("The lobe in the plane of incidence")},
      {tr("Cartesian"), tr("BRDF values vs. θh, θd or θo")},
      {tr("Slice"), tr("BRDF values over two coordinates in false colour")},
      {tr("Albedo"), tr("Directional albedo: fraction of uniform light that is reflected towards the viewer, vs. the "
                        "polar angle of the viewer")},
      {tr("3-D lobe"), tr("BRDF values over all directions of the viewer as a surface that can be rotated")}};
  for (const auto& [name, toolTip] : kinds) m_kinds->setTabToolTip(m_kinds->addTab(name), toolTip);
  connect(m_kinds, &QTabBar::currentChanged, this,
          [this](int index) { change([index](PlotChoices& choices) { choices.kind = PlotKind(index); }); });
  layout()->addWidget(m_kinds);
}

QWidget* PlotControls::addLabelled(const QString& text, QWidget* widget) {
  auto* both = new QWidget;
  both->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  auto* layout = new QHBoxLayout(both);
  layout->setContentsMargins(6, 0, 0, 0);
  auto* label = new QLabel(text);
  label->setBuddy(widget);
  label->setToolTip(widget->toolTip());
  label->setVisible(!text.isEmpty());
  layout->addWidget(label);
  layout->addWidget(widget);
  this->layout()->addWidget(both);
  return both;
}

QWidget* PlotControls::addNumber(const QString& label, const QString& toolTip, double min, double max,
                                 double PlotChoices::*member, NumberField*& field) {
  field = new NumberField;
  field->setRange(min, max);
  field->setUnit(QStringLiteral("°"), degrees(1));
  field->setStep(radians(1));
  field->setToolTip(toolTip);
  field->setAccessibleName(toolTip);
  field->setFixedWidth(fontMetrics().height() * 5);
  connect(field, &NumberField::valueEdited, this,
          [this, member](double value) { change([&](PlotChoices& choices) { choices.*member = value; }); });
  return addLabelled(label, field);
}

void PlotControls::addSections() {
  m_axis = comboBox({tr("vs. θh"), tr("vs. θd"), tr("vs. θo")}, tr("Axis"),
                    tr("θh: half vector from the normal; θd: half the angle between light and viewer; θo: viewer"));
  connect(m_axis, &QComboBox::activated, this,
          [this](int index) { change([index](PlotChoices& choices) { choices.axis = SectionAxis(index); }); });
  m_axisRow = addLabelled({}, m_axis);
  QStringList coordinates;
  for (const auto each :
       {SliceCoordinates::halfDifference, SliceCoordinates::halfOut, SliceCoordinates::projectedDeviation})
    coordinates << QStringLiteral("%1, %2").arg(QString::fromUtf8(plots::axesOf(each).acrossSymbol),
                                                QString::fromUtf8(plots::axesOf(each).upSymbol));
  m_coordinates = comboBox(coordinates, tr("Coordinates"),
                           tr("Axes of the slice: half-difference, half-out (half vector and viewer), or projected "
                              "deviation vector and mirror direction"));
  connect(m_coordinates, &QComboBox::activated, this, [this](int index) {
    change([index](PlotChoices& choices) { choices.coordinates = SliceCoordinates(index); });
  });
  m_coordinatesRow = addLabelled({}, m_coordinates);
  m_spacing = comboBox({tr("Linear axis"), tr("Square root, as in MERL")}, tr("Spacing of the horizontal axis"),
                       tr("Spacing of the horizontal axis: linear, or by the square root as that of θh in MERL files, "
                          "which magnifies the highlight"));
  connect(m_spacing, &QComboBox::activated, this, [this](int index) {
    change([index](PlotChoices& choices) { choices.spacing = plots::ThetaHSpacing(index); });
  });
  m_spacingRow = addLabelled({}, m_spacing);
  m_phiDRow = addNumber(tr("φd"), tr("Azimuth of the light about the half vector"), 0, pi, &PlotChoices::phiD, m_phiD);
  m_thetaHRow = addNumber(tr("θh"), tr("Angle of the half vector from the normal"), 0, radians(89),
                          &PlotChoices::thetaH, m_thetaH);
  m_planeAzimuthRow = addNumber(tr("φ"), tr("Azimuth of the viewer's plane from the plane of incidence"), 0, pi,
                                &PlotChoices::planeAzimuth, m_planeAzimuth);
}

void PlotControls::addIncidence() {
  const QString toolTip = tr(
      "Angle of incidence: between the direction to the light and the normal. Drag it in the plot; Ctrl + drag on the "
      "sphere in the preview sets it to the viewing angle there (not to the angle of the light).");
  m_thetaISlider = new widgets::ParameterSlider;
  m_thetaISlider->setRange(0, widgets::maxThetaI, models::ParameterScale::angle);
  m_thetaISlider->setFixedWidth(fontMetrics().height() * 8);
  m_thetaISlider->setToolTip(toolTip);
  m_thetaISlider->setAccessibleName(tr("Angle of incidence"));
  connect(m_thetaISlider, &widgets::ParameterSlider::numberEdited, this, &PlotControls::setThetaI);
  connect(m_thetaISlider, &widgets::ParameterSlider::resetRequested, this,
          [this] { setThetaI(widgets::PlotSettings().thetaI); });
  m_thetaI = new NumberField;
  m_thetaI->setRange(0, widgets::maxThetaI);
  m_thetaI->setUnit(QStringLiteral("°"), degrees(1));
  m_thetaI->setStep(radians(1));
  m_thetaI->setFixedWidth(fontMetrics().height() * 5);
  m_thetaI->setToolTip(toolTip);
  m_thetaI->setAccessibleName(tr("Angle of incidence"));
  connect(m_thetaI, &NumberField::valueEdited, this, &PlotControls::setThetaI);
  QWidget* row = addLabelled(tr("θi"), m_thetaISlider);
  row->layout()->addWidget(m_thetaI);
  auto* pick = new QCheckBox(tr("Pick on sphere"));
  pick->setToolTip(
      tr("Sets θi to the viewing angle (not the angle of the light) at the point of the sphere that is clicked in the "
         "preview (also Ctrl + drag)"));
  connect(pick, &QCheckBox::toggled, this, &PlotControls::pickingToggled);
  addLabelled({}, pick);
}

void PlotControls::addValues() {
  using plots::Channel, plots::CosineFactor;
  QStringList channels, cosines;
  for (const auto channel : {Channel::luminance, Channel::red, Channel::green, Channel::blue})
    channels << widgets::channelName(channel);
  for (const auto cosine : {CosineFactor::none, CosineFactor::incident, CosineFactor::outgoing})
    cosines << widgets::cosineName(cosine);
  m_channel = comboBox(channels, tr("Channel"), tr("Channel or luminance"));
  connect(m_channel, &QComboBox::activated, this,
          [this](int index) { change([index](PlotChoices& choices) { choices.settings.channel = Channel(index); }); });
  addLabelled({}, m_channel);
  m_cosine = comboBox(
      cosines, tr("Cosine"),
      tr("Plots the BRDF value ρ alone, or times the cosine of the light (proportional to the radiance under a "
         "distant light) or of the viewer"));
  connect(m_cosine, &QComboBox::activated, this, [this](int index) {
    change([index](PlotChoices& choices) { choices.settings.cosine = CosineFactor(index); });
  });
  m_cosineRow = addLabelled({}, m_cosine);
  m_logarithmic = new QCheckBox(tr("Logarithmic"));
  m_logarithmic->setObjectName("logarithmic");
  m_logarithmic->setToolTip(tr("Logarithmic value axis; a separate setting for each kind of plot"));
  connect(m_logarithmic, &QCheckBox::toggled, this, [this](bool on) {
    change([on](PlotChoices& choices) { choices.logarithmic[std::size_t(choices.kind)] = on; });
  });
  addLabelled({}, m_logarithmic);
}

void PlotControls::addExport() {
  m_export = new QToolButton;
  m_export->setText(tr("Export"));
  m_export->setToolTip(tr("Writes this plot to a file"));
  m_export->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_export);
  const std::pair<QString, const char*> formats[] = {
      {tr("Image as &SVG..."), "svg"}, {tr("Image as &PNG..."), "png"}, {tr("Numbers as &CSV..."), "csv"}};
  for (const auto& [text, suffix] : formats)
    menu->addAction(text, this,
                    [this, suffix = suffix] { Q_EMIT exportRequested(QLatin1String(suffix), m_exportSize); });
  menu->addSeparator();
  addExportSizes(menu->addMenu(tr("&Size of Images")));
  m_export->setMenu(menu);
  layout()->addWidget(m_export);
}

void PlotControls::addExportSizes(QMenu* menu) {
  auto* group = new QActionGroup(menu);
  for (const QSize& size : {QSize(), QSize(800, 500), QSize(1200, 800), QSize(1600, 1000)}) {
    const QString text = size.isEmpty() ? tr("&As shown") : tr("%1 × %2").arg(size.width()).arg(size.height());
    QAction* action = group->addAction(menu->addAction(text));
    action->setCheckable(true);
    action->setChecked(size == m_exportSize);
    connect(action, &QAction::triggered, this, [this, size] { m_exportSize = size; });
  }
  menu->setToolTip(tr("PNG images have twice this width and height in pixels"));
}

void PlotControls::setExportEnabled(bool enabled) { m_export->setEnabled(enabled); }

void PlotControls::show(const PlotChoices& choices) {
  m_kinds->setCurrentIndex(int(choices.kind));
  m_axis->setCurrentIndex(int(choices.axis));
  m_spacing->setCurrentIndex(int(choices.spacing));
  m_channel->setCurrentIndex(int(choices.settings.channel));
  m_cosine->setCurrentIndex(int(choices.settings.cosine));
  m_logarithmic->setChecked(choices.logarithmic[std::size_t(choices.kind)]);
  m_thetaISlider->setNumber(choices.settings.thetaI);
  m_thetaI->setValue(choices.settings.thetaI);
  m_phiD->setValue(choices.phiD);
  m_thetaH->setValue(choices.thetaH);
  m_planeAzimuth->setValue(choices.planeAzimuth);
  m_coordinates->setCurrentIndex(int(choices.coordinates));
  const bool cartesian = choices.kind == PlotKind::cartesian;
  const plots::SliceAxes& axes = plots::axesOf(cartesian ? SliceCoordinates::halfDifference : choices.coordinates);
  auto* azimuth = m_phiDRow->findChild<QLabel*>();
  azimuth->setText(QString::fromUtf8(axes.azimuthSymbol));
  for (QWidget* widget : {static_cast<QWidget*>(azimuth), static_cast<QWidget*>(m_phiD)})
    widget->setToolTip(tr(axes.azimuthMeaning));
  m_phiD->setAccessibleName(tr(axes.azimuthMeaning));
  m_coordinatesRow->setVisible(choices.kind == PlotKind::slice);
  m_axisRow->setVisible(cartesian);
  m_spacingRow->setVisible(choices.kind == PlotKind::slice);
  m_phiDRow->setVisible(choices.kind == PlotKind::slice || (cartesian && choices.axis != SectionAxis::thetaO));
  m_thetaHRow->setVisible(cartesian && choices.axis == SectionAxis::thetaD);
  m_planeAzimuthRow->setVisible(cartesian && choices.axis == SectionAxis::thetaO);
  m_cosineRow->setVisible(choices.kind != PlotKind::albedo);
}

void PlotControls::saveState(QSettings& settings) const {
  settings.setValue(stateKey.arg("kind"), int(m_choices.kind));
  settings.setValue(stateKey.arg("channel"), int(m_choices.settings.channel));
  settings.setValue(stateKey.arg("cosine"), int(m_choices.settings.cosine));
  for (const PlotKind kind : allPlotKinds)
    settings.setValue(logarithmicKey.arg(int(kind)), m_choices.logarithmic[std::size_t(kind)]);
  settings.setValue(stateKey.arg("axis"), int(m_choices.axis));
  settings.setValue(stateKey.arg("spacing"), int(m_choices.spacing));
  settings.setValue(stateKey.arg("coordinates"), int(m_choices.coordinates));
}

void PlotControls::restoreState(const QSettings& settings) {
  const auto number = [&settings](const char* key, int standard, int last) {
    return std::clamp(settings.value(stateKey.arg(key), standard).toInt(), 0, last);
  };
  PlotChoices choices = m_choices;
  choices.kind = PlotKind(number("kind", int(choices.kind), int(PlotKind::lobe)));
  choices.settings.channel = plots::Channel(number("channel", 0, 3));
  choices.settings.cosine = plots::CosineFactor(number("cosine", 0, 2));
  for (const PlotKind kind : allPlotKinds) {
    bool& logarithmic = choices.logarithmic[std::size_t(kind)];
    logarithmic = settings.value(logarithmicKey.arg(int(kind)), logarithmic).toBool();
  }
  choices.axis = SectionAxis(number("axis", int(choices.axis), int(SectionAxis::thetaO)));
  choices.spacing = plots::ThetaHSpacing(number("spacing", int(choices.spacing), 1));
  choices.coordinates = SliceCoordinates(number("coordinates", int(choices.coordinates), 2));
  setChoices(choices);
}

}  // namespace gonio::app

#include "moc_plot_controls.cpp"
