// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/matching/match_controller.h"

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document_controller.h"
#include "core/editing/edit_list.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {
const QString openImageKey = QStringLiteral("reference image"), matchKey = QStringLiteral("match");
}

MatchController::MatchController(Document& document, DocumentController& controller, BackgroundTasks& tasks,
                                 ComparisonController& comparison, widgets::PreviewWidget& preview)
    : QObject(&comparison),
      m_document(document),
      m_controller(controller),
      m_tasks(tasks),
      m_comparison(comparison),
      m_preview(preview) {
  for (const auto signal : {&Document::materialChanged, &Document::stateChanged, &Document::editChanged})
    connect(&document, signal, this, &MatchController::documentChanged);
  connect(&document, &Document::selectionChanged, this, &MatchController::changed);
  connect(&tasks, &BackgroundTasks::changed, this, [this] {
    if (m_waiting && !m_controller.isFitting() && !m_document.active<editing::DifferentialEdit>()) end();
    if (m_matching) Q_EMIT progressed();
  });
}

void MatchController::open(const QString& path) {
  m_tasks.run<ReferenceImage>(
      {tr("Reading the image %1").arg(path.section('/', -1)), openImageKey},
      [path](const TaskControl&) { return readReferenceImage(path); },
      [this](const ReferenceImage& image) {
        cancel();
        leave();
        m_image = image;
        m_tones = image.isRadiance && m_tones == ImageTones::filmic ? ImageTones::clamp : m_tones;
        Q_EMIT changed();
      },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot read the reference image"), error); });
}

void MatchController::remove() {
  m_tasks.drop(openImageKey);
  cancel();
  leave();
  m_image.reset();
  Q_EMIT changed();
}

void MatchController::setDisc(const matching::Disc& disc) {
  if (!m_image) return;
  m_image->disc = disc;
  Q_EMIT changed();
}

void MatchController::setTones(ImageTones tones) {
  m_tones = tones;
  Q_EMIT changed();
}

bool MatchController::canMatch() const { return m_image && m_document.material() && !m_matching; }

void MatchController::match() {
  if (!canMatch()) return;
  leave();
  m_matching = true;
  m_waiting = !m_document.active<editing::DifferentialEdit>();
  if (m_waiting)
    m_controller.addModelEdit();
  else
    start();
  Q_EMIT changed();
}

void MatchController::start() {
  const int active = activeIndex<editing::DifferentialEdit>(m_document.state());
  const matching::MatchedMaterial material{m_document.base(), m_document.edits(), std::size_t(active)};
  m_tasks.run<matching::ControlMatch>(
      {tr("Matching %1").arg(m_image->name()), matchKey},
      [image = *m_image, tones = m_tones, exposure = m_preview.display().exposure, material,
       scene = m_preview.content().scene()](const TaskControl& control) {
        return matching::matchControls(image.picture(tones, exposure), material, scene,
                                       {.freeExposure = tones == ImageTones::photograph}, control);
      },
      [this, edits = material.edits, index = material.index](const matching::ControlMatch& match) {
        end();
        show(match, edits, index);
      },
      [this](const QString& error) {
        end();
        Q_EMIT failed(tr("Cannot match the reference image"), error);
      },
      [this] { end(); });
}

void MatchController::end() {
  m_matching = m_waiting = false;
  Q_EMIT changed();
}

void MatchController::cancel() {
  if (!m_matching) return;
  m_tasks.drop(matchKey);
  end();
}

double MatchController::progress() const { return m_tasks.progress(matchKey).value_or(0); }

void MatchController::show(const matching::ControlMatch& match, editing::EditList edits, std::size_t index) {
  editing::Edit& edit = edits[index];
  edit.enabled = true;
  std::get<editing::DifferentialEdit>(edit.content).controls = match.controls;
  m_proposal = {match, std::move(edits), index};
  m_comparison.setStandIn(StandIn::match,
                          widgets::PreviewSubject{widgets::EditedMaterial{m_document.base(), m_proposal->edits},
                                                  m_document.material()->density},
                          tr("the match with %1").arg(m_image->name()));
  Q_EMIT changed();
  Q_EMIT proposed();
}

void MatchController::take() {
  if (!m_proposal) return;
  const Proposal taken = *m_proposal;
  leave();
  m_document.installEdits(taken.edits, tr("Match reference image"), int(taken.index));
}

void MatchController::leave() {
  if (!m_proposal) return;
  m_proposal.reset();
  m_comparison.setStandIn(StandIn::match, std::nullopt, {});
  Q_EMIT changed();
}

void MatchController::documentChanged() {
  leave();
  if (m_waiting && m_document.active<editing::DifferentialEdit>()) {
    m_waiting = false;
    return start();
  }
  if (m_matching && !m_waiting) return cancel();
  Q_EMIT changed();
}

}  // namespace gonio::app

#include "moc_match_controller.cpp"
