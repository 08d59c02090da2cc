// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/document_controller.h"

#include <QFileInfo>
#include <algorithm>
#include <set>
#include <utility>

#include "app/gonio/document/edit_steps.h"
#include "app/gonio/document/material_files.h"
#include "core/editing/factor_edit.h"
#include "core/io/sha256.h"
#include "core/support/error.h"
#include "widgets/inputs/number_field.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {
QString keyOf(const QString& path) { return QFileInfo(path).absoluteFilePath(); }
}  // namespace

QByteArray FileVersions::digest(const QString& path) {
  try {
    return QByteArray::fromStdString(io::sha256Hex(io::FileSource(path.toStdString())));
  } catch (const Error&) {
    return {};
  }
}

void FileVersions::remember(const QString& path, const QByteArray& digest) { m_digests[keyOf(path)] = digest; }

bool FileVersions::hasChanged(const QString& path) const {
  const auto known = m_digests.constFind(keyOf(path));
  if (known == m_digests.constEnd()) return false;
  const QByteArray current = digest(path);
  return !current.isEmpty() && current != *known;
}

namespace {
const QString openKey = QStringLiteral("open"), fitKey = QStringLiteral("fit"),
              lobesKey = QStringLiteral("several-lobes"), pasteKey = QStringLiteral("paste-factors");

/// Log error of several lobes, relative to that of the default model, up to which they are proposed.
constexpr double muchCloser = 0.6;

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
  m_known = currentState();
  m_changedSource.reset();
  m_replacement = nullptr;
  const bool stored = recovered || isDocument(path);
  m_tasks.run<Opened>(
      {tr("Opening %1").arg(shortName(path)), openKey},
      [path, documentPath, stored](const TaskControl& control) {
        Opened opened;
        const std::filesystem::path source = path.toStdString();
        if (!documentPath.isEmpty()) opened.digest = FileVersions::digest(documentPath);
        if (stored) {
          // A recovered copy names its source as the document that it stands for would.
          const std::string document = (documentPath.isEmpty() ? path : documentPath).toStdString();
          opened.stored = documents::resolved(documents::readDocument(source), document);
        }
        opened.material = stored ? loadSource(*opened.stored, control) : loadMaterial(source, control);
        return opened;
      },
      [=, this](Opened opened) {
        m_opening.clear();
        opened.path = path;
        opened.documentPath = documentPath;
        opened.recovered = recovered;
        if (opened.stored && opened.stored->sourceSha256 != opened.material->material.source.sha256)
          offerChangedSource(std::move(opened));
        else
          replace(shortName(path), m_known, [=, this] { install(opened); });
      },
      [=, this](const QString& error) {
        m_opening.clear();
        Q_EMIT failed(tr("Cannot open %1").arg(shortName(path)), error);
      },
      [this] { m_opening.clear(); });
}

void DocumentController::install(const Opened& opened) {
  try {
    dropTasks();
    Q_EMIT installing();
    if (!opened.stored) {
      m_document.setMaterial(opened.material);
    } else {
      if (!opened.documentPath.isEmpty()) m_versions.remember(opened.documentPath, opened.digest);
      m_document.setMaterial(opened.material, *opened.stored, opened.documentPath);
      if (opened.recovered || opened.unsaved) m_document.markUnsaved();
      if (opened.recovered) Q_EMIT this->recovered(opened.path);
      Q_EMIT viewRestored(opened.stored->view);
    }
    Q_EMIT this->opened(opened.recovered ? opened.documentPath : opened.path);
    if (!hasModelEdit()) automaticFit();
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot open %1").arg(shortName(opened.path)), QString::fromUtf8(error.what()));
  }
}

void DocumentController::offerChangedSource(Opened opened) {
  const QString name = shortName(opened.path);
  const QString source = QString::fromStdString(opened.material->material.source.path.string());
  const QString text = opened.stored->blend
                           ? tr("%1 blends materials; one of them has changed since the document was saved.").arg(name)
                           : tr("%1 edits %2, which has changed since the document was saved.").arg(name, source);
  m_changedSource = std::make_shared<const Opened>(std::move(opened));
  Q_EMIT sourceChanged(text);
}

void DocumentController::openChangedSource(ChangedSource choice) {
  const std::shared_ptr<const Opened> changed = std::exchange(m_changedSource, nullptr);
  if (!changed || choice == ChangedSource::cancel) return;
  Opened next = *changed;
  next.unsaved = true;
  // As if the measured file had been opened: saving replaces no document, and a recovered copy stays where it is.
  if (choice == ChangedSource::withoutEdits)
    next = {.material = changed->material,
            .stored = {},
            .path = QString::fromStdString(changed->material->material.source.path.native()),
            .documentPath = {}};
  replace(shortName(next.path), m_known, [=, this] { install(next); });
}

void DocumentController::openInMemory(const LoadedMaterialPtr& material, const QString& text) {
  const QString name = QString::fromStdString(material->material.name);
  replace(name, std::nullopt, [=, this] { m_document.replaceMaterial(material, text); });
}

DocumentController::KnownState DocumentController::currentState() const {
  return {m_document.material(), m_document.edits(), m_document.state().incident};
}

void DocumentController::replace(const QString& name, const std::optional<KnownState>& known,
                                 std::function<void()> install) {
  if (!m_document.isModified() || known == currentState()) return install();
  m_replacement = std::move(install);
  Q_EMIT unsavedChanges(name);
}

