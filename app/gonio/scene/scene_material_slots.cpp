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
QString taskKey(int slot) { return QStringLiteral("scene-material-%1").arg(slot); }
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

void SceneMaterialSlots::showScene(const Scene& scene) {
  const int shown = std::min(count, materialSlotCount(scene) - 1);
  for (int slot = 0; slot < count; ++slot) m_slots[std::size_t(slot)].widget->setVisible(slot < shown);
  setVisible(shown > 0);
}

std::vector<widgets::SceneMaterial> SceneMaterialSlots::materials() const {
  std::vector<widgets::SceneMaterial> materials;
  for (const Slot& slot : m_slots) materials.push_back(slot.other ? slot.other->shown : widgets::SceneMaterial{});
  return materials;
}

/// In its native form, with what sampling needs.
SceneMaterialSlots::OtherMaterial SceneMaterialSlots::prepared(BlendMaterial end) {
  const std::shared_ptr<const Brdf> brdf = end.material.material();
  const auto lobe = std::make_shared<const TabulatedDensity>(*brdf);
  widgets::PreviewSubject subject = widgets::measuredSubject(end.material.table, lobe);
  if (end.material.base) subject.shown = widgets::EditedMaterial{end.material.base, end.material.edits};
  return {std::move(end), {subject, std::make_shared<const RenderMaterial>(brdf, lobe)}};
}

void SceneMaterialSlots::fill(int slot, const QString& name, std::function<BlendMaterial(const TaskControl&)> make) {
  m_slots[std::size_t(slot)].failure.clear();
  m_tasks.run<OtherMaterial>(
      {tr("Opening %1 for the scene").arg(name), taskKey(slot)},
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
  fill(slot, id.section('/', -1), [id](const TaskControl& control) { return readBlendMaterial(id, control); });
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
  m_tasks.drop(taskKey(slot));
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
  if (m_tasks.isRunning(taskKey(slot))) content.note = tr("Opening...");
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
