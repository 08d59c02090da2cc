// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/export_controller.h"

#include <QColor>
#include <QCoreApplication>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/library/thumbnail.h"
#include "core/documents/blend_source.h"
#include "core/materials/material_formats.h"
#include "core/math/colour.h"
#include "core/metrics/image_errors.h"
#include "widgets/inputs/number_field.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

QDoubleSpinBox* exportSnrField() {
  constexpr double smallest = 10, largest = 80;
  auto* field = new QDoubleSpinBox;
  field->setRange(smallest, largest);
  field->setDecimals(0);
  field->setKeyboardTracking(false);
  field->setToolTip(QCoreApplication::translate(
      "export",
      "How close renderings of the files should come to the material, as rendered SNR: from 30 dB they are close, from "
      "40 dB indistinguishable. A higher value gives larger files, and some targets cannot reach it"));
  const auto showWord = [field](double snr) {
    field->setSuffix(QCoreApplication::translate("export", " dB (%1)").arg(matchWord(snr)));
  };
  QObject::connect(field, &QDoubleSpinBox::valueChanged, field, showWord);
  showWord(field->value());
  return field;
}

QLabel* exportText() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setMinimumWidth(1);  // a long name must not widen the dialog
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

namespace {

const QString trialKey = QStringLiteral("export-trial"), pictureKey = QStringLiteral("export-picture");
constexpr int trialPixels = 288, trialSamples = 32, coarsePixels = 96, coarseSamples = 16;

std::vector<std::string> messagesOf(const exports::ExportResult& made) {
  std::vector<std::string> messages = made.losses;
  messages.insert(messages.end(), made.warnings.begin(), made.warnings.end());
  return messages;
}

/// The displayed picture in linear light, for the metrics.
Image linearOf(const QImage& picture) {
  Image linear(picture.width(), picture.height());
  for (int y = 0; y < linear.height; ++y)
    for (int x = 0; x < linear.width; ++x) {
      const QColor colour = QColor::fromRgba(picture.pixel(x, y));
      linear.at(x, y) = glm::vec3(fromSrgb(colour.redF()), fromSrgb(colour.greenF()), fromSrgb(colour.blueF()));
    }
  return linear;
}

double flipOf(const QImage& original, const QImage& exported) {
  return metrics::flip(linearOf(original), linearOf(exported));
}

QString labelOf(const exports::ExportTarget& target) { return widgets::toQString(target.label); }

}  // namespace

QString fileNames(const exports::ExportTarget& target, const QString& name, const rendering::Scene* withScene) {
  QStringList names;
  for (const std::filesystem::path& path : target.paths(name.toStdString(), withScene))
    names << QString::fromStdString(path.filename().string());
  if (names.size() == 1) return names.front();
  const QString last = names.takeLast();
  return ExportController::tr("%1 and %2").arg(names.join(QStringLiteral(", ")), last);
}

ExportController::ExportController(Document& document, BackgroundTasks& tasks, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks) {
  constexpr int restMilliseconds = 1000;
  m_rest.setSingleShot(true);
  m_rest.setInterval(restMilliseconds);
  connect(&m_rest, &QTimer::timeout, this, [this] {
    if (m_document.isInteracting()) return m_rest.start();
    if (m_isKept && m_last) repeat();
  });
  for (const auto changed : {&Document::stateChanged, &Document::editChanged})
    connect(&document, changed, this, [this] {
      if (m_isKept && m_last) m_rest.start();
    });
  connect(&document, &Document::materialChanged, this, [this] {
    m_last.reset();
    m_isKept = false;
    m_rest.stop();
    Q_EMIT lastChanged();
  });
}

bool ExportController::isKnown(const materials::EditedMaterial& material) const {
  const materials::EditedMaterial& known = m_known.material;
  return known.base.brdf == material.base.brdf && known.edits == material.edits &&
         known.incident == material.incident && known.shown.name == material.shown.name;
}

