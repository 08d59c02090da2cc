// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/scene/view_strip.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <algorithm>
#include <utility>

#include "app/gonio/document/background_task.h"
#include "app/gonio/library/thumbnail.h"
#include "app/gonio/scene/environment_controller.h"
#include "app/gonio/scene/scene_panel.h"
#include "core/models/model.h"
#include "core/rendering/environment.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/scene_file.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {

constexpr double maxStops = 5, hardStops = 10;
constexpr QSize lightIconSize(48, 24), sceneIconSize(40, 40);
constexpr int maxBoxCharacters = 34;
/// What a list holds beside names: the scene's own light, no environment, a file.
const QString own = QStringLiteral("own"), directional = QStringLiteral("directional"), file = QStringLiteral("file");
enum Background { plain, checker, environment, blurred };

QImage pictureOf(const rendering::EnvironmentMap& map) {
  Image small(lightIconSize.width(), lightIconSize.height());
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      small.at(x, y) = map.image().at(x * map.image().width / small.width, y * map.image().height / small.height);
  std::ranges::fill(small.alpha, 1.0f);
  return displayedImage(small);
}

}  // namespace

ViewStrip::ViewStrip(widgets::PreviewWidget& preview, ScenePanel& scene, EnvironmentController& environment,
                     BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_preview(preview),
      m_scene(scene),
      m_environment(environment),
      m_tasks(tasks),
      m_scenes(new QComboBox),
      m_lights(new QComboBox),
      m_backgrounds(new QComboBox),
      m_slider(new widgets::ParameterSlider),
      m_exposure(new widgets::NumberField) {
  build();
  connectParts();
  drawLights();
  refresh();
}

void ViewStrip::build() {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  const auto add = [&](const QString& text, QWidget* part) {
    auto* label = new QLabel(text);
    label->setBuddy(part);
    layout->addWidget(label);
    layout->addWidget(part);
  };
  QPixmap emptyIcon(sceneIconSize);  // the list has room for the icons before they are rendered
  emptyIcon.fill(Qt::transparent);
  for (const std::string& name : rendering::bundledSceneNames())
    m_scenes->addItem(QIcon(emptyIcon), sceneTitle(name), QString::fromStdString(name));
  m_scenes->addItem(tr("Mesh or scene..."), file);
  m_scenes->setToolTip(tr("Scene that shows the material: bundled, or a mesh or scene file"));
  m_lights->setToolTip(
      tr("Light of the scene; a chosen light stays when the scene changes. Shift + right drag rotates the "
         "environment."));
  m_backgrounds->addItem(tr("Plain"));
  m_backgrounds->addItem(tr("Checker"));
  m_backgrounds->addItem(tr("Environment"));
  m_backgrounds->addItem(tr("Environment, blurred"));
  m_backgrounds->setToolTip(tr("Background behind the object"));
  m_slider->setRange(-maxStops, maxStops, models::ParameterScale::linear);
  m_slider->setReference(0);
  m_slider->setToolTip(tr("Exposure in stops (Ctrl+[ darker, Ctrl+] brighter); double-click or Ctrl+\\ for 0"));
  m_slider->setAccessibleName(tr("Exposure"));
  m_exposure->setRange(-hardStops, hardStops);
  m_exposure->setUnit(tr("EV"));
  m_exposure->setStep(0.5);
  m_exposure->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("-10.25 EV")) + fontMetrics().height());
  m_exposure->setAccessibleName(tr("Exposure in stops"));
  for (QComboBox* box : {m_scenes, m_lights, m_backgrounds}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    box->setMaximumWidth(fontMetrics().averageCharWidth() * maxBoxCharacters);
    // A letter that is typed after a choice is a key of the preview; it would choose another entry.
    connect(box, &QComboBox::activated, this, [this] { m_preview.setFocus(Qt::OtherFocusReason); });
  }
  // Room for "Shader ball", "From scene" and "Plain" on the smallest screen.
  m_scenes->setMinimumContentsLength(9);
  m_lights->setMinimumContentsLength(8);
  m_backgrounds->setMinimumContentsLength(5);
  for (const auto& [box, size] : {std::pair(m_scenes, sceneIconSize), std::pair(m_lights, lightIconSize)}) {
    box->setIconSize({0, 0});  // icons only in the list: the names need the room of the box
    box->view()->setIconSize(size);
    box->setItemDelegate(new QStyledItemDelegate(box));  // that of the style draws icons in the size of the box
  }
  m_scenes->view()->installEventFilter(this);
  // The lists show whole names where the boxes have no room for them.
  for (QComboBox* box : {m_scenes, m_backgrounds})
    box->view()->setMinimumWidth(box->view()->sizeHintForColumn(0) + fontMetrics().height());
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  add(tr("Sce&ne"), m_scenes);
  add(tr("&Light"), m_lights);
  add(tr("&Background"), m_backgrounds);
  add(tr("E&xposure"), m_slider);
  layout->addWidget(m_exposure);
  layout->addStretch();
  for (QComboBox* box : {m_scenes, m_lights, m_backgrounds}) {  // a longer name gets more of the room
    const auto setStretch = [layout, box] {
      const QFontMetrics metrics = box->fontMetrics();
      layout->setStretchFactor(box, metrics.horizontalAdvance(box->currentText()) + 2 * metrics.height());
    };
    setStretch();
    connect(box, &QComboBox::currentTextChanged, this, setStretch);
  }
  m_slider->setMinimumWidth(fontMetrics().height() * 4);
  m_slider->setMaximumWidth(fontMetrics().height() * 6);
}

