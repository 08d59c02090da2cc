// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/document_files.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "app/gonio/document/document_controller.h"
#include "app/gonio/document/file_exports.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/export/export_dialog.h"
#include "app/gonio/export/image_dialog.h"
#include "app/gonio/library/library_controller.h"
#include "app/gonio/scene/environment_controller.h"
#include "app/gonio/scene/scene_panel.h"
#include "core/editing/edit_list.h"
#include "core/export/export_target.h"
#include "core/io/atomic_file.h"
#include "core/io/mesh_file.h"
#include "core/materials/encode.h"
#include "core/materials/material.h"
#include "core/rendering/scene_file.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/parameters/parameter_text.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {

/// A number of a view, with its range in files.
struct ViewNumber {
  const char* key;
  double& (*in)(rendering::Scene& scene);
  double min, max;
};
constexpr double farthest = 1000;
constexpr ViewNumber viewNumbers[]{
    {"yaw", [](rendering::Scene& scene) -> double& { return scene.camera.yaw; }, -100, 100},
    {"pitch", [](rendering::Scene& scene) -> double& { return scene.camera.pitch; }, -1.5, 1.5},
    {"distance", [](rendering::Scene& scene) -> double& { return scene.camera.distance; }, 1.05, farthest},
    {"fieldOfView", [](rendering::Scene& scene) -> double& { return scene.camera.fieldOfView; }, 0, 2.5},
    {"targetX", [](rendering::Scene& scene) -> double& { return scene.camera.target.x; }, -farthest, farthest},
    {"targetY", [](rendering::Scene& scene) -> double& { return scene.camera.target.y; }, -farthest, farthest},
    {"targetZ", [](rendering::Scene& scene) -> double& { return scene.camera.target.z; }, -farthest, farthest},
    {"environmentRotation", [](rendering::Scene& scene) -> double& { return scene.environmentRotation; }, -100, 100}};

/// The finite number under a key, in a range, else `fallback`.
double number(const nlohmann::json& json, const char* key, double fallback, double min, double max) {
  if (!json.is_object() || !json.contains(key) || !json[key].is_number()) return fallback;
  const double value = json[key].get<double>();
  return std::isfinite(value) ? std::clamp(value, min, max) : fallback;
}

Direction lightOf(const rendering::Scene& scene) {
  return scene.directionalLights.empty() ? rendering::DirectionalLight{}.toLight
                                         : scene.directionalLights.front().toLight;
}

/// Restores everything except the scene and the environment, which must be read first. Missing keys and keys of the
/// wrong type are ignored.
void restoreCamera(widgets::PreviewWidget& preview, const nlohmann::json& view) {
  rendering::Scene scene = preview.content().scene();
  for (const ViewNumber& one : viewNumbers) one.in(scene) = number(view, one.key, one.in(scene), one.min, one.max);
  const Direction before = lightOf(scene);
  const Direction toLight(number(view, "lightX", before.x, -1, 1), number(view, "lightY", before.y, -1, 1),
                          number(view, "lightZ", before.z, -1, 1));
  if (glm::length(toLight) > 1e-3 && !scene.directionalLights.empty())
    scene.directionalLights.front().toLight = glm::normalize(toLight);
  preview.content().setScene(scene);
  if (view.is_object() && view.contains("showEnvironment") && view["showEnvironment"].is_boolean())
    preview.content().setBackground(view["showEnvironment"].get<bool>(),
                                    view.contains("blurBackground") && view["blurBackground"] == true);
  widgets::DisplaySettings display = preview.display();
  display.exposure = number(view, "exposure", display.exposure, -20, 20);
  if (view.is_object() && view.contains("toneMap"))
    for (const rendering::ToneMap toneMap : {rendering::ToneMap::clamp, rendering::ToneMap::filmic})
      if (view["toneMap"] == std::string(rendering::toneMapName(toneMap))) display.toneMap = toneMap;
  preview.setDisplay(display);
}

/// The environment of a view: a bundled name, a path, or empty for the distant light; nullopt if the view does not
/// contain it.
std::optional<QString> environmentOf(const nlohmann::json& view) {
  if (!view.is_object() || !view.contains("environment") || !view["environment"].is_string()) return std::nullopt;
  return QString::fromStdString(view["environment"].get<std::string>());
}