QImage ExportController::picture(const materials::EditedMaterial& material) const {
  return isKnown(material) ? m_known.picture : QImage();
}

QImage ExportController::expected(const materials::EditedMaterial& material,
                                  const exports::ExportTarget& target) const {
  if (!isKnown(material) || target.group == exports::TargetGroup::data) return {};
  return target.group == exports::TargetGroup::renderers ? m_known.picture : m_known.fit;
}

/// The model with the edits of the sliders; null if there is none, or if there are edits of another kind.
std::shared_ptr<const Brdf> ExportController::editedFit() const {
  const auto* edit = m_document.active<editing::DifferentialEdit>();
  if (!edit || m_document.edits().size() > 1 || edit->changesColours()) return nullptr;
  return edit->model->instantiate(edit->target());
}

ExportTrialPtr ExportController::known(const materials::EditedMaterial& material, const exports::ExportTarget& target,
                                       double snr) const {
  const auto found = m_known.trials.find(keyOf(target, snr));
  return isKnown(material) && found != m_known.trials.end() ? found->second : nullptr;
}

void ExportController::tryOut(const materials::EditedMaterial& material, const exports::ExportTarget& target,
                              const exports::ExportOptions& options, const std::function<void()>& changed,
                              const std::function<void(const QString&)>& failed) {
  if (!isKnown(material)) m_known = {.material = material};
  const Key key = keyOf(target, options.snr);
  const QString title = tr("Preparing the export for %1").arg(labelOf(target));
  if (m_known.picture.isNull()) drawCoarse(changed);
  if (m_known.trials.contains(key)) return refine(key, title, changed, failed);
  m_tasks.run<ExportTrialPtr>(
      {title, trialKey},
      [material, &target, options](const TaskControl& control) {
        constexpr double madeFraction = 0.8;
        auto trial = std::make_shared<ExportTrial>();
        trial->made = exports::makeExport(target, material, options, control.between(0, madeFraction));
        if (trial->made.brdf) trial->exported = spherePicture(*trial->made.brdf, coarsePixels, coarseSamples);
        return trial;
      },
      [this, key, title, changed, failed](const ExportTrialPtr& trial) {
        m_known.trials[key] = trial;
        refine(key, title, changed, failed);
        changed();
      },
      failed, [failed] { failed(tr("The export was cancelled.")); });
}

/// At once, beside the trial.
void ExportController::drawCoarse(const std::function<void()>& changed) {
  struct Coarse {
    QImage material, fit;
  };
  m_tasks.run<Coarse>(
      {.title = tr("Rendering the material"), .key = pictureKey, .live = true},
      [brdf = m_known.material.shown.brdf, fit = editedFit()](const TaskControl& control) {
        return Coarse{spherePicture(*brdf, coarsePixels, coarseSamples, control.between(0, 0.5)),
                      fit ? spherePicture(*fit, coarsePixels, coarseSamples, control.between(0.5, 1)) : QImage()};
      },
      [this, changed](const Coarse& coarse) {
        if (!m_known.isRefined) m_known.picture = coarse.material;
        m_known.fit = coarse.fit;
        changed();
      });
}

/// The pictures at their full size, and what they and the files measure.
void ExportController::refine(const Key& key, const QString& title, const std::function<void()>& changed,
                              const std::function<void(const QString&)>& failed) {
  struct Refined {
    QImage picture;
    ExportTrialPtr trial;
  };
  const QImage known = m_known.isRefined ? m_known.picture : QImage();
  m_tasks.run<Refined>(
      {title, trialKey},
      [brdf = m_known.material.shown.brdf, known, coarse = m_known.trials.at(key)](const TaskControl& control) {
        const QImage picture =
            known.isNull() ? spherePicture(*brdf, trialPixels, trialSamples, control.between(0.8, 0.9)) : known;
        auto trial = std::make_shared<ExportTrial>(*coarse);
        trial->isRefined = true;
        if (trial->made.brdf) {
          trial->exported = spherePicture(*trial->made.brdf, trialPixels, trialSamples, control.between(0.9, 0.95));
          trial->flip = flipOf(picture, trial->exported);
          trial->cost = study::measureUse(*trial->made.brdf, control.between(0.95, 1));
        }
        return Refined{picture, trial};
      },
      [this, key, changed](const Refined& refined) {
        m_known.picture = refined.picture;
        m_known.isRefined = true;
        m_known.trials[key] = refined.trial;
        changed();
      },
      failed, [failed] { failed(tr("The export was cancelled.")); });
}