int ViewStrip::sliderRoom() const { return m_slider->minimumWidth() + layout()->spacing(); }

QSize ViewStrip::minimumSizeHint() const {
  const QSize laidOut = layout()->totalMinimumSize();
  return {laidOut.width() - (m_slider->isHidden() ? 0 : sliderRoom()), laidOut.height()};
}

void ViewStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  m_slider->setVisible(width() >= minimumSizeHint().width() + sliderRoom());
}

void ViewStrip::connectParts() {
  connect(m_scenes, &QComboBox::activated, this, [this](int index) {
    const QString name = m_scenes->itemData(index).toString();
    refresh();  // until the scene is there, the list shows the one that is
    if (name == file) return Q_EMIT sceneFileRequested();
    m_scene.open(name);
  });
  connect(m_lights, &QComboBox::activated, this, &ViewStrip::chooseLight);
  connect(m_backgrounds, &QComboBox::activated, this, &ViewStrip::chooseBackground);
  connect(m_slider, &widgets::ParameterSlider::numberEdited, &m_preview, &widgets::PreviewWidget::setExposure);
  connect(m_slider, &widgets::ParameterSlider::resetRequested, this, [this] { m_preview.setExposure(0); });
  connect(m_exposure, &widgets::NumberField::valueEdited, &m_preview, &widgets::PreviewWidget::setExposure);
  connect(&m_environment, &EnvironmentController::recentChanged, this, &ViewStrip::refresh);
  connect(&m_preview.content(), &widgets::PreviewContent::sceneChanged, this, &ViewStrip::refresh);
  connect(&m_preview, &widgets::PreviewWidget::displayChanged, this, &ViewStrip::refresh);
}

void ViewStrip::fillLights() {
  QStringList wanted{own};
  for (const std::string& name : rendering::bundledEnvironmentNames()) wanted << QString::fromStdString(name);
  wanted << directional;
  wanted << m_environment.recent();
  const QString current = m_environment.name();
  if (!current.isEmpty() && !wanted.contains(current)) wanted << current;
  wanted << file;
  QStringList present;
  for (int i = 0; i < m_lights->count(); ++i) present << m_lights->itemData(i).toString();
  if (present == wanted) return;
  QHash<QString, QIcon> icons;
  for (int i = 0; i < m_lights->count(); ++i) icons[present[i]] = m_lights->itemIcon(i);
  m_lights->clear();
  for (const QString& name : wanted) {
    const QString text = name == own           ? tr("From scene")
                         : name == directional ? tr("Distant light")
                         : name == file        ? tr("Image (HDR, EXR)...")
                         : name.contains('/')  ? name.section('/', -1)
                                               : sceneTitle(name.toStdString());
    m_lights->addItem(icons.value(name), text, name);
    if (name.contains('/')) m_lights->setItemData(m_lights->count() - 1, name, Qt::ToolTipRole);
  }
}

