// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/scene/scene_material_slots.h"

#include <QFileDialog>
#include <QHBoxLayout>

#include "app/gonio/document/material_files.h"
#include "widgets/inputs/dialog_folder.h"
#include "widgets/interpolation/material_slot_widget.h"

namespace gonio::app {

namespace {
QString taskKey(int place) { return QStringLiteral("scene-material-%1").arg(place); }
/// The edited material is A.
QChar letterOf(int place) { return QChar(u'B' + place); }
}  // namespace

SceneMaterialSlots::SceneMaterialSlots(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent), m_document(document), m_tasks(tasks) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  for (int place = 0; place < count; ++place) {
    auto* widget = new widgets::MaterialSlotWidget(letterOf(place));
    layout->addWidget(widget, 1);
    m_places.push_back({widget, {}, {}});
    connect(widget, &widgets::MaterialSlotWidget::materialDropped, this,
            [this, place](const QString& id) { read(place, id); });
    connect(widget, &widgets::MaterialSlotWidget::currentRequested, this, [this, place] { takeCurrent(place); });
    connect(widget, &widgets::MaterialSlotWidget::fileRequested, this, [this, place] { askForFile(place); });
    connect(widget, &widgets::MaterialSlotWidget::clearRequested, this, [this, place] { clear(place); });
    show(place);
  }
  connect(&document, &Document::materialChanged, this, [this] {
    for (int place = 0; place < count; ++place) show(place);
  });
}

void SceneMaterialSlots::showScene(const Scene& scene) {
  const int shown = std::min(count, materialSlotCount(scene) - 1);
  for (int place = 0; place < count; ++place) m_places[std::size_t(place)].widget->setVisible(place < shown);
  setVisible(shown > 0);
}

std::vector<widgets::SceneMaterial> SceneMaterialSlots::materials() const {
  std::vector<widgets::SceneMaterial> materials;
  for (const Place& place : m_places) materials.push_back(place.other ? place.other->shown : widgets::SceneMaterial{});
  return materials;
}

/// In its native form, with what sampling needs.
SceneMaterialSlots::OtherMaterial SceneMaterialSlots::prepared(BlendMaterial end) {
  const std::shared_ptr<const Brdf> brdf = end.material.material();
  const auto lobe = std::make_shared<const TabulatedLobe>(*brdf);
  widgets::PreviewSubject subject = widgets::measuredSubject(end.material.table, lobe);
  if (end.material.base) subject.shown = widgets::EditedMaterial{end.material.base, end.material.edits};
  return {std::move(end), {subject, std::make_shared<const RenderMaterial>(brdf, lobe)}};
}

void SceneMaterialSlots::fill(int place, const QString& name, std::function<BlendMaterial(const TaskControl&)> make) {
  m_places[std::size_t(place)].failure.clear();
  m_tasks.run<OtherMaterial>(
      {tr("Opening %1 for the scene").arg(name), taskKey(place)},
      [make = std::move(make)](const TaskControl& control) { return prepared(make(control)); },
      [this, place](const OtherMaterial& other) {
        m_places[std::size_t(place)].other = other;
        show(place);
        Q_EMIT changed();
      },
      [this, place, name](const QString& error) {
        m_places[std::size_t(place)].failure = error;
        show(place);
        Q_EMIT failed(tr("Cannot use %1").arg(name), error);
      },
      [this, place] { show(place); });
  show(place);
}

void SceneMaterialSlots::read(int place, const QString& id) {
  fill(place, id.section('/', -1), [id](const TaskControl& control) { return readBlendEnd(id, control); });
}

void SceneMaterialSlots::takeCurrent(int place) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  const QString name = m_document.name();
  fill(place, name, [material, name, source = m_document.toEditDocument()](const TaskControl& control) {
    return takeBlendEnd(*material, name, source, control);
  });
}

void SceneMaterialSlots::clear(int place) {
  Place& one = m_places[std::size_t(place)];
  m_tasks.drop(taskKey(place));
  one.other.reset();
  one.failure.clear();
  show(place);
  Q_EMIT changed();
}

void SceneMaterialSlots::askForFile(int place) {
  auto* dialog = new QFileDialog(this, tr("Material %1").arg(letterOf(place)),
                                 widgets::dialogFolder(QStringLiteral("open")), materialFilter());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this, place](const QString& path) {
    widgets::rememberDialogFolder(QStringLiteral("open"), path);
    read(place, path);
  });
  dialog->open();
}

void SceneMaterialSlots::show(int place) {
  const Place& one = m_places[std::size_t(place)];
  widgets::SlotContent content;
  if (one.other) content = {one.other->end.name, one.other->end.description, one.other->end.picture, {}};
  if (m_tasks.isRunning(taskKey(place))) content.note = tr("Opening...");
  if (!one.failure.isEmpty()) {
    content.note = tr("Could not be opened");
    content.toolTip = one.failure;
    content.failed = true;
  }
  one.widget->setContent(content);
  one.widget->setCurrentAvailable(m_document.material() != nullptr);
}

}  // namespace gonio::app

#include "moc_scene_material_slots.cpp"
