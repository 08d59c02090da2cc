// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/scene/scene_panel.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <map>

#include "app/gonio/document/material_files.h"
#include "core/io/mesh_file.h"
#include "core/metrics/image_metrics.h"
#include "core/rendering/plan_check.h"
#include "core/rendering/sampling_method.h"
#include "core/rendering/scene_file.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/interpolation/material_slot_widget.h"
#include "widgets/panels/effect_list.h"
#include "widgets/parameters/parameter_text.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {
QString slotTaskKey(int slot) { return QStringLiteral("scene-material-%1").arg(slot); }
/// The edited material is A.
QChar letterOf(int slot) { return QChar(u'B' + slot); }
}  // namespace

SceneMaterialSlots::SceneMaterialSlots(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent), m_document(document), m_tasks(tasks) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  for (int slot = 0; slot < count; ++slot) {
    auto* widget = new widgets::MaterialSlotWidget(letterOf(slot));
    layout->addWidget(widget, 1);
    m_slots.push_back({widget, {}, {}});
    connect(widget, &widgets::MaterialSlotWidget::materialDropped, this,
            [this, slot](const QString& id) { read(slot, id); });
    connect(widget, &widgets::MaterialSlotWidget::currentRequested, this, [this, slot] { useCurrent(slot); });
    connect(widget, &widgets::MaterialSlotWidget::fileRequested, this, [this, slot] { askForFile(slot); });
    connect(widget, &widgets::MaterialSlotWidget::clearRequested, this, [this, slot] { clear(slot); });
    show(slot);
  }
  connect(&document, &Document::materialChanged, this, [this] {
    for (int slot = 0; slot < count; ++slot) show(slot);
  });
}

void SceneMaterialSlots::showScene(const rendering::Scene& scene) {
  const int shown = std::min(count, rendering::materialSlotCount(scene) - 1);
  for (int slot = 0; slot < count; ++slot) m_slots[std::size_t(slot)].widget->setVisible(slot < shown);
  setVisible(shown > 0);
}

std::vector<widgets::SlotMaterial> SceneMaterialSlots::materials() const {
  std::vector<widgets::SlotMaterial> materials;
  for (const Slot& slot : m_slots) materials.push_back(slot.other ? slot.other->shown : widgets::SlotMaterial{});
  return materials;
}

/// In its native form, with what sampling needs.
SceneMaterialSlots::OtherMaterial SceneMaterialSlots::prepared(BlendMaterial end) {
  const std::shared_ptr<const Brdf> brdf = end.material.material();
  const auto density = std::make_shared<const TabulatedDensity>(*brdf);
  widgets::PreviewSubject subject = widgets::measuredSubject(end.material.table, density);
  if (end.material.base) subject.shown = widgets::EditedMaterial{end.material.base, end.material.edits};
  const auto material = std::make_shared<const rendering::RenderMaterial>(brdf, density);
  material->bound();  // the effect plan asks for it in the GUI thread
  return {std::move(end), {subject, material}};
}

void SceneMaterialSlots::fill(int slot, const QString& name, std::function<BlendMaterial(const TaskControl&)> make) {
  m_slots[std::size_t(slot)].failure.clear();
  m_tasks.run<OtherMaterial>(
      {tr("Opening %1 for the scene").arg(widgets::spacedName(name)), slotTaskKey(slot)},
      [make = std::move(make)](const TaskControl& control) { return prepared(make(control)); },
      [this, slot](const OtherMaterial& other) {
        m_slots[std::size_t(slot)].other = other;
        show(slot);
        Q_EMIT changed();
      },
      [this, slot, name](const QString& error) {
        m_slots[std::size_t(slot)].failure = error;
        show(slot);
        Q_EMIT failed(tr("Cannot use %1").arg(name), error);
      },
      [this, slot] { show(slot); });
  show(slot);
}

void SceneMaterialSlots::read(int slot, const QString& id) {
  fill(slot, shortName(id), [id](const TaskControl& control) { return readBlendMaterial(id, control); });
}

void SceneMaterialSlots::useCurrent(int slot) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  const QString name = m_document.name();
  fill(slot, name, [material, name, source = m_document.toEditDocument()](const TaskControl& control) {
    return makeBlendMaterial(*material, name, source, control);
  });
}

