// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_status.h"

#include <QCoreApplication>

namespace gonio::app {

namespace {
struct AcquisitionStatusText {
  Q_DECLARE_TR_FUNCTIONS(AcquisitionStatus)
};
}  // namespace

bool startCancels(const AcquisitionSession& session, const AcquisitionControls& controls) {
  const AcquisitionPlanner& planner = session.planner();
  return session.isBusy() && (!planner.hasPlan() || planner.settings() == controls.planSettings());
}

QString acquisitionStatus(const AcquisitionSession& session, const AcquisitionControls& controls) {
  const AcquisitionPlanner& planner = session.planner();
  using Text = AcquisitionStatusText;
  using Step = AcquisitionSession::Step;
  switch (session.step()) {
    case Step::learning:
      return Text::tr("Learning from the training set...");
    case Step::choosing:
      return Text::tr("Choosing directions: %1 of %2").arg(planner.directions().size()).arg(planner.settings().samples);
    case Step::reconstructing:
      return Text::tr("Reconstructing...");
    case Step::measuringCurve:
      return Text::tr("Computing the error curve...");
    case Step::idle:
      break;
  }
  if (!planner.hasPlan()) return Text::tr("Press Start to choose directions.");
  if (planner.settings() != controls.planSettings()) return Text::tr("The settings have changed. Press Start again.");
  if (!planner.selection().warning.empty()) return QString::fromStdString(planner.selection().warning);
  if (session.referenceReader().isReading()) return Text::tr("Preparing %1...").arg(session.referenceReader().name());
  if (session.values().rgb.empty()) return Text::tr("Save the plan, measure, then paste or open the values.");
  if (session.isReferenceLearned() && session.result())
    return Text::tr(
               "%1 is in the training set, so the error is lower than for a new material. To exclude it, tick "
               "\"Exclude the measured material\" and press Start.")
        .arg(session.referenceReader().name());
  if (!session.result()) return Text::tr("Stopped before the material was reconstructed. Press Start to try again.");
  return Text::tr("Values: %1").arg(session.valuesName());
}

}  // namespace gonio::app
