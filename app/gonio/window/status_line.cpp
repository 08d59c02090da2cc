// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/status_line.h"

#include <QLabel>
#include <QStatusBar>

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/document/edit_steps.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/panels/elided_label.h"
#include "widgets/panels/progress_strip.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {
constexpr int noticeMilliseconds = 8000;
}

StatusLine::StatusLine(QStatusBar& bar, const Document& document, BackgroundTasks& tasks,
                       const ComparisonController& comparison, const widgets::PreviewWidget& preview)
    : QObject(&bar),
      m_document(document),
      m_tasks(tasks),
      m_comparison(comparison),
      m_preview(preview),
      m_progress(new widgets::ProgressStrip) {
  // The bar of progress comes and goes: a status bar that grows with it would resize the preview, which starts anew.
  bar.setMinimumHeight(2 * bar.fontMetrics().height());
  m_progress->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar.addWidget(m_progress, 1);
  connect(&m_tasks, &BackgroundTasks::changed, this, &StatusLine::showProgress);
  connect(m_progress, &widgets::ProgressStrip::cancelRequested, &m_tasks, &BackgroundTasks::cancelTopmost);
  connect(m_progress, &widgets::ProgressStrip::pauseRequested, &m_tasks, [this](bool pause) {
    if (const auto task = m_tasks.topmost()) m_tasks.setPaused(task->id, pause);
  });
  connect(m_progress, &widgets::ProgressStrip::entryCancelRequested, &m_tasks, [this](int id) { m_tasks.cancel(id); });
  QLabel* representation =
      addPermanent(bar, tr("What the preview shows. Native form: evaluated as stored, not resampled to a table."));
  const auto showRepresentation = [this, representation, explanation = representation->toolTip()] {
    const QString text = representationText(), toolTip = text + '\n' + formText() + explanation;
    if (toolTip == representation->toolTip()) return;
    representation->setText(text);
    representation->setToolTip(toolTip);
  };
  for (const auto signal : {&ComparisonController::subjectsChanged, &ComparisonController::comparisonChanged})
    connect(&m_comparison, signal, this, showRepresentation);
  showRepresentation();
  QLabel* samples = addPermanent(bar, tr("Samples per pixel so far"), widgets::samplesText(9999));
  QLabel* frameTime = addPermanent(bar, tr("Time of the last frame"), tr("%1 ms").arg(QStringLiteral("9999.9")));
  connect(&m_preview, &widgets::PreviewWidget::frameRendered, this,
          [samples, frameTime](double milliseconds, int count) {
            frameTime->setText(tr("%1 ms").arg(milliseconds, 0, 'f', 1));
            samples->setText(widgets::samplesText(count));
          });
}

/// @param widest a text for which there is always room, however long the others are; empty: none
QLabel* StatusLine::addPermanent(QStatusBar& bar, const QString& toolTip, const QString& widest) {
  auto* label = new widgets::ElidedLabel;
  label->setToolTip(toolTip);
  constexpr int margin = 8;
  label->setContentsMargins(margin, 0, margin, 0);
  if (!widest.isEmpty()) label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + 2 * margin);
  bar.addPermanentWidget(label);
  return label;
}

void StatusLine::showProgress() {
  if (const auto task = m_tasks.topmost())
    m_progress->showProgress(task->title, task->fraction, !task->quiet,
                             !task->canPause ? widgets::ProgressStrip::Pausing::no
                             : task->paused  ? widgets::ProgressStrip::Pausing::paused
                                             : widgets::ProgressStrip::Pausing::running);
  else
    m_progress->clear();
  std::vector<widgets::ProgressStrip::Entry> entries;
  for (const BackgroundTasks::Info& task : m_tasks.shown())
    entries.push_back({task.id, task.waiting
                                    ? tr("%1, waiting").arg(task.title)
                                    : tr("%1, %2 %").arg(task.title, QString::number(100 * task.fraction, 'f', 0))});
  m_progress->setEntries(entries);
}

void StatusLine::showNotice(const QString& text) { m_progress->showNotice(text, noticeMilliseconds); }

/// How the open material is evaluated, as a line of a tooltip.
QString StatusLine::formText() const {
  const LoadedMaterialPtr& material = m_document.material();
  if (!material || m_comparison.standIn()) return {};
  return (material->isTable() ? tr("%1 table") : tr("%1, native form"))
             .arg(QString::fromStdString(material->material.source.format)) +
         '\n';
}

QString StatusLine::representationText() const {
  const LoadedMaterialPtr& material = m_document.material();
  const auto standIn = m_comparison.standIn();
  if (!material && !standIn) return tr("Nothing open");
  if (m_preview.content().isComparing()) {
    const auto sides = m_comparison.sides();
    return tr("%1 | %2").arg(m_comparison.name(sides[0]), m_comparison.name(sides[1]));
  }
  if (standIn == StandIn::blend) return tr("Blend: %1").arg(widgets::spacedName(m_comparison.standInName()));
  if (standIn) return tr("Showing %1 instead of the material; edits hidden").arg(m_comparison.standInName());
  const MaterialCode* code = m_comparison.code();
  QStringList parts{code ? tr("Code of %1 coefficients").arg(code->encoded.code.coefficients()) : tr("Original")};
  const editing::EditList& edits = m_document.edits();
  for (int i = 0; i < int(edits.size()); ++i)
    if (!edits[std::size_t(i)].isIdentity()) parts << editName(edits, i);
  return parts.join(QStringLiteral(" + "));
}

}  // namespace gonio::app

#include "moc_status_line.cpp"