void SceneMaterialSlots::clear(int slot) {
  Slot& one = m_slots[std::size_t(slot)];
  m_tasks.drop(slotTaskKey(slot));
  one.other.reset();
  one.failure.clear();
  show(slot);
  Q_EMIT changed();
}

void SceneMaterialSlots::askForFile(int slot) {
  auto* dialog = new QFileDialog(this, tr("Material %1").arg(letterOf(slot)),
                                 widgets::dialogFolder(QStringLiteral("open")), materialFilter());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this, slot](const QString& path) {
    widgets::rememberDialogFolder(QStringLiteral("open"), path);
    read(slot, path);
  });
  dialog->open();
}

void SceneMaterialSlots::show(int slot) {
  const Slot& one = m_slots[std::size_t(slot)];
  widgets::SlotContent content;
  if (one.other) content = {one.other->end.name, one.other->end.description, one.other->end.picture, {}};
  if (m_tasks.isRunning(slotTaskKey(slot))) content.note = tr("Opening...");
  if (!one.failure.isEmpty()) {
    content.note = tr("Could not be opened");
    content.toolTip = one.failure;
    content.failed = true;
  }
  one.widget->setContent(content);
  one.widget->setCurrentAvailable(m_document.material() != nullptr);
}

namespace {

constexpr int costSide = 128, costSamples = 16;
constexpr int referenceSamples = 1024;
const auto costsKey = QStringLiteral("effect costs"), renderReferenceKey = QStringLiteral("scene reference"),
           planCheckKey = QStringLiteral("plan check");
constexpr int planCheckDelayMilliseconds = 600;
/// As many as the GPU simulates.
constexpr int shownReflections = 8;
/// The entries of the list of scenes have the up axis and the turns with which they were last shown.
constexpr int upRole = Qt::UserRole + 1, turnsRole = Qt::UserRole + 2;

/// The materials with the sampling densities of a method; each is prepared once, though several objects may have it.
rendering::RenderMaterials sampledMaterials(const rendering::RenderMaterials& materials, const std::string& method,
                                            const TaskControl& control) {
  if (method == rendering::samplingMethods().front().id) return materials;
  std::map<const rendering::RenderMaterial*, std::shared_ptr<const rendering::RenderMaterial>> prepared;
  rendering::RenderMaterials result;
  for (const auto& material : materials) {
    auto& sampled = prepared[material.get()];
    if (material && !sampled)
      sampled = rendering::sampledBy(method, std::shared_ptr<const Brdf>(material, &material->brdf()), control);
    result.push_back(sampled);
  }
  return result;
}

/// What the objects of the preview's scene are made of.
rendering::RenderMaterials materialsOf(const widgets::PreviewContent& preview) {
  return rendering::bindMaterials(
      preview.scene(),
      rendering::materialsInSlots(preview.scene(), preview.first().material(), preview.otherSlotMaterials()));
}

}  // namespace

QString sceneTitle(const std::string& name) {
  QString title = QString::fromStdString(name);
  // The shape first, then the light that the scene itself has: "sphere-point-light", "sphere-under-lamp".
  for (const char* light : {"-distant-light", "-point-light", "-under-lamp"})
    if (title.endsWith(QLatin1String(light)))
      title.replace(title.size() - qsizetype(qstrlen(light)), 1, QStringLiteral(", "));
  return title.replace('-', ' ').replace(0, 1, title.at(0).toUpper());
}