const QString openPurpose = QStringLiteral("open"), exportPurpose = QStringLiteral("export");

/// With the suffix when the user left it out.
QString withSuffix(const QString& path, const QString& suffix) {
  return path.isEmpty() || path.endsWith(suffix, Qt::CaseInsensitive) ? path : path + suffix;
}

/// "gold-paint_rougher" for a document without a file of its own.
QString proposedName(const Document& document) {
  return QString::fromStdString(exports::proposedName(document.name().toStdString(), document.describedEdits()));
}

/// Beside the document; for a bundled material without one, where the last export went.
QString exportFolder(const Document& document) {
  return document.folder().isEmpty() ? widgets::dialogFolder(exportPurpose) : document.folder();
}

constexpr auto saveButtons = QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel;

/// The document's path, or the material of a document that was never saved.
QString nameOfWork(const RecoverableWork& work) {
  if (!work.originalPath.isEmpty()) return work.originalPath;
  try {
    const documents::EditDocument stored = documents::readDocument(work.autosavePath.toStdString());
    if (!stored.blend) return materialName(QString::fromStdString(stored.sourcePath));
  } catch (const Error&) {
    // Opening the copy will say what is wrong with it.
  }
  return DocumentFiles::tr("an untitled document");
}

}  // namespace

nlohmann::json viewToJson(const widgets::PreviewWidget& preview) {
  rendering::Scene scene = preview.content().scene();
  const Direction toLight = lightOf(scene);
  nlohmann::json view{{"scene", scene.source},
                      {"sceneUp", std::string(rendering::upAxisName(scene.pose.up))},
                      {"sceneTurns", scene.pose.quarterTurns},
                      {"lightX", toLight.x},
                      {"lightY", toLight.y},
                      {"lightZ", toLight.z},
                      {"environment", scene.environment ? scene.environment->name() : std::string()},
                      {"showEnvironment", scene.showEnvironment},
                      {"blurBackground", scene.blurBackground},
                      {"exposure", preview.display().exposure},
                      {"toneMap", std::string(rendering::toneMapName(preview.display().toneMap))}};
  for (const ViewNumber& one : viewNumbers) view[one.key] = one.in(scene);
  return view;
}

QString sceneNameOf(const nlohmann::json& view) {
  const bool hasScene = view.is_object() && view.contains("scene") && view["scene"].is_string();
  const std::string scene = hasScene ? view["scene"].get<std::string>() : "";
  return QString::fromStdString(scene.empty() ? rendering::bundledSceneNames().front() : scene);
}

rendering::MeshPose scenePoseOf(const nlohmann::json& view) {
  if (!view.is_object() || !io::isMeshFile(sceneNameOf(view).toStdString())) return {};
  const bool isZ = view.contains("sceneUp") && view["sceneUp"] == "z";
  const bool turns = view.contains("sceneTurns") && view["sceneTurns"].is_number_integer();
  return {isZ ? rendering::UpAxis::z : rendering::UpAxis::y, turns ? view["sceneTurns"].get<int>() & 3 : 0};
}

