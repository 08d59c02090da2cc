// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "core/editing/edit_plausibility.h"
#include "core/rendering/render_picture.h"

namespace gonio::widgets {
class PlausibilityBadges;
}

namespace gonio::app {

/// Checks the edited material after each change and measures its energy before and after each edit, in the background.
/// Only the newest state is processed.
class PlausibilityMonitor : public QObject {
  Q_OBJECT

 public:
  PlausibilityMonitor(Document& document, BackgroundTasks& tasks, widgets::PlausibilityBadges& badges,
                      QObject* parent = nullptr);
  /// Whether the badges and the energies belong to the current state.
  bool isCurrent() const { return m_current; }
  /// The energies before the first edit and after each edit; empty while they are outdated.
  const std::vector<editing::Energy>& energies() const { return m_energies; }

 Q_SIGNALS:
  /// The energies became available or outdated.
  void energiesChanged();

 private:
  void changed();
  void check();

  Document& m_document;
  BackgroundTasks& m_tasks;
  widgets::PlausibilityBadges& m_badges;
  QTimer m_delay;
  bool m_current = true;
  std::vector<editing::Energy> m_energies;
};

/// Error of the table sampled from the document's material for editing: rendered SNR of the table compared with the
/// native form. Measured in the background, once per material.
class TableErrorMonitor : public QObject {
  Q_OBJECT

 public:
  /// @param picture size and samples of the comparison pictures.
  TableErrorMonitor(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr,
                    const rendering::RenderOptions& picture = {});
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
  rendering::RenderOptions m_picture;
  std::optional<double> m_snr;
  bool m_measuring = false;
};

}  // namespace gonio::app