ScenePanel::ScenePanel(widgets::PreviewWidget& preview, Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_preview(preview),
      m_document(document),
      m_tasks(tasks),
      m_scenes(new QComboBox),
      m_up(new QComboBox),
      m_sampling(new QComboBox),
      m_description(new QLabel),
      m_result(new QLabel),
      m_turn(new QPushButton(tr("&Turn"))),
      m_measure(new QPushButton(tr("Meas&ure Effects"))),
      m_compare(new QPushButton(tr("&Compare with Reference"))),
      m_reflections(new QSpinBox),
      m_otherSlots(new SceneMaterialSlots(document, tasks)),
      m_effects(new widgets::EffectList) {
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(buildTop());
  layout->addWidget(m_otherSlots);
  layout->addWidget(m_effects);
  layout->addWidget(buildBottom());
  layout->addStretch(1);
  connect(m_otherSlots, &SceneMaterialSlots::changed, this, [this] {
    m_costs.reset();
    m_preview.content().setOtherSlotMaterials(m_otherSlots->materials());
    refresh();
  });
  connect(m_otherSlots, &SceneMaterialSlots::failed, this, &ScenePanel::failed);
  connect(m_effects, &widgets::EffectList::overridesChanged, &m_preview.content(),
          &widgets::PreviewContent::setOverrides);
  connect(&m_preview.content(), &widgets::PreviewContent::planChanged, this, &ScenePanel::refresh);
  m_checkDelay.setSingleShot(true);
  m_checkDelay.setInterval(planCheckDelayMilliseconds);
  connect(&m_checkDelay, &QTimer::timeout, this, &ScenePanel::checkPlan);
  connect(&m_preview.content(), &widgets::PreviewContent::planChanged, this, &ScenePanel::planMayChange);
  connect(&m_preview.content(), &widgets::PreviewContent::sceneChanged, this, &ScenePanel::planMayChange);
  connect(&m_preview.content(), &widgets::PreviewContent::sceneChanged, this, [this](const rendering::Scene& scene) {
    m_result->clear();
    showScene(scene);
  });
  refresh();
}

QString ScenePanel::result() const { return m_result->text(); }

QWidget* ScenePanel::buildTop() {
  auto* top = new QWidget;
  auto* layout = new QHBoxLayout(top);
  layout->setContentsMargins(0, 0, 0, 0);
  for (const std::string& name : rendering::bundledSceneNames())
    m_scenes->addItem(sceneTitle(name), QString::fromStdString(name));
  m_scenes->setAccessibleName(tr("Scene"));
  m_scenes->setToolTip(tr("Scene that the preview shows"));
  auto* label = new QLabel(tr("&Scene"));
  label->setBuddy(m_scenes);
  auto* openFile = new QPushButton(tr("&Open..."));
  openFile->setToolTip(
      tr("Opens a scene file (.json) or a mesh (%1)").arg(QString::fromStdString(io::meshSuffixList())));
  m_description->setForegroundRole(QPalette::PlaceholderText);
  m_description->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  for (const auto& [up, text] : {std::pair(rendering::UpAxis::y, tr("Y up")), {rendering::UpAxis::z, tr("Z up")}})
    m_up->addItem(text, int(up));
  m_up->setAccessibleName(tr("Up axis"));
  m_up->setToolTip(tr("Axis of the mesh that points up. Choose Z up if the mesh lies on its back"));
  m_turn->setAccessibleName(tr("Turn mesh"));
  m_turn->setToolTip(
      tr("Turns the mesh by 90 degrees about the axis that points up. Use it if the mesh shows its side or its back"));
  for (QWidget* part : std::initializer_list<QWidget*>{label, m_scenes, openFile, m_up, m_turn})
    layout->addWidget(part);
  layout->addWidget(m_description, 1);
  connect(m_up, &QComboBox::activated, this,
          [this] { open(m_scenes->currentData().toString(), rendering::UpAxis(m_up->currentData().toInt())); });
  connect(m_turn, &QPushButton::clicked, this, &ScenePanel::turnMesh);
  connect(m_scenes, &QComboBox::activated, this, [this] { open(m_scenes->currentData().toString()); });
  connect(openFile, &QPushButton::clicked, this, &ScenePanel::askForFile);
  return top;
}

QWidget* ScenePanel::buildBottom() {
  auto* bottom = new QWidget;
  auto* layout = new QHBoxLayout(bottom);
  layout->setContentsMargins(0, 0, 0, 0);
  m_measure->setToolTip(
      tr("Measures the time and the contribution of each effect: renders the scene with and without it, "
         "%1 × %1 pixels on the CPU")
          .arg(costSide));
  m_compare->setToolTip(
      tr("Measures the signal-to-noise ratio of the preview against the reference renderer with %1 samples per pixel")
          .arg(referenceSamples));
  m_result->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_reflections->setRange(0, shownReflections);
  m_reflections->setSpecialValueText(tr("All"));
  m_reflections->setToolTip(
      tr("Number of reflections that the preview shows. 1: direct light alone; the difference from 2 is the light that "
         "was reflected twice. All: as many as the plan simulates"));
  auto* label = new QLabel(tr("&Reflections"));
  label->setBuddy(m_reflections);
  layout->addWidget(label);
  layout->addWidget(m_reflections);
  for (const rendering::SamplingMethod& method : rendering::samplingMethods()) {
    m_sampling->addItem(widgets::toQString(method.name), widgets::toQString(method.id));
    m_sampling->setItemData(m_sampling->count() - 1, widgets::toQString(method.text), Qt::ToolTipRole);
  }
  m_sampling->setToolTip(
      tr("Importance sampling of the materials in the two measurements: from which density the reference renderer "
         "samples directions. The preview does not depend on it"));
  auto* samplingLabel = new QLabel(tr("Sa&mpling"));
  samplingLabel->setBuddy(m_sampling);
  layout->addWidget(samplingLabel);
  layout->addWidget(m_sampling);
  layout->addWidget(m_measure);
  layout->addWidget(m_compare);
  layout->addWidget(m_result, 1);
  connect(m_reflections, &QSpinBox::valueChanged, &m_preview.content(), &widgets::PreviewContent::setReflectionLimit);
  connect(m_measure, &QPushButton::clicked, this, &ScenePanel::measureCosts);
  connect(m_compare, &QPushButton::clicked, this, &ScenePanel::compareWithReference);
  return bottom;
}

void ScenePanel::askForFile() {
  const QString purpose = QStringLiteral("scene");
  const QString beside = m_document.folder();
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Open Scene"), beside.isEmpty() ? widgets::dialogFolder(purpose) : beside,
      tr("Scenes and meshes (*.json %1);;All files (*)").arg(QString::fromStdString(io::meshSuffixList("*"))));
  widgets::rememberDialogFolder(purpose, path);
  if (!path.isEmpty()) open(path);
}