DocumentFiles::DocumentFiles(const Parts& parts, QWidget* window)
    : m_parts(parts),
      m_window(window),
      m_autosave(Autosave::defaultDataFolder(), [this]() -> std::optional<documents::EditDocument> {
        if (!m_parts.document.isModified()) return std::nullopt;
        documents::EditDocument stored = m_parts.document.toEditDocument();
        stored.view = viewToJson(m_parts.preview);
        return stored;
      }) {
  connect(&m_parts.document, &Document::materialReplaced, this, &DocumentFiles::updateAutosave);
  connect(&m_parts.exports, &FileExports::lossesFound, this,
          [this](const QString& path, const QString& text, const std::function<void()>& write) {
            const QString name = QFileInfo(path).fileName();
            if (widgets::ask(m_window, tr("Export BRDF"),
                             tr("%1 differs from the material:\n\n%2\n\nWrite the file?").arg(name, text)))
              write();
          });
  DocumentController* controller = &m_parts.controller;
  connect(controller, &DocumentController::opened, this, [this](const QString& path) {
    updateAutosave();
    if (!path.isEmpty()) m_parts.recent.add(path);
  });
  connect(controller, &DocumentController::recovered, this, [this](const QString& autosavePath) {
    // The recovered copy goes once there is another.
    if (updateAutosave()) Autosave::forget(Autosave::defaultDataFolder(), autosavePath);
  });
  connect(controller, &DocumentController::saved, this, [this](const QString& path) {
    m_autosave.setDocumentPath(path);
    m_parts.recent.add(path);
  });
  connect(controller, &DocumentController::viewRestored, this, &DocumentFiles::restoreView);
  connect(controller, &DocumentController::unsavedChanges, this, &DocumentFiles::askAboutUnsavedChanges);
  connect(controller, &DocumentController::sourceChanged, this, &DocumentFiles::askAboutChangedSource);
}

void DocumentFiles::restoreView(const nlohmann::json& view) {
  m_parts.scene.open(sceneNameOf(view), scenePoseOf(view), [this, view] {
    restoreCamera(m_parts.preview, view);
    const auto stored = environmentOf(view);
    if (stored && *stored != m_parts.environment.name()) m_parts.environment.open(*stored);
  });
}

bool DocumentFiles::updateAutosave() { return m_autosave.setDocumentPath(m_parts.document.path()); }

void DocumentFiles::open(const QString& path) {
  if (mayDiscard()) m_parts.controller.open(path);
}

void DocumentFiles::askAndOpen() {
  const QString path =
      QFileDialog::getOpenFileName(m_window, tr("Open"), widgets::dialogFolder(openPurpose), openFilter());
  if (path.isEmpty()) return;
  widgets::rememberDialogFolder(openPurpose, path);
  open(path);
}

bool DocumentFiles::mayDiscard() {
  if (!m_parts.document.isModified()) return true;
  const auto answer = QMessageBox::question(m_window, tr("Unsaved changes"),
                                            tr("Save changes to %1?").arg(m_parts.document.name()), saveButtons);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

bool DocumentFiles::close() {
  if ((!m_discarding && !mayDiscard()) || !mayStopExports()) return false;
  m_autosave.discard();
  return true;
}

bool DocumentFiles::mayStopExports() {
  if (!m_parts.tasks.isWritingFiles()) return true;
  QMessageBox box(QMessageBox::Question, tr("Exports in progress"), tr("Files are still being exported."),
                  QMessageBox::Cancel, m_window);
  box.setInformativeText(tr("If you close now, incomplete exports are discarded."));
  QPushButton* stop = box.addButton(tr("Stop the Exports and Close"), QMessageBox::DestructiveRole);
  box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  return box.clickedButton() == stop;
}

void DocumentFiles::askAboutUnsavedChanges(const QString& replacement) {
  const QString name = m_parts.document.name();
  auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"), tr("Save changes to %1?").arg(name),
                              saveButtons, m_window);
  box->setInformativeText(tr("%1 is about to be opened in its place.").arg(replacement));
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(box, &QDialog::finished, this, [this](int answer) {
    m_parts.controller.replaceUnsaved(answer == QMessageBox::Save ? save() : answer == QMessageBox::Discard);
  });
  box->open();
}

void DocumentFiles::askAboutChangedSource(const QString& text) {
  auto* box =
      new QMessageBox(QMessageBox::Warning, tr("The measured file has changed"), text, QMessageBox::Cancel, m_window);
  box->setInformativeText(
      tr("The edits were made for the previous values. Applied to the changed file, they may look different, or take "
         "effect twice if the file already contains them."));
  const QPushButton* with = box->addButton(tr("Apply the &Edits"), QMessageBox::AcceptRole);
  const QPushButton* without = box->addButton(tr("Open &Without Edits"), QMessageBox::AcceptRole);
  box->setDefaultButton(QMessageBox::Cancel);
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(box, &QDialog::finished, this, [=, this] {
    m_parts.controller.openChangedSource(box->clickedButton() == with      ? ChangedSource::withEdits
                                         : box->clickedButton() == without ? ChangedSource::withoutEdits
                                                                           : ChangedSource::cancel);
  });
  box->open();
}