void ViewStrip::drawLights() {
  for (const std::string& name : rendering::bundledEnvironmentNames()) {
    const QString id = QString::fromStdString(name);
    m_tasks.run<QImage>(
        {.title = tr("Rendering the icon of the environment %1").arg(id),
         .key = QStringLiteral("environment icon ") + id,
         .quiet = true},
        [name](const TaskControl&) { return pictureOf(*rendering::openEnvironment(name)); },
        [this, id](const QImage& picture) { setLightIcon(id, picture); });
  }
}

bool ViewStrip::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show && !std::exchange(m_hasSceneIcons, true)) drawScenes();
  return QWidget::eventFilter(watched, event);
}

void ViewStrip::drawScenes() {
  constexpr int samples = 8;
  for (const std::string& name : rendering::bundledSceneNames()) {
    const QString id = QString::fromStdString(name);
    m_tasks.run<QImage>(
        {.title = tr("Rendering the icon of the scene %1").arg(id),
         .key = QStringLiteral("scene icon ") + id,
         .quiet = true},
        [name](const TaskControl& control) {
          const rendering::Scene scene = rendering::openScene(name, 1 + SceneMaterialSlots::count);
          const models::Model& model = models::findModel("ggx");
          const auto brdf = model.instantiate(models::defaultParameters(model.spec()));
          const rendering::RenderOptions options{
              .width = sceneIconSize.width(), .height = sceneIconSize.height(), .samples = samples, .density = {}};
          return displayedImage(rendering::renderPicture(*brdf, scene, options, control));
        },
        [this, id](const QImage& picture) {
          m_scenes->setItemIcon(m_scenes->findData(id), QIcon(QPixmap::fromImage(picture)));
        });
  }
}

void ViewStrip::setLightIcon(const QString& name, const QImage& picture) {
  const int index = m_lights->findData(name);
  if (index >= 0) m_lights->setItemIcon(index, QIcon(QPixmap::fromImage(picture)));
}

void ViewStrip::refresh() {
  const rendering::Scene& scene = m_preview.content().scene();
  const QString source = QString::fromStdString(scene.source);
  if (!source.isEmpty() && m_scenes->findData(source) < 0)
    m_scenes->insertItem(m_scenes->count() - 1, source.section('/', -1), source);
  m_scenes->setCurrentIndex(m_scenes->findData(source));
  fillLights();
  const QString current = m_environment.name();
  m_lights->setCurrentIndex(m_lights->findData(m_environment.isFromScene() ? own
                                               : current.isEmpty()         ? directional
                                                                           : current));
  m_backgrounds->setCurrentIndex(scene.environment && scene.showEnvironment
                                     ? (scene.blurBackground ? blurred : environment)
                                 : m_preview.display().checker ? checker
                                                               : plain);
  for (const Background background : {environment, blurred})
    qobject_cast<QStandardItemModel*>(m_backgrounds->model())
        ->item(background)
        ->setEnabled(scene.environment != nullptr);
  m_slider->setNumber(m_preview.display().exposure);
  m_slider->setModified(m_preview.display().exposure != 0);
  if (m_exposure->value() != m_preview.display().exposure) m_exposure->setValue(m_preview.display().exposure);
}

void ViewStrip::chooseLight(int index) {
  const QString name = m_lights->itemData(index).toString();
  refresh();
  if (name == file) return Q_EMIT environmentFileRequested();
  if (name == own) return m_environment.useSceneEnvironment();
  m_environment.open(name == directional ? QString() : name);
}

void ViewStrip::chooseBackground(int index) {
  widgets::DisplaySettings display = m_preview.display();
  display.checker = index == checker;
  m_preview.setDisplay(display);
  m_preview.content().setBackground(index == environment || index == blurred, index == blurred);
}

}  // namespace gonio::app

#include "moc_view_strip.cpp"
