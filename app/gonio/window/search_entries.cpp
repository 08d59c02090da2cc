// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/search_entries.h"

#include <QCoreApplication>
#include <QPointer>
#include <algorithm>

#include "app/gonio/inspector/inspector.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/window/document_files.h"
#include "app/gonio/window/editor_parts.h"
#include "app/gonio/window/guide.h"
#include "core/rendering/environment.h"
#include "core/rendering/scene_file.h"
#include "widgets/parameters/control_panel.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_row.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

struct SearchText {
  Q_DECLARE_TR_FUNCTIONS(Search)
};

void addMaterials(std::vector<SearchEntry>& entries, EditorParts& parts, DocumentFiles& files) {
  const widgets::LibraryModel& model = parts.library.model();
  for (int row = 0; row < model.rowCount(); ++row) {
    if (model.headingOf(row) != widgets::LibraryGrouping::none) continue;
    const QModelIndex index = model.index(row);
    const QString id = index.data(widgets::LibraryModel::IdRole).toString();
    const QString badge = index.data(widgets::LibraryModel::BadgeRole).toString();
    const QString name = index.data().toString();
    entries.push_back({.text = (badge.isEmpty() ? SearchText::tr("Library > %1").arg(name)
                                                : SearchText::tr("Library > %1 (%2)").arg(name, badge)),
                       .keywords = QString(name).replace('-', ' ') + ' ' +
                                   model.group(row, widgets::LibraryGrouping::kind) + ' ' +
                                   model.group(row, widgets::LibraryGrouping::source) + SearchText::tr(" material"),
                       .run = [&files, id] { files.open(id); }});
  }
}

void addRow(std::vector<SearchEntry>& entries, Inspector& inspector, const QString& group,
            const models::ParameterSpec& spec, QWidget* row) {
  if (!row) return;
  const QPointer<QWidget> found = row;
  entries.push_back({.text = QStringLiteral("%1 > %2").arg(group, widgets::toQString(spec.label)),
                     .keywords = widgets::toQString(spec.id) + ' ' + widgets::toQString(spec.description) + ' ' +
                                 SearchText::tr("slider parameter"),
                     .run =
                         [&inspector, found] {
                           if (found) inspector.reveal(*found);
                         },
                     .enabled = row->isEnabled()});
}

void addSliders(std::vector<SearchEntry>& entries, EditorParts& parts) {
  const auto* edit = parts.document.active<editing::DifferentialEdit>();
  if (!edit) return;
  const auto& controls = editing::artistControls().parameters;
  for (std::size_t i = 0; i < controls.size(); ++i)
    addRow(entries, parts.inspector, SearchText::tr("Controls"), controls[i],
           parts.inspector.controls()->row(editing::ArtistControl(i)));
  const models::ModelSpec& spec = edit->model->spec();
  for (std::size_t i = 0; i < std::min(spec.parameters.size(), parts.inspector.parameters()->rowCount()); ++i)
    addRow(entries, parts.inspector, widgets::toQString(spec.name), spec.parameters[i],
           parts.inspector.parameters()->row(i));
}

void addModels(std::vector<SearchEntry>& entries, EditorParts& parts) {
  const bool open = parts.document.material() != nullptr;
  for (const models::Model* model : models::allModels())
    entries.push_back({.text = SearchText::tr("Model > %1").arg(widgets::toQString(model->spec().name)),
                       .keywords = widgets::toQString(model->spec().id) + ' ' + SearchText::tr("choose fit"),
                       .run = [&parts, model] { parts.controller.chooseModel(*model); },
                       .enabled = open});
}

void addScenes(std::vector<SearchEntry>& entries, EditorParts& parts) {
  for (const std::string& name : bundledSceneNames())
    entries.push_back({.text = SearchText::tr("Scene > %1").arg(sceneTitle(name)),
                       .keywords = SearchText::tr("shape mesh object show on"),
                       .run = [&parts, name] { parts.scene.open(QString::fromStdString(name)); }});
  QStringList lights;
  for (const std::string& name : bundledEnvironmentNames()) lights << QString::fromStdString(name);
  for (const QString& light : lights + parts.environment.recent())
    entries.push_back({.text = SearchText::tr("Light > %1")
                                   .arg(light.contains('/') ? light.section('/', -1) : sceneTitle(light.toStdString())),
                       .keywords = SearchText::tr("environment hdri hdr lighting illumination"),
                       .run = [&parts, light] { parts.environment.open(light); }});
}

void addGuide(std::vector<SearchEntry>& entries, QWidget& window) {
  QString page;
  for (const GuidePage& one : guidePages()) {
    if (one.level == 1) page = one.title;
    entries.push_back(
        {.text = one.level == 1 ? SearchText::tr("Guide > %1").arg(page)
                                : SearchText::tr("Guide > %1 > %2").arg(page, one.title),
         .keywords = SearchText::tr("help documentation manual"),
         .run = [&window, one] { openGuide(&window, one.file, one.level == 1 ? QString() : one.title); }});
  }
}

}  // namespace

std::vector<SearchEntry> searchEntries(EditorParts& parts, DocumentFiles& files, QWidget& window) {
  std::vector<SearchEntry> entries;
  addSliders(entries, parts);
  addModels(entries, parts);
  addScenes(entries, parts);
  addMaterials(entries, parts, files);
  addGuide(entries, window);
  return entries;
}

}  // namespace gonio::app
