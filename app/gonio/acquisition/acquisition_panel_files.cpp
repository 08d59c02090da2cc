// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// The plans and values that the Acquisition panel reads and writes.
#include <QComboBox>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "core/materials/plan_file.h"
#include "core/materials/values_file.h"

namespace gonio::app {

QStringList AcquisitionPanel::planComments() const {
  const PlanSettings& settings = m_session.settings();
  return {tr("Plan of %n samples, %1", nullptr, int(m_session.samplingPlan().samples.size()))
              .arg(m_controls->methodBox().itemText(int(settings.method))),
          tr("learned from %n materials (%1)", nullptr, m_session.learnedMaterials()).arg(settings.training.name)};
}

QString AcquisitionPanel::planText() const {
  std::vector<std::string> comments;
  for (const QString& comment : planComments()) comments.push_back(comment.toStdString());
  return QString::fromStdString(materials::planCsv(m_session.samplingPlan(), comments));
}

void AcquisitionPanel::savePlan(const QString& path) {
  std::vector<std::string> comments;
  for (const QString& comment : planComments()) comments.push_back(comment.toStdString());
  try {
    materials::writePlan(m_session.samplingPlan(), path.toStdString(), comments);
    Q_EMIT exported(path);
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot save the plan"), QString::fromUtf8(error.what()));
  }
}

void AcquisitionPanel::readPlan(const QString& path) {
  try {
    const acquisition::SamplingPlan plan = materials::readPlan(path.toStdString());
    takeOpenMaterial();
    m_controls->setSamples(int(plan.samples.size()));
    m_session.plan(m_controls->planSettings(), plan);
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot open the plan"), QString::fromUtf8(error.what()));
  }
}

void AcquisitionPanel::paste(const QString& text) {
  try {
    if (text.trimmed().isEmpty()) throw Error(tr("There is no text on the clipboard.").toStdString());
    m_session.setValues(materials::parseValues(text.toStdString(), m_session.samplingPlan()), tr("pasted"));
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot take the values"), QString::fromUtf8(error.what()));
  }
}

void AcquisitionPanel::readValues(const QString& path) {
  try {
    m_session.setValues(materials::readValues(path.toStdString(), m_session.samplingPlan()), path.section('/', -1));
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot take the values"), QString::fromUtf8(error.what()));
  }
}

}  // namespace gonio::app