void ScenePanel::open(const QString& nameOrPath, std::optional<rendering::MeshPose> pose,
                      const std::function<void()>& shown) {
  const int known = m_scenes->findData(nameOrPath);
  if (!pose && known >= 0)
    pose = {rendering::UpAxis(m_scenes->itemData(known, upRole).toInt()), m_scenes->itemData(known, turnsRole).toInt()};
  m_tasks.run<rendering::Scene>(
      {tr("Reading the scene %1").arg(nameOrPath.section('/', -1)), QStringLiteral("scene")},
      [nameOrPath, pose](const TaskControl&) {
        return rendering::openScene(nameOrPath.toStdString(), 1 + SceneMaterialSlots::count,
                                    pose.value_or(rendering::MeshPose()));
      },
      [this, shown](const rendering::Scene& scene) {
        show(scene);
        if (shown) shown();
        for (const std::string& note : scene.notes) Q_EMIT warned(QString::fromStdString(note));
      },
      [this](const QString& error) {
        refresh();
        Q_EMIT failed(tr("Cannot read the scene"), error);
      });
}

bool ScenePanel::showsMesh() const { return io::isMeshFile(m_preview.content().scene().source); }

void ScenePanel::turnMesh() {
  rendering::MeshPose pose = m_preview.content().scene().pose;
  pose.quarterTurns = (pose.quarterTurns + 1) % 4;
  open(m_scenes->currentData().toString(), pose);
}

void ScenePanel::show(const rendering::Scene& scene) {
  m_costs.reset();
  m_preview.content().showScene(scene);
  refresh();
}

void ScenePanel::showScene(const rendering::Scene& scene) {
  const QString source = QString::fromStdString(scene.source);
  if (!source.isEmpty() && m_scenes->findData(source) < 0) m_scenes->addItem(source.section('/', -1), source);
  m_scenes->setCurrentIndex(m_scenes->findData(source));
  m_scenes->setItemData(m_scenes->currentIndex(), int(scene.pose.up), upRole);
  m_scenes->setItemData(m_scenes->currentIndex(), scene.pose.quarterTurns, turnsRole);
  m_up->setCurrentIndex(m_up->findData(int(scene.pose.up)));
  for (QWidget* part : std::initializer_list<QWidget*>{m_up, m_turn}) part->setVisible(showsMesh());
  m_description->setText(QString::fromStdString(scene.description));
  m_description->setToolTip(m_description->text());
  m_otherSlots->showScene(scene);
}

