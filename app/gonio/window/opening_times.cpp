// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/opening_times.h"

#include <QCoreApplication>
#include <QTimer>
#include <cstdio>

#include "app/gonio/window/editor_parts.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {
constexpr int pauseMilliseconds = 1000;
}  // namespace

OpeningTimes::OpeningTimes(EditorParts& parts, const QStringList& paths, QObject* parent)
    : QObject(parent), m_parts(parts), m_paths(paths) {
  connect(&parts.document, &Document::materialChanged, this, &OpeningTimes::adoptMaterial);
  connect(&parts.preview, &widgets::PreviewWidget::frameRendered, this, &OpeningTimes::adoptPicture);
  connect(&parts.controller, &DocumentController::failed, this, [](const QString&, const QString& text) {
    std::fprintf(stderr, "gonio: %s\n", qPrintable(text));
    QCoreApplication::exit(1);
  });
  QTimer::singleShot(pauseMilliseconds, this, &OpeningTimes::openNext);
}

void OpeningTimes::openNext() {
  if (m_paths.isEmpty()) return QCoreApplication::exit(0);
  m_read = -1;
  m_before = m_parts.preview.lastRequest();
  m_elapsed.start();
  m_parts.controller.open(m_paths.front());
}

void OpeningTimes::adoptMaterial() {
  if (m_elapsed.isValid()) m_read = m_elapsed.elapsed();
}

void OpeningTimes::adoptPicture() {
  if (m_read < 0 || m_parts.preview.shownRequest() <= m_before) return;
  std::printf("%s: read after %lld ms, first image after %lld ms\n", qPrintable(m_paths.takeFirst()),
              static_cast<long long>(m_read), static_cast<long long>(m_elapsed.elapsed()));
  std::fflush(stdout);
  m_read = -1;
  m_elapsed.invalidate();
  // The automatic fit of this material shall not slow the next one down.
  auto* wait = new QTimer(this);
  connect(wait, &QTimer::timeout, this, [this, wait] {
    if (!m_parts.tasks.isIdle()) return;
    wait->deleteLater();
    QTimer::singleShot(pauseMilliseconds, this, &OpeningTimes::openNext);
  });
  wait->start(pauseMilliseconds);
}

}  // namespace gonio::app

#include "moc_opening_times.cpp"