void DocumentController::replaceUnsaved(bool replace) {
  const auto install = std::exchange(m_replacement, nullptr);
  if (install && replace) install();
}

void DocumentController::dropTasks() {
  m_tasks.drop(fitKey);
  m_tasks.drop(lobesKey);
  m_tasks.drop(pasteKey);
  m_proposal.reset();
}

void DocumentController::automaticFit() {
  runFit(defaultModel(), [this](const fitting::FitResult& fit) {
    if (hasModelEdit())
      m_document.chooseFit(fit);
    else
      m_document.adoptFit(fit);
    if (fit.warnings.empty()) compareWithSeveralLobes(fit);
  });
}

void DocumentController::compareWithSeveralLobes(const fitting::FitResult& single) {
  const models::Model& model = models::findModel("layered");
  const QString name = widgets::toQString(model.spec().name);
  m_tasks.run<fitting::FitResult>(
      {tr("Fitting %1 for comparison").arg(name), lobesKey, true},
      [material = m_document.material(), &model](const TaskControl& control) {
        return fitting::fit(material->fitBase(control), model, {}, control);
      },
      [this, name, &model = *single.model, error = single.errors.front()](const fitting::FitResult& fit) {
        if (fit.cancelled) return;
        m_document.rememberFit(fit);
        const auto* active = m_document.active<editing::DifferentialEdit>();
        if (!active || active->model != &model || !(fit.errors.front() < muchCloser * error)) return;
        m_proposal = fit;
        Q_EMIT proposalOffered(
            tr("This material has several highlights, such as paint under a coat. Use sliders for each of them (%1)?")
                .arg(name));
      },
      [](const QString&) {});
}

bool DocumentController::isFitting() const { return m_tasks.isRunning(fitKey); }

void DocumentController::runFit(const models::Model& model, std::function<void(const fitting::FitResult&)> done,
                                const models::ParameterValues& choices) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material) return;
  const QString name = widgets::toQString(model.spec().name);
  m_tasks.run<fitting::FitResult>(
      {tr("Fitting %1").arg(name), fitKey},
      [material, &model, choices](const TaskControl& control) {
        return fitting::fit(material->fitBase(control), model, {}, control, choices);
      },
      [this, name, done = std::move(done)](const fitting::FitResult& fit) {
        if (!fit.cancelled) {
          m_document.rememberFit(fit);
          return done(fit);
        }
        m_proposal = fit;
        Q_EMIT proposalOffered(
            fit.errors.empty()
                ? tr("The fit of %1 was stopped. The log error of the best parameters so far is unknown.").arg(name)
                : tr("The fit of %1 was stopped. The best parameters so far have a log error of %2.")
                      .arg(name, widgets::formatNumber(fit.errors.front())));
      },
      [this, name](const QString& error) { Q_EMIT failed(tr("Cannot fit %1").arg(name), error); });
}

void DocumentController::chooseModel(const models::Model& model) {
  m_tasks.drop(lobesKey);
  const auto* active = m_document.active<editing::DifferentialEdit>();
  if (const fitting::FitResult* known = m_document.knownFit(model)) {
    m_tasks.drop(fitKey);
    if (!active || active->model != &model) m_document.chooseFit(*known);
    return;
  }
  runFit(model, [this](const fitting::FitResult& fit) { useFit(fit); });
}

void DocumentController::addModelEdit() {
  const auto* active = m_document.active<editing::DifferentialEdit>();
  if (!active) return chooseModel(defaultModel());
  editing::DifferentialEdit unchanged = editing::unchangedEdit(*active->model, active->fitted);
  unchanged.composition = active->composition;
  unchanged.keepsAlbedo = active->keepsAlbedo;
  addEdit(m_document, {unchanged});
}

void DocumentController::fit() {
  const auto use = [this](const fitting::FitResult& fit) { useFit(fit); };
  if (const auto* active = m_document.active<editing::DifferentialEdit>())
    runFit(*active->model, use, active->edited);
  else
    runFit(defaultModel(), use);
}

/// For fits that the user chose. The warnings of the automatic fit are shown with its errors (costDetails()).
void DocumentController::useFit(const fitting::FitResult& fit) {
  warnAbout(fit);
  m_document.chooseFit(fit);
}

void DocumentController::warnAbout(const fitting::FitResult& fit) {
  for (const std::string& warning : fit.warnings) Q_EMIT warned(QString::fromStdString(warning));
}

void DocumentController::applyProposal() {
  if (m_proposal) m_document.chooseFit(*m_proposal);
  m_proposal.reset();
}

bool DocumentController::save(const QString& path, const nlohmann::json& view) {
  try {
    documents::EditDocument stored = m_document.toEditDocument();
    stored.view = view;
    documents::writeDocument(stored, path.toStdString());
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot save %1").arg(shortName(path)), QString::fromUtf8(error.what()));
    return false;
  }
  m_versions.remember(path, FileVersions::digest(path));
  m_document.markSaved(path);
  Q_EMIT saved(path);
  return true;
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
      {tr("Transferring the edits"), pasteKey},
      [material, edits, missing](const TaskControl& control) {
        Pasted carried{edits, {}};
        for (editing::Edit& edit : carried.edits)
          if (auto* curves = std::get_if<editing::FactorEdit>(&edit.content))
            *curves = carriedOver(*curves, *material->table(control), control);
        for (const models::Model* model : missing) {
          carried.fits.push_back(fitting::fit(material->fitBase(control), *model, {}, control));
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
    warnAbout(fit);
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
