// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/document_controller.h"

#include <QFileInfo>
#include <algorithm>
#include <set>

#include "app/gonio/document/edit_steps.h"
#include "app/gonio/document/edit_transfer.h"
#include "app/gonio/document/material_files.h"
#include "core/editing/factor_transfer.h"
#include "core/io/image_io.h"
#include "core/rendering/path_tracer.h"
#include "widgets/inputs/number_field.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {
const QString openKey = QStringLiteral("open"), fitKey = QStringLiteral("fit"), exportKey = QStringLiteral("export"),
              pasteKey = QStringLiteral("paste-factors");
constexpr int exrSide = 1024, exrSamples = 128;

QString shortName(const QString& path) { return path.section('/', -1); }

editing::FactorEdit carriedOver(const editing::FactorEdit& edit, const TabulatedBrdf& table,
                                const TaskControl& control) {
  const factorization::PdvOptions options{
      .form = edit.original->form, .transform = edit.original->transform, .terms = edit.original->terms()};
  auto factors = factorization::factorizePdv(table, options, control).factors;
  return editing::transferredEdit(edit, std::make_shared<const factorization::PdvFactors>(std::move(factors)));
}
}  // namespace

const models::Model& defaultModel() { return models::findModel("ggx"); }

DocumentController::DocumentController(Document& document, BackgroundTasks& tasks, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks) {
  connect(&document, &Document::materialReplaced, this, [this] {
    dropTasks();
    if (!hasModelEdit()) automaticFit();
  });
}

void DocumentController::open(const QString& path) { start(path, isDocument(path) ? path : QString(), false); }

void DocumentController::openRecovered(const QString& autosavePath, const QString& originalPath) {
  start(autosavePath, originalPath, true);
}

void DocumentController::start(const QString& path, const QString& documentPath, bool recovered) {
  m_opening = path;
  const bool stored = recovered || isDocument(path);
  m_tasks.run<Opened>(
      {tr("Opening %1").arg(shortName(path)), openKey},
      [path, documentPath, stored](const TaskControl& control) {
        Opened opened;
        const std::filesystem::path source = path.toStdString();
        if (stored) {
          // A recovered copy names its source as the document that it stands for would.
          const std::string document = (documentPath.isEmpty() ? path : documentPath).toStdString();
          opened.stored = editing::resolved(editing::readDocument(source), document);
        }
        opened.material = stored ? loadSource(*opened.stored, control) : loadMaterial(source, control);
        return opened;
      },
      [=, this](const Opened& opened) {
        m_opening.clear();
        try {
          install(opened, path, documentPath, recovered);
        } catch (const Error& error) {
          Q_EMIT failed(tr("Cannot open %1").arg(shortName(path)), QString::fromUtf8(error.what()));
        }
      },
      [=, this](const QString& error) {
        m_opening.clear();
        Q_EMIT failed(tr("Cannot open %1").arg(shortName(path)), error);
      },
      [this] { m_opening.clear(); });
}

void DocumentController::install(const Opened& opened, const QString& path, const QString& documentPath,
                                 bool recovered) {
  dropTasks();
  Q_EMIT installing();
  if (!opened.stored) {
    m_document.setMaterial(opened.material);
  } else {
    m_document.setMaterial(opened.material, *opened.stored, documentPath);
    if (recovered) {
      m_document.markUnsaved();
      Q_EMIT this->recovered(path);
    }
    Q_EMIT viewRestored(opened.stored->view);
    if (opened.stored->sourceSha256 != opened.material->material.source.sha256)
      Q_EMIT warned(
          opened.stored->blend
              ? tr("A material that this document blends has changed since it was saved. The blend is made of the "
                   "files as they are now.")
              : tr("The measured file %1 has changed since this document was saved. The edit is applied to the file "
                   "as it is now.")
                    .arg(QString::fromStdString(opened.material->material.source.path.string())));
  }
  Q_EMIT this->opened(recovered ? documentPath : path);
  if (!hasModelEdit()) automaticFit();
}

void DocumentController::dropTasks() {
  m_tasks.drop(fitKey);
  m_tasks.drop(pasteKey);
  m_proposal.reset();
}

void DocumentController::automaticFit() {
  runFit(defaultModel(), [this](const fitting::FitResult& fit) {
    if (hasModelEdit())
      m_document.chooseFit(fit);
    else
      m_document.adoptFit(fit);
  });
}

bool DocumentController::isFitting() const { return m_tasks.isRunning(fitKey); }

void DocumentController::runFit(const models::Model& model, std::function<void(const fitting::FitResult&)> done,
                                const models::ParameterValues& choices) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  const QString name = widgets::fromView(model.spec().name);
  m_tasks.run<fitting::FitResult>(
      {tr("Fitting %1").arg(name), fitKey},
      [material, &model, choices](const TaskControl& control) {
        return fitting::fit(*material->fitBase(control), model, {}, control, choices);
      },
      [this, name, done = std::move(done)](const fitting::FitResult& fit) {
        if (!fit.cancelled) {
          m_document.rememberFit(fit);
          for (const std::string& warning : fit.warnings) Q_EMIT warned(QString::fromStdString(warning));
          return done(fit);
        }
        m_proposal = fit;
        const QString error = fit.errors.empty() ? tr("unknown") : widgets::formatNumber(fit.errors.front());
        Q_EMIT proposalOffered(
            tr("The fit of %1 was stopped. Its best so far has a log error of %2.").arg(name, error));
      },
      [this, name](const QString& error) { Q_EMIT failed(tr("Cannot fit %1").arg(name), error); });
}

