// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/reference_reader.h"

namespace gonio::app {

namespace {
const QString referenceKey = QStringLiteral("acquisition reference");
/// Of the progress: making a table, then rendering its picture.
constexpr double tableFraction = 0.4;
}  // namespace

ReferenceReader::ReferenceReader(BackgroundTasks& tasks, QObject* parent) : QObject(parent), m_tasks(tasks) {}

bool ReferenceReader::isReading() const { return m_tasks.isRunning(referenceKey); }

void ReferenceReader::read(const QString& id) {
  m_id = id;
  m_name = id.section('/', -1);
  start(
      [id, picture = m_picture](const TaskControl& control) { return readAcquisitionReference(id, picture, control); });
}

void ReferenceReader::read(const QString& id, const QString& name, TableFactory makeTable) {
  m_id = id;
  m_name = name;
  start([id, name, make = std::move(makeTable), picture = m_picture](const TaskControl& control) {
    return acquisitionReference(id, name, make(control.between(0, tableFraction)), picture,
                                control.between(tableFraction, 1));
  });
}

void ReferenceReader::start(std::function<AcquisitionReferencePtr(const TaskControl&)> make) {
  m_reference.reset();
  m_tasks.run<AcquisitionReferencePtr>(
      {tr("Preparing %1").arg(m_name), referenceKey}, std::move(make),
      [this](const AcquisitionReferencePtr& reference) { finish(reference); },
      [this](const QString& error) {
        const QString name = m_name;
        clear();
        Q_EMIT failed(tr("Cannot measure %1").arg(name), error);
      },
      [this] { clear(); });
  Q_EMIT changed();
}

void ReferenceReader::clear() {
  m_tasks.drop(referenceKey);
  m_id.clear();
  m_name.clear();
  finish(nullptr);
}

void ReferenceReader::finish(const AcquisitionReferencePtr& reference) {
  m_reference = reference;
  if (reference) m_name = reference->name;
  Q_EMIT changed();
  Q_EMIT finished();
}

}  // namespace gonio::app

#include "moc_reference_reader.cpp"