void ScenePanel::refresh() {
  showScene(m_preview.content().scene());
  m_effects->setOverrides(m_preview.content().overrides());
  m_effects->setPlan(m_preview.content().plan());
  m_effects->setCosts(m_costs);
  const bool known = m_preview.content().first().material() != nullptr;
  m_measure->setEnabled(known);
  m_compare->setEnabled(known);
}

void ScenePanel::measureCosts() {
  const rendering::Scene scene = m_preview.content().scene();
  const rendering::EffectOverrides overrides = m_preview.content().overrides();
  m_tasks.run<rendering::EffectCosts>(
      {tr("Measuring the effects of %1").arg(QString::fromStdString(scene.name)), costsKey},
      [scene, overrides, materials = materialsOf(m_preview.content()),
       method = m_sampling->currentData().toString().toStdString()](const TaskControl& control) {
        return rendering::measureEffectCosts(scene, sampledMaterials(materials, method, control), overrides,
                                             {.width = costSide, .height = costSide, .samples = costSamples}, control);
      },
      [this](const rendering::EffectCosts& costs) {
        m_costs = costs;
        m_effects->setCosts(m_costs);
        m_result->setText(tr("Whole image: %1 ms on the CPU (%2 × %2 pixels, %3 samples per pixel)")
                              .arg(1000 * costs.seconds, 0, 'f', 0)
                              .arg(costSide)
                              .arg(costSamples));
      },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot measure the effects"), error); });
}

void ScenePanel::planMayChange() {
  m_tasks.drop(planCheckKey);
  m_checkDelay.start();
}

/// At rest, renders a small picture with all effects and extends the plan where something that shows is missing.
void ScenePanel::checkPlan() {
  if (!m_preview.content().first().material()) return;
  m_tasks.run<rendering::EffectPlan>(
      {tr("Checking the effect plan"), planCheckKey, false, true},
      [scene = m_preview.content().scene(), overrides = m_preview.content().overrides(),
       thresholds = m_preview.content().thresholds(),
       materials = materialsOf(m_preview.content())](const TaskControl& control) {
        return rendering::checkedPlan(scene, materials, overrides, thresholds, control);
      },
      [this](const rendering::EffectPlan& plan) { m_preview.content().setCheckedPlan(plan); });
}

void ScenePanel::compareWithReference() {
  const Image picture = m_preview.linearPicture();
  const rendering::Scene scene = m_preview.content().scene();
  const rendering::EffectOverrides overrides = m_preview.content().overrides();
  const rendering::EffectThresholds thresholds = m_preview.content().thresholds();
  m_result->setText(tr("Rendering the reference..."));
  m_tasks.run<double>(
      {tr("Rendering the reference of %1").arg(QString::fromStdString(scene.name)), renderReferenceKey},
      [scene, overrides, thresholds, picture, given = materialsOf(m_preview.content()),
       method = m_sampling->currentData().toString().toStdString()](const TaskControl& control) {
        const rendering::RenderMaterials materials = sampledMaterials(given, method, control);
        rendering::Film film(picture.width, picture.height);
        rendering::PathTracer(scene, materials, rendering::checkedPlan(scene, materials, overrides, thresholds), 2)
            .accumulate(film, referenceSamples, control);
        return metrics::signalToNoiseRatio(film.image(), picture);
      },
      [this, sampling = m_sampling->currentIndex() == 0 ? QString() : m_sampling->currentText()](double snr) {
        const QString text = tr("Preview: SNR %1 dB against the reference with %2 samples per pixel")
                                 .arg(snr, 0, 'f', 1)
                                 .arg(referenceSamples);
        m_result->setText(sampling.isEmpty() ? text : tr("%1 (sampling: %2)").arg(text, sampling));
      },
      [this](const QString& error) {
        m_result->clear();
        Q_EMIT failed(tr("Cannot render the reference"), error);
      },
      [this] { m_result->setText(tr("Stopped")); });
}

}  // namespace gonio::app

#include "moc_scene_panel.cpp"
