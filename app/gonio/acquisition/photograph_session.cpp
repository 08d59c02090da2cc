// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/photograph_session.h"

#include <QFileInfo>
#include <QSaveFile>
#include <algorithm>

#include "app/gonio/acquisition/acquisition_planner.h"
#include "core/rendering/environment.h"
#include "core/study/learned_basis.h"

namespace gonio::app {

namespace {
/// The steps replace one another; the others run beside them.
const QString photographKey = QStringLiteral("photographs"), photographLightKey = QStringLiteral("photograph light"),
              photographOutlineKey = QStringLiteral("photograph outline"),
              photographSphereKey = QStringLiteral("photograph sphere");
constexpr int sphereSide = 224, sphereSamples = 64;
}  // namespace

PhotographSession::PhotographSession(BackgroundTasks& tasks, std::function<PhotographTraining()> training,
                                     QObject* parent)
    : QObject(parent),
      m_tasks(tasks),
      m_training(std::move(training)),
      m_picture{.width = sphereSide, .height = sphereSide, .samples = sphereSamples, .density = {}} {
  connect(&m_tasks, &BackgroundTasks::changed, this, &PhotographSession::progressed);
}

void PhotographSession::setStep(Step step) {
  m_step = step;
  Q_EMIT progressed();
}

double PhotographSession::fraction() const { return m_tasks.progress(photographKey).value_or(0); }

void PhotographSession::setQuality(std::size_t maxRegions, const rendering::RenderOptions& picture) {
  m_maxRegions = maxRegions;
  m_picture = picture;
}

std::function<void(const QString&)> PhotographSession::failure(const QString& title) {
  return [this, title](const QString& error) {
    setStep(Step::idle);
    Q_EMIT failed(title, error);
  };
}

void PhotographSession::cancel() {
  m_tasks.drop(photographKey);
  setStep(Step::idle);
}

// --- The inputs

void PhotographSession::changed() {
  ++m_revision;
  Q_EMIT inputsChanged();
}

void PhotographSession::install(PhotographInputs inputs) {
  m_tasks.drop(photographLightKey);
  m_tasks.drop(photographOutlineKey);
  m_inputs = std::move(inputs);
  changed();
}

void PhotographSession::open(const QStringList& paths) {
  if (paths.isEmpty()) return;
  const auto description = std::ranges::find_if(paths, isPhotographDescription);
  const QString name =
      paths.size() == 1 ? paths.front().section('/', -1) : tr("%n photographs", nullptr, int(paths.size()));
  const TaskRequest request{.title = tr("Reading %1").arg(name), .key = photographKey};
  const auto stopped = [this] { cancel(); };
  if (description != paths.end())
    m_tasks.run<PhotographInputs>(
        request, [path = *description](const TaskControl& control) { return readPhotographDescription(path, control); },
        [this](const PhotographInputs& inputs) {
          install(inputs);
          setStep(Step::idle);
        },
        failure(tr("Cannot open the description")), stopped);
  else
    m_tasks.run<std::vector<PhotographItem>>(
        request,
        [paths, like = m_inputs.isEmpty() ? nlohmann::json() : m_inputs.items().back().entry](
            const TaskControl& control) { return readPhotographs(paths, like, control); },
        [this](const std::vector<PhotographItem>& items) {
          m_inputs.add(items);
          changed();
          setStep(Step::idle);
        },
        failure(tr("Cannot open the photographs")), stopped);
  setStep(Step::reading);
}

void PhotographSession::remove(std::size_t index) {
  m_tasks.drop(photographLightKey);
  m_tasks.drop(photographOutlineKey);
  m_inputs.remove(index);
  if (m_inputs.isEmpty()) m_inputs = {};
  changed();
}

void PhotographSession::setDisc(std::size_t index, const matching::Disc& disc) {
  m_inputs[index].setDisc(disc);
  m_inputs[index].isOutlineFound = true;
  changed();
}

void PhotographSession::setCamera(std::size_t index, const PhotographCamera& camera) {
  m_inputs[index].setCamera(camera);
  changed();
}

void PhotographSession::setLight(std::size_t index, const PhotographLight& light) {
  const bool reads =
      light.kind == PhotographLight::Kind::environment && light.environment != m_inputs[index].light().environment;
  if (!reads) return changeLight(index, light);
  m_tasks.run<bool>(
      {.title = tr("Reading %1").arg(light.environment.section('/', -1)), .key = photographLightKey},
      [name = light.environment.toStdString()](const TaskControl&) {
        return rendering::openEnvironment(name) != nullptr;
      },
      [this, index, light](bool) { changeLight(index, light); },
      [this](const QString& error) {
        Q_EMIT inputsChanged();  // the controls show the light that remains
        Q_EMIT failed(tr("Cannot use the environment"), error);
      },
      [this] { Q_EMIT inputsChanged(); });
}

void PhotographSession::changeLight(std::size_t index, const PhotographLight& light) {
  m_inputs[index].setLight(light);
  changed();
}

void PhotographSession::useLightForAll(std::size_t index) {
  const nlohmann::json lights = m_inputs[index].entry["lights"];
  for (std::size_t i = 0; i < m_inputs.size(); ++i) m_inputs[i].entry["lights"] = lights;
  changed();
}

void PhotographSession::setExposureKnown(bool known) {
  m_inputs.setExposureKnown(known);
  changed();
}

void PhotographSession::findOutline(std::size_t index) {
  m_tasks.run<matching::Disc>(
      {.title = tr("Finding the outline in %1").arg(m_inputs[index].name()), .key = photographOutlineKey},
      [item = m_inputs[index]](const TaskControl&) { return app::findOutline(item); },
      [this, index](const matching::Disc& disc) { setDisc(index, disc); },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot find the outline"), error); });
}

void PhotographSession::saveDescription(const QString& path) {
  try {
    const std::string text = m_inputs.description(QFileInfo(path).absolutePath());
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), qint64(text.size())) != qint64(text.size()) ||
        !file.commit())
      throw Error(path.toStdString() + ": " + file.errorString().toStdString());
    Q_EMIT exported(path);
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot save the description"), QString::fromUtf8(error.what()));
  }
}

