// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/interpolation/blend_materials.h"

#include <algorithm>

#include "app/gonio/document/material_files.h"
#include "app/gonio/library/sphere_picture.h"
#include "widgets/interpolation/blend_position.h"

namespace gonio::app {

namespace {

constexpr int pictureSide = 160, pictureSamples = 24;
constexpr double loadFraction = 0.6, editFraction = 0.9;

QString shortName(const QString& path) { return path.section('/', -1); }

}  // namespace

BlendMaterial makeBlendMaterial(const LoadedMaterial& material, const QString& name, editing::EditDocument source,
                                const TaskControl& control) {
  BlendMaterial result;
  result.name = name;
  const std::string& description = material.material.source.description;
  result.description = QString::fromStdString(description.empty() ? material.material.name : description);
  const auto table = material.table(control);
  result.material = editing::interpolationMaterial(
      material.material, withIncident(material.base, source.incident), table,
      editing::bakeEdits(table, source.edits, control.between(0, editFraction)), source.edits);
  result.picture =
      spherePicture(*result.material.material(), pictureSide, pictureSamples, control.between(editFraction, 1));
  source.view = {};
  result.source = std::move(source);
  return result;
}

BlendMaterial readBlendMaterial(const QString& id, const TaskControl& control) {
  editing::EditDocument source;
  LoadedMaterialPtr material;
  const std::string path = id.toStdString();
  if (isDocument(id)) {
    source = editing::resolved(editing::readDocument(path), path);
    material = loadSource(source, control.between(0, loadFraction));
  } else {
    material = loadMaterial(path, control.between(0, loadFraction));
    source.sourcePath = material->material.source.path.string();
  }
  source.sourceSha256 = material->material.source.sha256;
  const QString name =
      isDocument(id) ? shortName(id).section('.', 0, -2) : QString::fromStdString(material->material.name);
  return makeBlendMaterial(*material, name, source, control.between(loadFraction, 1));
}

BlendMaterials::BlendMaterials(Document& document, BackgroundTasks& tasks, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks) {
  for (int i = 0; i < widgets::minBlended; ++i) m_slots.push_back({{}, {}, m_nextKey++});
}

QString BlendMaterials::taskKey(int key) const { return QStringLiteral("blend-material-%1").arg(key); }

const BlendMaterial* BlendMaterials::at(int slot) const {
  const auto& material = m_slots[std::size_t(slot)].material;
  return material ? &*material : nullptr;
}

bool BlendMaterials::isReading(int slot) const { return m_tasks.isRunning(taskKey(m_slots[std::size_t(slot)].key)); }

bool BlendMaterials::isReading() const {
  for (int i = 0; i < count(); ++i)
    if (isReading(i)) return true;
  return false;
}

bool BlendMaterials::isComplete() const {
  return std::all_of(m_slots.begin(), m_slots.end(), [](const Slot& slot) { return slot.material.has_value(); });
}

std::vector<editing::InterpolationMaterial> BlendMaterials::materials() const {
  std::vector<editing::InterpolationMaterial> result;
  for (const Slot& slot : m_slots) result.push_back(slot.material->material);
  return result;
}

int BlendMaterials::slotOf(int key) const {
  for (int i = 0; i < count(); ++i)
    if (m_slots[std::size_t(i)].key == key) return i;
  return -1;
}

void BlendMaterials::fill(int slot, const QString& title, const QString& name,
                          std::function<BlendMaterial(const TaskControl&)> make) {
  const int key = m_slots[std::size_t(slot)].key;
  m_slots[std::size_t(slot)].failure.clear();
  m_tasks.run<BlendMaterial>(
      {title, taskKey(key)}, std::move(make),
      [this, key](const BlendMaterial& material) {
        m_slots[std::size_t(slotOf(key))].material = material;
        Q_EMIT changed();
      },
      [this, key, name](const QString& error) {
        m_slots[std::size_t(slotOf(key))].failure = error;
        Q_EMIT stateChanged();
        Q_EMIT failed(tr("Cannot use %1").arg(name), error);
      },
      [this] { Q_EMIT stateChanged(); });
  Q_EMIT stateChanged();
}

void BlendMaterials::read(int slot, const QString& id) {
  fill(slot, tr("Opening %1 for interpolation").arg(shortName(id)), shortName(id),
       [id](const TaskControl& control) { return readBlendMaterial(id, control); });
}

void BlendMaterials::useCurrent(int slot) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  const QString name = m_document.name();
  fill(slot, tr("Preparing %1 for interpolation").arg(name), name,
       [material, name, source = m_document.toEditDocument()](const TaskControl& control) {
         return makeBlendMaterial(*material, name, source, control);
       });
}

void BlendMaterials::clear(int slot) {
  Slot& one = m_slots[std::size_t(slot)];
  m_tasks.drop(taskKey(one.key));
  one.material.reset();
  one.failure.clear();
  Q_EMIT changed();
}

void BlendMaterials::addSlot() {
  if (count() == widgets::maxBlended) return;
  m_slots.push_back({{}, {}, m_nextKey++});
  Q_EMIT changed();
}

void BlendMaterials::removeSlot(int slot) {
  if (count() == widgets::minBlended) return;
  m_tasks.drop(taskKey(m_slots[std::size_t(slot)].key));
  m_slots.erase(m_slots.begin() + slot);
  Q_EMIT changed();
}

void BlendMaterials::swap(int first, int second) {
  std::swap(m_slots[std::size_t(first)], m_slots[std::size_t(second)]);
  Q_EMIT changed();
}

}  // namespace gonio::app

#include "moc_blend_materials.cpp"
