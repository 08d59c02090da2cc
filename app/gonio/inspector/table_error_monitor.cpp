// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/table_error_monitor.h"

#include "core/rendering/rendered_comparison.h"

namespace gonio::app {

namespace {
const QString tableErrorKey = QStringLiteral("table error");
}  // namespace

TableErrorMonitor::TableErrorMonitor(Document& document, BackgroundTasks& tasks, QObject* parent,
                                     const RenderOptions& picture)
    : QObject(parent), m_document(document), m_tasks(tasks), m_picture(picture) {
  connect(&document, &Document::materialChanged, this, &TableErrorMonitor::measure);
}

void TableErrorMonitor::measure() {
  m_tasks.drop(tableErrorKey);
  m_snr.reset();
  const LoadedMaterialPtr material = m_document.material();
  m_measuring = material && (material->isSampled() || !material->isTable());
  if (!m_measuring) return;
  m_tasks.run<double>(
      {tr("Measuring table accuracy of %1").arg(m_document.name()), tableErrorKey, true},
      [material, picture = m_picture](const TaskControl& control) {
        const RenderedComparison comparison(*material->material.brdf, picture, control.between(0, 0.5));
        return comparison.signalToNoiseRatio(comparison.render(*material->table(control), control.between(0.5, 1)));
      },
      [this](double snr) { finish(snr); }, [this](const QString&) { finish({}); }, [this] { finish({}); });
}

void TableErrorMonitor::finish(std::optional<double> snr) {
  m_snr = snr;
  m_measuring = false;
  Q_EMIT measured();
}

}  // namespace gonio::app

#include "moc_table_error_monitor.cpp"