void ExportController::dropTrial() {
  m_tasks.drop(trialKey);
  m_tasks.drop(pictureKey);
}

std::optional<double> ExportController::trialProgress() const { return m_tasks.progress(trialKey); }

void ExportController::write(const materials::EditedMaterial& material, const ExportRequest& request,
                             const ExportTrialPtr& trial) {
  m_last = request;
  Q_EMIT lastChanged();
  const std::vector<std::filesystem::path> used = documents::sourceFiles(m_document.toEditDocument());
  writeInBackground(request, [material, request, trial, used](const TaskControl& control) {
    const std::filesystem::path name = request.name.toStdString();
    exports::checkTargets(request.target->paths(name, request.scene.get()), used, true);
    if (request.scene) exports::checkSceneName(*request.target->scene, name.filename().string());
    exports::ExportResult made =
        trial ? trial->made : exports::makeExport(*request.target, material, request.options, control);
    if (request.scene) exports::addScene(made, *request.target, *request.scene, name);
    exports::writeExport(exports::exportedFiles(made, name));
    return messagesOf(made);
  });
}

void ExportController::writeMeasured(const QString& id, const ExportRequest& request, bool replace) {
  writeInBackground(request, [id, request, replace](const TaskControl& control) {
    const std::filesystem::path name = request.name.toStdString(), source = id.toStdString();
    if (isDocument(id)) throw Error(source.string() + ": open the document to export it with its edits");
    exports::checkTargets(request.target->paths(name), std::span(&source, 1), replace);
    const materials::Material material = materials::readMaterial(source, control.between(0, 0.1));
    const exports::ExportResult made =
        exports::makeExport(*request.target, materials::unedited(material), request.options, control.between(0.1, 1));
    exports::writeExport(exports::exportedFiles(made, name));
    return messagesOf(made);
  });
}

void ExportController::writeInBackground(const ExportRequest& request, Writer writer) {
  const QString files = fileNames(*request.target, request.name, request.scene.get());
  const QString folder = QDir::toNativeSeparators(QFileInfo(request.name).absolutePath());
  const QString title =
      request.place.isEmpty() ? tr("Exporting %1").arg(files) : tr("Exporting %1 (%2)").arg(files, request.place);
  m_tasks.run<std::vector<std::string>>(
      {.title = title, .file = true}, std::move(writer),
      [this, files, folder](const std::vector<std::string>& warnings) {
        Q_EMIT exported(tr("%1 in %2").arg(files, folder));
        QStringList texts;
        for (const std::string& warning : warnings) texts << QString::fromStdString(warning);
        if (!texts.isEmpty())
          Q_EMIT warned(tr("%1 exported with limitations: %2.").arg(files, texts.join(QStringLiteral("; "))));
      },
      [this, files](const QString& error) { Q_EMIT failed(tr("Cannot export %1").arg(files), error); },
      [this, files] { Q_EMIT cancelled(files); });
}

void ExportController::setKeptUpToDate(bool kept) {
  m_isKept = kept;
  Q_EMIT lastChanged();
}

void ExportController::repeat() {
  assert(m_last);
  write(m_document.edited(), *m_last, nullptr);
}

}  // namespace gonio::app

#include "moc_export_controller.cpp"