bool DocumentFiles::save() {
  const QString path = m_parts.document.path();
  return path.isEmpty() ? saveAs() : saveAgain(path);
}

bool DocumentFiles::saveAgain(const QString& path) {
  if (m_parts.controller.hasChangedOnDisk(path)) {
    QMessageBox box(QMessageBox::Warning, tr("The document has changed on disk"),
                    tr("Another program or window has changed %1 since it was opened or last saved here.").arg(path),
                    QMessageBox::Cancel, m_window);
    box.setInformativeText(tr("If you replace the file, the changes made there are lost."));
    const QPushButton* replace = box.addButton(tr("&Replace"), QMessageBox::DestructiveRole);
    QPushButton* elsewhere = box.addButton(tr("Save &As..."), QMessageBox::AcceptRole);
    box.setDefaultButton(elsewhere);
    box.exec();
    if (box.clickedButton() == elsewhere) return saveAs();
    if (box.clickedButton() != replace) return false;
  }
  return m_parts.controller.save(path, viewToJson(m_parts.preview));
}

bool DocumentFiles::saveAs() {
  const Document& document = m_parts.document;
  if (!document.material()) return false;
  const QString suggested = document.path().isEmpty()
                                ? widgets::inDialogFolder(openPurpose, document.name() + documentSuffix())
                                : document.path();
  QString path =
      QFileDialog::getSaveFileName(m_window, tr("Save"), suggested, tr("Gonio document (*%1)").arg(documentSuffix()));
  if (path.isEmpty()) return false;
  if (!isDocument(path)) path += documentSuffix();
  widgets::rememberDialogFolder(openPurpose, path);
  return saveTo(path);
}

bool DocumentFiles::saveTo(const QString& path) {
  return !m_parts.exports.refuses(path) && m_parts.controller.save(path, viewToJson(m_parts.preview));
}

