// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// How a session comes to its directions.
#include <QPointer>

#include "app/gonio/acquisition/acquisition_session.h"

namespace gonio::app {

bool AcquisitionSession::isReferenceLearned() const {
  return !m_referenceId.isEmpty() && without(m_learned, m_referenceId) != m_learned;
}

void AcquisitionSession::forgetPlan() {
  ++m_run;
  m_chosen.clear();
  m_selection = {};
  m_plan = {};
  m_values = {};
  m_simulated = true;
  forgetResult();
  Q_EMIT directionsChanged();
  Q_EMIT planChanged();
  Q_EMIT valuesChanged();
}

void AcquisitionSession::forgetResult() {
  m_result.reset();
  m_curve.clear();
  Q_EMIT resultChanged();
  Q_EMIT curveChanged();
}

std::vector<DirectionPair> AcquisitionSession::directions() const {
  std::vector<DirectionPair> pairs;
  for (const std::uint32_t cell : m_chosen) pairs.push_back(m_basis->mapping.grid.directions(cell));
  return pairs;
}

void AcquisitionSession::plan(const PlanSettings& settings, const acquisition::SamplingPlan& given) {
  PlanSettings taken = settings;
  taken.samples = int(given.samples.size());
  start(taken, given);
}

void AcquisitionSession::plan(const PlanSettings& settings) { start(settings, {}); }

void AcquisitionSession::start(const PlanSettings& settings, const std::optional<acquisition::SamplingPlan>& given) {
  m_tasks.drop(stepKey);
  forgetPlan();
  m_given = given;
  m_settings = settings;
  const QStringList ids =
      settings.leaveOutReference ? without(settings.training.ids, m_referenceId) : settings.training.ids;
  if (m_basis && ids == m_learned)
    choose();
  else
    learn(ids);
}

void AcquisitionSession::learn(const QStringList& ids) {
  using Basis = std::shared_ptr<const dictionary::PrincipalComponents>;
  // Gigabytes, of a large set: the old one goes before the new one comes.
  m_basis.reset();
  m_learned.clear();
  m_tasks.run<Basis>(
      {tr("Learning %n materials", nullptr, int(ids.size())), stepKey},
      [ids](const TaskControl& control) { return learnBasis(ids, control); },
      [this, ids](const Basis& basis) {
        m_basis = basis;
        m_learned = ids;
        choose();
      },
      failure(tr("Cannot learn the training set")), stopped());
  setStep(Step::learning);
}

void AcquisitionSession::takeGiven() {
  setStep(Step::idle);
  try {
    Planned planned{.selection = {}, .plan = *m_given};
    for (const acquisition::PlannedSample& sample : m_given->samples)
      planned.selection.cells.push_back(acquisition::nearestNode(m_basis->mapping.grid, sample.directions));
    installPlan(planned);
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot take the plan"), QString::fromUtf8(error.what()));
  }
}

void AcquisitionSession::installPlan(const Planned& planned) {
  m_chosen = planned.selection.cells;
  m_selection = planned.selection;
  m_plan = planned.plan;
  setStep(Step::idle);
  Q_EMIT directionsChanged();
  Q_EMIT planChanged();
  if (m_simulated) measureReference();
}

void AcquisitionSession::choose() {
  if (m_given) return takeGiven();
  acquisition::SelectionOptions options;
  options.method = m_settings.method;
  options.samples = m_settings.samples;
  options.measurable = m_settings.measurable;
  options.seed = m_settings.seed;
  const auto tell = [session = QPointer(this), tasks = &m_tasks, run = m_run](std::uint32_t cell) {
    QMetaObject::invokeMethod(
        tasks,
        [session, run, cell] {
          if (session) session->takeChosen(run, cell);
        },
        Qt::QueuedConnection);
  };
  m_tasks.run<Planned>(
      {tr("Choosing %n directions", nullptr, options.samples), stepKey},
      [basis = m_basis, options, tell](const TaskControl& control) {
        Planned planned;
        planned.selection = acquisition::selectSamples(*basis, options, control, tell);
        planned.plan = acquisition::planFor(basis->mapping.grid, planned.selection.cells);
        return planned;
      },
      [this](const Planned& planned) { installPlan(planned); }, failure(tr("Cannot choose directions")), stopped());
  setStep(Step::choosing);
}

void AcquisitionSession::takeChosen(int run, std::uint32_t cell) {
  if (run != m_run || m_step != Step::choosing) return;
  m_chosen.push_back(cell);
  Q_EMIT directionsChanged();
}

}  // namespace gonio::app
