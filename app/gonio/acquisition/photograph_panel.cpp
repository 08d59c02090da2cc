// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/photograph_panel.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>
#include <cmath>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/acquisition/photograph_controls.h"
#include "app/gonio/acquisition/photograph_views.h"
#include "app/gonio/document/loaded_material.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/library/material_drag.h"
#include "widgets/panels/drop_overlay.h"

namespace gonio::app {

namespace {

constexpr int photographControlEms = 22;
const QString photographFolder = QStringLiteral("photographs");

/// The photographs and descriptions of a drag; empty if there are other files too.
QStringList photographsIn(const QMimeData* data) {
  const QStringList files = widgets::draggedFiles(data);
  const bool all = std::ranges::all_of(
      files, [](const QString& file) { return isPhotographFile(file) || isPhotographDescription(file); });
  return all ? files : QStringList();
}

}  // namespace

PhotographPanel::PhotographPanel(AcquisitionPanel& acquisition, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_acquisition(acquisition),
      m_session(
          tasks,
          [&acquisition] {
            const TrainingRows& rows = acquisition.controls().training();
            const QStringList ids = rows.training().ids;
            return PhotographTraining{
                ids, rows.materialClass(), acquisition.session().planner().learned(ids, rows.materialClass()), {}};
          }),
      m_controls(new PhotographControls(m_session)),
      m_views(new PhotographViews(m_session)),
      m_content(new QStackedWidget),
      m_start(new QPushButton),
      m_progress(new QProgressBar),
      m_status(new QLabel),
      m_overlay(new widgets::DropOverlay(this)) {
  setAcceptDrops(true);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(fontMetrics().height() / 2);
  m_start->setToolTip(tr("Reconstructs the material from all photographs; press again to stop"));
  layout->addWidget(controlColumn(*m_controls, *m_start, *m_progress, *m_status, photographControlEms));
  m_content->addWidget(buildEmpty());
  m_content->addWidget(m_views);
  layout->addWidget(m_content, 1);
  connectParts();
  refresh();
}

QSize PhotographPanel::sizeHint() const { return QSize(80, 24) * fontMetrics().height(); }

QWidget* PhotographPanel::buildEmpty() {
  auto* text =
      new QLabel(tr("Open or drop linear photographs of a sphere under known light to reconstruct its material."));
  text->setWordWrap(true);
  text->setAlignment(Qt::AlignCenter);
  text->setForegroundRole(QPalette::PlaceholderText);
  auto* open = new QPushButton(tr("Open &Photographs..."));
  open->setToolTip(tr("Opens EXR or Radiance HDR images, or a JSON description of photographs"));
  connect(open, &QPushButton::clicked, this, &PhotographPanel::askForFiles);
  auto* empty = new QWidget;
  auto* layout = new QVBoxLayout(empty);
  layout->addStretch();
  layout->addWidget(text);
  layout->addSpacing(fontMetrics().height() / 2);
  layout->addWidget(open, 0, Qt::AlignCenter);
  layout->addStretch();
  return empty;
}

void PhotographPanel::connectParts() {
  // After the views, which connected themselves before.
  for (const auto signal :
       {&PhotographSession::inputsChanged, &PhotographSession::resultChanged, &PhotographSession::progressed})
    connect(&m_session, signal, this, &PhotographPanel::refresh);
  connect(&m_session, &PhotographSession::inputsChanged, m_controls, &PhotographControls::refresh);
  connect(&m_session, &PhotographSession::exported, this, &PhotographPanel::exported);
  connect(&m_session, &PhotographSession::failed, this, &PhotographPanel::failed);
  connect(&m_acquisition.controls().training(), &TrainingRows::edited, this, &PhotographPanel::refresh);
  connect(m_controls, &PhotographControls::openRequested, this, &PhotographPanel::askForFiles);
  connect(m_controls, &PhotographControls::saveRequested, this, &PhotographPanel::askForDescription);
  connect(m_views, &PhotographViews::currentChanged, m_controls, &PhotographControls::setCurrent);
  connect(m_views, &PhotographViews::openRequested, this, &PhotographPanel::openResult);
  connect(m_start, &QPushButton::clicked, this, &PhotographPanel::start);
}

QString PhotographPanel::status() const { return m_status->text(); }

void PhotographPanel::start() {
  if (m_session.isBusy())
    m_session.cancel();
  else
    m_session.reconstruct();
}

void PhotographPanel::openResult() {
  if (m_session.result())
    m_acquisition.session().openTable(m_session.result()->table, m_session.resultName(), reconstructionFolder());
}

void PhotographPanel::askForFiles() {
  auto* dialog = new QFileDialog(this, tr("Open Photographs"), widgets::dialogFolder(photographFolder),
                                 tr("Photographs and descriptions (*.exr *.hdr *.json);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
    if (!files.isEmpty()) widgets::rememberDialogFolder(photographFolder, files.front());
    m_session.open(files);
  });
  dialog->open();
}

void PhotographPanel::present() {
  if (m_session.inputs().isEmpty() && !m_session.isBusy()) return askForFiles();
  m_start->setFocus();
}

void PhotographPanel::askForDescription() {
  widgets::askForPath(this, tr("Save Description"),
                      widgets::inDialogFolder(photographFolder, QStringLiteral("photographs.json")),
                      tr("Description (*.json)"), [this](const QString& path) {
                        widgets::rememberDialogFolder(photographFolder, path);
                        m_session.saveDescription(path);
                      });
}

QString PhotographPanel::statusText() const {
  using Step = PhotographSession::Step;
  switch (m_session.step()) {
    case Step::reading:
      return tr("Reading...");
    case Step::learning:
      return tr("Learning from the training set...");
    case Step::reconstructing:
      return tr("Reconstructing...");
    case Step::idle:
      break;
  }
  const PhotographInputs& inputs = m_session.inputs();
  if (inputs.isEmpty()) return tr("Open photographs to begin.");
  for (const PhotographItem& item : inputs.items())
    if (!item.isOutlineFound)
      return tr("No sphere was found in %1. Drag the circle onto its outline.").arg(item.name());
  if (!m_session.result())
    return std::ranges::any_of(inputs.items(), &PhotographItem::hasOutline)
               ? tr("Check outline, camera and light of each photograph, then press Reconstruct.")
               : tr("Check camera and light of each photograph, then press Reconstruct.");
  if (!m_session.isResultCurrent()) return tr("The input has changed. Press Reconstruct again.");
  return tr("Training set: %1", "of the Acquisition panel").arg(m_acquisition.controls().training().training().name);
}

void PhotographPanel::refresh() {
  const bool busy = m_session.isBusy(), empty = m_session.inputs().isEmpty();
  m_content->setCurrentIndex(empty ? 0 : 1);
  m_start->setText(busy ? tr("Cancel") : tr("Re&construct"));
  m_start->setEnabled(busy || !empty);
  m_progress->setVisible(busy);
  m_progress->setValue(int(std::lround(m_progress->maximum() * m_session.fraction())));
  m_status->setText(statusText());
  m_views->setState(m_acquisition.session().isOpening(), busy);
}

void PhotographPanel::dragEnterEvent(QDragEnterEvent* event) {
  const QStringList files = photographsIn(event->mimeData());
  if (files.isEmpty()) return event->ignore();
  m_overlay->announce(std::ranges::any_of(files, isPhotographDescription) ? tr("Open the description of photographs")
                      : files.size() == 1 ? tr("Add the photograph %1").arg(files.front().section('/', -1))
                                          : tr("Add %n photographs", nullptr, int(files.size())));
  event->acceptProposedAction();
}

void PhotographPanel::dragLeaveEvent(QDragLeaveEvent*) { m_overlay->hide(); }

void PhotographPanel::dropEvent(QDropEvent* event) {
  m_overlay->hide();
  m_session.open(photographsIn(event->mimeData()));
  event->acceptProposedAction();
}

}  // namespace gonio::app

#include "moc_photograph_panel.cpp"