void DocumentFiles::saveInLibrary() {
  if (!m_parts.document.material()) return;
  constexpr int characters = 60;
  QInputDialog dialog(m_window);
  dialog.setWindowTitle(tr("Save in Library"));
  dialog.setLabelText(tr("&Name:"));
  dialog.setTextValue(QFileInfo(m_parts.document.name()).completeBaseName());
  dialog.resize(dialog.fontMetrics().averageCharWidth() * characters, dialog.sizeHint().height());
  if (dialog.exec() != QDialog::Accepted) return;
  QString name = dialog.textValue().trimmed();
  if (name.isEmpty()) return;
  const QDir folder(m_parts.library.ownFolder());
  const QString path =
      folder.filePath(name.replace(QRegularExpression(QStringLiteral(R"([/\\:*?"<>|])")), "-") + documentSuffix());
  const bool isOwn = path == m_parts.document.path();
  if (!isOwn && QFileInfo::exists(path) &&
      QMessageBox::question(m_window, tr("Save in Library"), tr("Replace %1?").arg(name)) != QMessageBox::Yes)
    return;
  folder.mkpath(QStringLiteral("."));
  if (isOwn ? saveAgain(path) : saveTo(path)) m_parts.library.addOwn(path);
}

void DocumentFiles::exportBrdf() {
  const Document& document = m_parts.document;
  if (!document.material()) return;
  const std::vector<const materials::MaterialFormat*> formats = materials::writableFormats(*document.base());
  QStringList filters;
  for (const materials::MaterialFormat* format : formats) filters << formatFilter(*format);
  const auto suffixOf = [](const materials::MaterialFormat* format) { return formatSuffix(*format); };
  QString chosen = filters.front();
  const QString suggested = QDir(exportFolder(document)).filePath(proposedName(document) + suffixOf(formats.front()));
  // The question whether to replace an existing file follows below, once it is known not to be a source file.
  const QString path =
      QFileDialog::getSaveFileName(m_window, tr("Export BRDF"), suggested, filters.join(QStringLiteral(";;")), &chosen,
                                   QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  widgets::rememberDialogFolder(exportPurpose, path);
  const materials::MaterialFormat* format = formats[std::size_t(std::max(qsizetype(0), filters.indexOf(chosen)))];
  // A typed suffix counts more than the list.
  for (const materials::MaterialFormat* other : formats)
    if (path.endsWith(suffixOf(other), Qt::CaseInsensitive) && suffixOf(other) != suffixOf(format)) {
      format = other;
      break;
    }
  const QString target = withSuffix(path, suffixOf(format));
  if (m_parts.exports.refuses(target)) return;
  if (QFileInfo::exists(target) &&
      QMessageBox::question(m_window, tr("Export BRDF"), tr("Replace %1?").arg(QFileInfo(target).fileName())) !=
          QMessageBox::Yes)
    return;
  m_parts.exports.writeMaterial(target, *format);
}

void DocumentFiles::exportForRenderer() {
  auto* dialog = new ExportDialog(m_parts.exporter, m_parts.settings, m_parts.preview.content().scene(), m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void DocumentFiles::exportImage() {
  auto* dialog = new ImageDialog(
      {m_parts.document, m_parts.exports, m_parts.tasks, m_parts.comparison, m_parts.preview, m_parts.settings},
      proposedName(m_parts.document), m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void DocumentFiles::exportBlenderAddon() {
  askAndSave({tr("Export Blender Add-on"), QStringLiteral("gonio_blender"), tr("Add-on (*.zip)"),
              QStringLiteral(".zip"), [](const std::filesystem::path& path, const TaskControl&) {
                QFile addon(QStringLiteral(":/blender/gonio_blender.zip"));
                [[maybe_unused]] const bool opened = addon.open(QIODevice::ReadOnly);
                const QByteArray bytes = addon.readAll();
                io::writeFileAtomically(path, std::as_bytes(std::span(bytes.data(), std::size_t(bytes.size()))));
              }});
}

void DocumentFiles::saveFit() {
  const auto* edit = m_parts.document.active<editing::DifferentialEdit>();
  if (!edit) return;
  const models::Model* model = edit->model;
  const QString& name = m_parts.document.name();
  const QString suffix = tableSuffix();
  askAndSave({tr("Save Fit"), tr("%1, %2 fit").arg(name, widgets::toQString(model->spec().name)),
              tr("MERL file (*%1)").arg(suffix), suffix,
              [model, fitted = edit->fitted, name = name.toStdString()](const std::filesystem::path& path,
                                                                        const TaskControl& control) {
                materials::writeMaterial(materials::unedited(name, model->instantiate(fitted)), path, {}, control);
              }});
}

void DocumentFiles::askAndSave(const FileSave& save) {
  const QString path = QFileDialog::getSaveFileName(
      m_window, save.title, QDir(exportFolder(m_parts.document)).filePath(save.name + save.suffix), save.filter);
  if (path.isEmpty()) return;
  widgets::rememberDialogFolder(exportPurpose, path);
  m_parts.exports.save(withSuffix(path, save.suffix), save);
}

QList<RecoverableWork> DocumentFiles::askForRecovery() {
  const QString folder = Autosave::defaultDataFolder();
  QList<RecoverableWork> wanted;
  for (const RecoverableWork& work : Autosave::recoverable(folder)) {
    const QString time = QLocale().toString(QFileInfo(work.autosavePath).lastModified(), QLocale::ShortFormat);
    const auto answer =
        QMessageBox::question(m_window, tr("Recover unsaved work"),
                              tr("Gonio did not exit cleanly. Recover the unsaved changes to %1 (autosaved at %2)?")
                                  .arg(nameOfWork(work), time),
                              QMessageBox::Yes | QMessageBox::Discard | QMessageBox::Cancel);
    if (answer == QMessageBox::Discard) Autosave::forget(folder, work.autosavePath);
    if (answer == QMessageBox::Yes) wanted << work;
  }
  return wanted;
}

void DocumentFiles::recover(const RecoverableWork& work) {
  m_parts.controller.openRecovered(work.autosavePath, work.originalPath);
}

}  // namespace gonio::app

#include "moc_document_files.cpp"