void DocumentController::chooseModel(const models::Model& model) {
  const auto* active = m_document.active<editing::DifferentialEdit>();
  if (const fitting::FitResult* known = m_document.knownFit(model)) {
    m_tasks.drop(fitKey);
    if (!active || active->model != &model) m_document.chooseFit(*known);
    return;
  }
  runFit(model, [this](const fitting::FitResult& fit) { m_document.chooseFit(fit); });
}

void DocumentController::addModelEdit() {
  const auto* active = m_document.active<editing::DifferentialEdit>();
  if (!active) return chooseModel(defaultModel());
  addEdit(m_document, {editing::DifferentialEdit{active->model, active->fitted, active->fitted, active->composition}});
}

void DocumentController::fit() {
  const auto use = [this](const fitting::FitResult& fit) { m_document.chooseFit(fit); };
  if (const auto* active = m_document.active<editing::DifferentialEdit>())
    runFit(*active->model, use, active->edited);
  else
    runFit(defaultModel(), use);
}

void DocumentController::applyProposal() {
  if (m_proposal) m_document.chooseFit(*m_proposal);
  m_proposal.reset();
}

bool DocumentController::save(const QString& path, const nlohmann::json& view) {
  try {
    editing::EditDocument stored = m_document.toEditDocument();
    stored.view = view;
    editing::writeDocument(stored, path.toStdString());
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot save %1").arg(shortName(path)), QString::fromUtf8(error.what()));
    return false;
  }
  m_document.markSaved(path);
  Q_EMIT saved(path);
  return true;
}

void DocumentController::exportMaterial(const QString& path, exports::MaterialForm form) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  m_tasks.run<ExportLosses>(
      {tr("Exporting %1").arg(shortName(path)), exportKey},
      [material, base = m_document.base(), edits = m_document.edits(), form, path](const TaskControl& control) {
        return writeMaterial(*material, base, edits, form, path.toStdString(), control);
      },
      [this, path](const ExportLosses& losses) {
        Q_EMIT exported(path);
        if (!losses.sentences.isEmpty()) Q_EMIT warned(QStringLiteral("%1: %2").arg(shortName(path), losses.text()));
      },
      [this, path](const QString& error) { Q_EMIT failed(tr("Cannot export %1").arg(shortName(path)), error); });
}

void DocumentController::exportExr(const QString& path, const Scene& scene, const EffectOverrides& overrides,
                                   const RenderMaterials& others) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  const editing::EditList edits = m_document.edits();
  m_tasks.run<bool>(
      {tr("Rendering %1").arg(shortName(path)), exportKey},
      [material, base = m_document.base(), edits, scene, overrides, others, path](const TaskControl& control) {
        const auto edited = std::make_shared<const RenderMaterial>(editing::applyEdits(base, edits));
        const RenderMaterials materials = bindMaterials(scene, materialsInSlots(scene, edited, others));
        constexpr std::uint64_t seed = 1;
        const PathTracer tracer(scene, materials, planEffects(scene, materials, overrides), seed);
        Film film(exrSide, exrSide);
        tracer.accumulate(film, exrSamples, control);
        io::writeExr(film.image(), path.toStdString(),
                     pictureAttributes(scene, tracer.plan(), material->material.name, film.samples, seed));
        return true;
      },
      [this, path](bool) { Q_EMIT exported(path); },
      [this, path](const QString& error) { Q_EMIT failed(tr("Cannot export %1").arg(shortName(path)), error); });
}

const models::ParameterValues* DocumentController::fittedValues(const models::Model& model) const {
  const auto* active = m_document.active<editing::DifferentialEdit>();
  if (active && active->model == &model) return &active->fitted;
  const fitting::FitResult* known = m_document.knownFit(model);
  return known ? &known->parameters : nullptr;
}

void DocumentController::paste(const editing::EditList& edits) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material || edits.empty()) return;
  bool factors = false;
  std::set<const models::Model*> missing;
  for (const editing::Edit& edit : edits)
    if (const auto* differential = std::get_if<editing::DifferentialEdit>(&edit.content); !differential)
      factors = true;
    else if (!fittedValues(*differential->model))
      missing.insert(differential->model);
  if (!factors && missing.empty()) return install({edits, {}});
  m_tasks.run<Pasted>(
      {tr("Carrying the edits over"), pasteKey},
      [material, edits, missing](const TaskControl& control) {
        Pasted carried{edits, {}};
        for (editing::Edit& edit : carried.edits)
          if (auto* curves = std::get_if<editing::FactorEdit>(&edit.content))
            *curves = carriedOver(*curves, *material->table(control), control);
        for (const models::Model* model : missing) {
          carried.fits.push_back(fitting::fit(*material->fitBase(control), *model, {}, control));
          if (carried.fits.back().cancelled) throw Cancelled();
        }
        return carried;
      },
      [this](const Pasted& carried) { install(carried); },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot paste the edits"), error); });
}

void DocumentController::install(const Pasted& pasted) {
  if (!pasted.fits.empty()) m_tasks.drop(fitKey);  // a fit under way would replace what is pasted
  for (const fitting::FitResult& fit : pasted.fits) {
    m_document.rememberFit(fit);
    for (const std::string& warning : fit.warnings) Q_EMIT warned(QString::fromStdString(warning));
  }
  editing::EditList edits = pasted.edits;
  for (editing::Edit& edit : edits)
    if (auto* differential = std::get_if<editing::DifferentialEdit>(&edit.content)) {
      const models::ParameterValues* fitted = fittedValues(*differential->model);
      // The edit that its fit came with was deleted meanwhile.
      if (!fitted) return paste(pasted.edits);
      differential->edited = transferredEdit(*differential, *fitted);
      differential->fitted = *fitted;
    }
  pasteEdits(m_document, edits);
}

}  // namespace gonio::app

#include "moc_document_controller.cpp"
