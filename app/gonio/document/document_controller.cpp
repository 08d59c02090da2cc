// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/document_controller.h"

#include <QFileInfo>
#include <algorithm>

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
    forgetFits();
    if (!m_document.edit()) automaticFit();
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
  forgetFits();
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
  if (!m_document.edit()) automaticFit();
}

void DocumentController::forgetFits() {
  m_tasks.drop(fitKey);
  m_tasks.drop(pasteKey);
  m_fits.clear();
  m_proposal.reset();
}

void DocumentController::automaticFit() {
  runFit(defaultModel(), [this](const fitting::FitResult& fit) {
    if (!m_document.edit())
      m_document.adoptFit(fit);
    else
      m_document.chooseFit(fit);
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
        return fitting::fit(*material->table, model, {}, control, choices);
      },
      [this, name, done = std::move(done)](const fitting::FitResult& fit) {
        if (!fit.cancelled) {
          m_fits[fit.model] = fit;
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
  if (const auto known = m_fits.find(&model); known != m_fits.end()) {
    m_tasks.drop(fitKey);
    if (!m_document.edit() || m_document.edit()->model != &model) m_document.chooseFit(known->second);
    return;
  }
  runFit(model, [this](const fitting::FitResult& fit) { m_document.chooseFit(fit); });
}

void DocumentController::fit() {
  const auto use = [this](const fitting::FitResult& fit) { m_document.chooseFit(fit); };
  if (const auto& edit = m_document.edit())
    runFit(*edit->model, use, edit->edited);
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

void DocumentController::exportMerl(const QString& path) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  const std::vector<editing::Edit> edits = m_document.edits();
  m_tasks.run<bool>(
      {tr("Exporting %1").arg(shortName(path)), exportKey},
      [material, edits, path](const TaskControl& control) {
        const std::filesystem::path target = path.toStdString();
        if (std::all_of(edits.begin(), edits.end(), [](const auto& edit) { return isIdentity(edit); }))
          materials::writeMaterial(material->material, target, control);
        else
          materials::writeMaterial(*editing::bakeEdits(material->table, edits, control), target);
        return true;
      },
      [this, path, edits](bool) {
        Q_EMIT exported(path);
        if (std::any_of(edits.begin(), edits.end(), [](const auto& edit) { return isAnisotropic(edit); }))
          Q_EMIT warned(tr("%1 holds the mean over all azimuths: the edit is anisotropic, MERL files are not.")
                            .arg(shortName(path)));
      },
      [this, path](const QString& error) { Q_EMIT failed(tr("Cannot export %1").arg(shortName(path)), error); });
}

void DocumentController::exportExr(const QString& path, const Scene& scene, const EffectOverrides& overrides,
                                   const RenderMaterials& others) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  const std::vector<editing::Edit> edits = m_document.edits();
  m_tasks.run<bool>(
      {tr("Rendering %1").arg(shortName(path)), exportKey},
      [material, edits, scene, overrides, others, path](const TaskControl& control) {
        const auto edited = std::make_shared<const RenderMaterial>(editing::applyEdits(material->table, edits));
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

void DocumentController::paste(const std::vector<editing::Edit>& edits) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  Pasted pasted;
  for (const editing::Edit& edit : edits)
    if (const auto* factors = std::get_if<editing::FactorEdit>(&edit))
      pasted.factors = *factors;
    else
      pasted.edit = std::get<editing::DifferentialEdit>(edit);
  const auto& current = m_document.edit();
  const models::Model* missing =
      pasted.edit && !(current && current->model == pasted.edit->model) ? pasted.edit->model : nullptr;
  if (const auto known = m_fits.find(missing); known != m_fits.end()) {
    pasted.fit = known->second;
    missing = nullptr;
  }
  if (!pasted.factors && !missing) return install(pasted);
  m_tasks.run<Pasted>(
      {tr("Carrying the edits over"), pasteKey},
      [material, pasted, missing](const TaskControl& control) {
        Pasted carried = pasted;
        if (pasted.factors) carried.factors = carriedOver(*pasted.factors, *material->table, control);
        if (missing) carried.fit = fitting::fit(*material->table, *missing, {}, control);
        if (carried.fit && carried.fit->cancelled) throw Cancelled();
        return carried;
      },
      [this](const Pasted& carried) { install(carried); },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot paste the edits"), error); });
}

void DocumentController::install(const Pasted& pasted) {
  std::optional<editing::DifferentialEdit> edit = pasted.edit;
  if (pasted.fit) {
    m_tasks.drop(fitKey);  // a fit under way would replace what is pasted
    m_fits[pasted.fit->model] = *pasted.fit;
    for (const std::string& warning : pasted.fit->warnings) Q_EMIT warned(QString::fromStdString(warning));
  }
  if (edit) {
    const auto& current = m_document.edit();
    const bool inUse = !pasted.fit && current && current->model == edit->model;
    // Another model was chosen meanwhile.
    if (!inUse && !pasted.fit) return paste(editing::editStack(pasted.factors, pasted.edit));
    const models::ParameterValues& fitted = inUse ? current->fitted : pasted.fit->parameters;
    edit->edited = transferredEdit(*edit, fitted);
    edit->fitted = fitted;
  }
  m_document.paste(pasted.factors, edit, pasted.fit);
}

}  // namespace gonio::app

#include "moc_document_controller.cpp"
