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
#include "core/study/accuracy_study.h"

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

/// What the accuracy of the fit and of the edits costs: error, bytes, time of an evaluation and of a frame, as in a
/// study. Measured in the background when the edits rest.
class CostMonitor : public QObject {
  Q_OBJECT

 public:
  /// What belongs to the state of the document; numbers that are not measured yet are empty.
  struct Costs {
    std::optional<double> fitSnr;                    ///< rendered SNR of the fit of the active edit, dB
    std::size_t fitBytes = 0;                        ///< its parameters; 0: there is no fit
    std::optional<study::UseCost> measured, edited;  ///< of the measurement, and with the edits
  };

  CostMonitor(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr);
  const Costs& costs() const { return m_costs; }

 Q_SIGNALS:
  /// Numbers were measured or became outdated.
  void changed();

 private:
  void materialChanged();
  void editsChanged();
  void selectionChanged();
  /// Takes the fit of the active edit. @return whether it is another one.
  bool adoptFit();
  void restart();
  void measure();

  Document& m_document;
  BackgroundTasks& m_tasks;
  QTimer m_delay;
  Costs m_costs;
  std::optional<models::ParameterValues> m_fitted;  ///< the fit that Costs::fitSnr belongs to
  const models::Model* m_fittedModel = nullptr;
};

}  // namespace gonio::app
