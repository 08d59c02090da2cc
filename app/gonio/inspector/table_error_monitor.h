// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <optional>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "core/rendering/render_picture.h"

namespace gonio::app {

/// Error of the table sampled from the document's material for editing: rendered SNR of the table compared with the
/// native form. Measured in the background, once per material.
class TableErrorMonitor : public QObject {
  Q_OBJECT

 public:
  /// @param picture size and samples of the comparison pictures.
  TableErrorMonitor(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr,
                    const RenderOptions& picture = {});
  /// dB, in comparisonScene(); nullopt until it is measured, and if the material itself is a table.
  std::optional<double> snr() const { return m_snr; }
  /// Whether no measurement is running.
  bool isSettled() const { return !m_measuring; }

 Q_SIGNALS:
  /// A measurement ended.
  void measured();

 private:
  void measure();
  void finish(std::optional<double> snr);

  Document& m_document;
  BackgroundTasks& m_tasks;
  RenderOptions m_picture;
  std::optional<double> m_snr;
  bool m_measuring = false;
};

}  // namespace gonio::app
