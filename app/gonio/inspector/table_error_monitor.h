// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <optional>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "core/rendering/render_picture.h"

namespace gonio::app {

/// What the sampling of the document's material onto the table for editing costs: rendered SNR of the table against the
/// material in its own form. Measured once a material, in the background.
class TableErrorMonitor : public QObject {
  Q_OBJECT

 public:
  /// @param picture in which it is measured: that of every comparison.
  TableErrorMonitor(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr,
                    const RenderOptions& picture = {});
  /// dB, in comparisonScene(); nothing before it is measured, and where the material is a table itself.
  std::optional<double> snr() const { return m_snr; }
  /// Whether nothing is being measured.
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
