// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/prepared_view.h"

#include <QCheckBox>
#include <QTimer>
#include <algorithm>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/factors/factor_curves_panel.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/inspector/representation_panel.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/plots/plots_panel.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/study/fit_ranking_panel.h"
#include "app/gonio/study/study_panel.h"
#include "app/gonio/window/dock_layout.h"
#include "app/gonio/window/editor_parts.h"
#include "widgets/curves/curve_editor.h"

namespace gonio::app {
namespace {

/// Edits the factor curves as soon as they are known.
void editFactors(FactorCurvesPanel& factors, const PreparedView& view) {
  constexpr int checkMilliseconds = 100;
  auto* timer = new QTimer(&factors);
  QObject::connect(timer, &QTimer::timeout, &factors, [&factors, timer, view] {
    if (factors.column(FactorAxis::deviation).editor().nodes().empty()) return;
    timer->stop();
    if (view.widen > 0) factors.widen(view.widen);
    if (!view.withF1Of.isEmpty()) factors.replaceCurve(FactorAxis::theta, view.withF1Of);
  });
  timer->start(checkMilliseconds);
}

/// Measures the representations of the material that is opened, and shows one of them.
void measureRepresentations(const EditorParts& parts, const QString& label) {
  StudyPanel& study = parts.study;
  QObject::connect(&parts.document, &Document::materialChanged, &study, &StudyPanel::measure, Qt::QueuedConnection);
  QObject::connect(&study.model(), &StudyModel::dataChanged, &study, [&study, label](const QModelIndex& index) {
    const int row = index.row();
    const bool isIt = study.model().representation(row).fullLabel() == label.toStdString();
    if (isIt && study.model().studied(row) && study.shownName() != label) study.show(row);
  });
}

/// Acquires the material that is opened, and shows a page of the panel then.
void acquire(const EditorParts& parts, int samples, int page) {
  AcquisitionPanel& panel = parts.acquisition;
  panel.controls().directions().setSamples(samples);
  QObject::connect(&parts.document, &Document::materialChanged, &panel, &AcquisitionPanel::start,
                   Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
  QObject::connect(
      &panel.session(), &AcquisitionSession::resultChanged, &panel,
      [&panel, page] { panel.pages().setCurrentIndex(page); }, Qt::QueuedConnection);
}

/// Shows the Interpolation dock's blend of materials, also when the material that is opened comes later than these.
void interpolate(const EditorParts& parts, const QStringList& blended) {
  InterpolationPanel& interpolation = parts.interpolation;
  QObject::connect(
      &parts.document, &Document::materialChanged, &interpolation,
      [&interpolation] { interpolation.setShownInPreview(true); }, Qt::QueuedConnection);
  for (qsizetype i = 0; i < blended.size(); ++i) {
    if (i >= interpolation.materials().count()) interpolation.materials().addSlot();
    interpolation.materials().read(int(i), blended[i]);
  }
}

/// Ranks the fits of the material that is opened, once it and its first fit are there.
void rankFits(const EditorParts& parts) {
  QObject::connect(
      &parts.document, &Document::stateChanged, &parts.ranking,
      [&document = parts.document, &ranking = parts.ranking] {
        if (document.active<gonio::editing::DifferentialEdit>() && ranking.model().rowCount() == 0 &&
            !ranking.isRunning())
          ranking.fitAll();
      },
      Qt::QueuedConnection);
}

}  // namespace

void prepare(EditorParts& parts, DockLayout& docks, const PreparedView& view) {
  if (!view.plot.isEmpty()) parts.plots.showKind(view.plot);
  const QStringList modes{"off", "split", "flicker", "difference", "two-up"};
  if (modes.contains(view.compare))
    parts.comparison.setComparison({.mode = gonio::widgets::CompareMode(modes.indexOf(view.compare))});
  if (view.factors) docks.show(QStringLiteral("factors"));
  if (!view.scene.isEmpty()) {
    docks.show(QStringLiteral("scene"));
    parts.scene.open(view.scene);
    for (int slot = 0; slot < std::min(int(view.otherSlots.size()), SceneMaterialSlots::count); ++slot)
      parts.scene.otherSlots().read(slot, view.otherSlots[slot]);
  }
  if (view.encoded > 0) {
    parts.inspector.unfoldRepresentation();
    parts.inspector.representation()->setCoefficients(view.encoded);
    parts.inspector.representation()->showEncoded().setChecked(true);
  }
  if (view.widen > 0 || !view.withF1Of.isEmpty()) editFactors(parts.factors, view);
  if (!view.blended.isEmpty()) {
    docks.show(QStringLiteral("interpolation"));
    interpolate(parts, view.blended);
  }
  if (view.acquired > 0) {
    docks.showWorkspace(DockLayout::Workspace::acquire);
    acquire(parts, view.acquired, view.acquisitionPage);
  }
  if (!view.study.isEmpty()) {
    docks.show(QStringLiteral("study"));
    measureRepresentations(parts, view.study);
  }
  if (view.models) {
    docks.show(QStringLiteral("models"));
    rankFits(parts);
  }
}

}  // namespace gonio::app