// --- The material

void PhotographSession::reconstruct() {
  if (m_inputs.isEmpty()) return;
  const PhotographTraining training = m_training();
  if (isLearned(training))
    fit();
  else
    learn(training);
}

bool PhotographSession::isLearned(const PhotographTraining& training) const {
  return m_learned.prior && m_learned.ids == training.ids && m_learned.materialClass == training.materialClass;
}

void PhotographSession::learn(const PhotographTraining& training) {
  m_learned = {};  // gigabytes, of a large set: the old one goes before the new one comes
  m_tasks.run<PhotographTraining>(
      {.title = tr("Learning from %n materials", nullptr, int(training.ids.size())),
       .key = photographKey,
       .isLong = true},
      [training](const TaskControl& control) {
        constexpr double learnedFraction = 0.95;
        PhotographTraining learned = training;
        if (!learned.basis)
          learned.basis = learnLibraryComponents(training.ids, study::defaultBasisComponents, training.materialClass,
                                                 control.between(0, learnedFraction));
        control.throwIfStopped();
        learned.prior =
            std::make_shared<const photograph::PhotographPrior>(photograph::photographPrior(*learned.basis));
        return learned;
      },
      [this](const PhotographTraining& learned) {
        m_learned = learned;
        fit();
      },
      failure(tr("Cannot learn from the training set")), [this] { cancel(); });
  setStep(Step::learning);
}

void PhotographSession::fit() {
  m_tasks.run<PhotographResultPtr>(
      {.title = tr("Reconstructing from photographs"), .key = photographKey, .isLong = true},
      [training = m_learned, inputs = m_inputs, regions = m_maxRegions, picture = m_picture](
          const TaskControl& control) { return reconstructPhotographs(training, inputs, regions, picture, control); },
      [this, revision = m_revision](const PhotographResultPtr& result) {
        m_result = result;
        m_resultRevision = revision;
        m_otherSphere = {};
        setStep(Step::idle);
        Q_EMIT resultChanged();
        renderOther();
      },
      failure(tr("Cannot reconstruct the material")), [this] { cancel(); });
  setStep(Step::reconstructing);
}

std::optional<std::size_t> PhotographSession::placeInResult(std::size_t index) const {
  if (!m_result) return std::nullopt;
  const auto found = std::ranges::find(m_result->paths, m_inputs[index].path());
  if (found == m_result->paths.end()) return std::nullopt;
  return std::size_t(found - m_result->paths.begin());
}

QString PhotographSession::resultName() const {
  if (!m_result) return {};
  const QString first = QFileInfo(m_result->paths.front()).completeBaseName();
  const int count = int(m_result->paths.size());
  return count == 1 ? tr("%1 from one photograph").arg(first) : tr("%1 from %n photographs", nullptr, count).arg(first);
}

void PhotographSession::setOtherLight(const QString& environment) {
  m_otherLight = environment;
  renderOther();
}

void PhotographSession::renderOther() {
  m_tasks.drop(photographSphereKey);
  if (!m_result) return;
  m_tasks.run<QImage>(
      {.title = tr("Rendering the reconstruction"), .key = photographSphereKey, .live = true},
      [table = m_result->table, light = m_otherLight.toStdString(), picture = m_picture](const TaskControl& control) {
        return sphereUnder(*table, light, picture, control);
      },
      [this](const QImage& picture) {
        m_otherSphere = picture;
        Q_EMIT otherSphereChanged();
      });
}

}  // namespace gonio::app

#include "moc_photograph_session.cpp"
