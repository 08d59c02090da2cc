// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/reconstruction_page.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/gonio/acquisition/acquisition_status.h"
#include "widgets/acquisition/reconstruction_view.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

ReconstructionPage::ReconstructionPage(const AcquisitionSession& session, const AcquisitionControls& controls)
    : m_session(session),
      m_controls(controls),
      m_view(new widgets::ReconstructionView),
      m_numbers(new QLabel),
      m_open(new QPushButton(tr("Open as Mater&ial"))) {
  m_numbers->setWordWrap(true);
  m_numbers->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_open->setToolTip(
      tr("Opens the reconstruction as a material that can be edited, saved and exported.\nIts table is stored in "
         "Gonio's data folder. Undo restores the previous material."));
  auto* row = new QHBoxLayout;
  row->addWidget(m_numbers, 1);
  row->addWidget(m_open, 0, Qt::AlignTop);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->addWidget(m_view, 1);
  layout->addLayout(row);
  connect(m_open, &QPushButton::clicked, this, &ReconstructionPage::openRequested);
  connect(&m_session.referenceReader(), &ReferenceReader::changed, this, &ReconstructionPage::showResult);
  connect(&m_session, &AcquisitionSession::resultChanged, this, &ReconstructionPage::showResult);
  showResult();
}

QString ReconstructionPage::numbers() const { return m_numbers->text(); }

void ReconstructionPage::showResult() {
  widgets::ReconstructionView::Content content;
  if (const AcquisitionReferencePtr& reference = m_session.referenceReader().reference()) {
    content.reference = reference->picture;
    content.referenceName = reference->name;
  }
  QStringList facts;
  if (const AcquisitionResultPtr& result = m_session.result()) {
    content.reconstruction = result->picture;
    content.errorMap = result->errorMap;
    content.errorRange = result->errorRange;
    if (result->error)
      facts << tr("rendered SNR %1 dB").arg(result->error->renderedSnr, 0, 'f', 1)
            << tr("log error %1").arg(widgets::formatNumber(result->error->logError));
    const acquisition::Reconstruction& made = *result->reconstruction;
    facts << tr("components: %n", nullptr, made.components);
    if (made.ridge > 0) facts << tr("η = %1").arg(widgets::formatNumber(made.ridge));
    if (std::isfinite(made.leaveOneOutError))
      facts << tr("leave-one-out error of a mapped value: %1").arg(widgets::formatNumber(made.leaveOneOutError));
  }
  m_numbers->setText(facts.join(QStringLiteral(" · ")));
  m_view->setContent(content);
}

void ReconstructionPage::refresh() {
  m_open->setEnabled(m_session.result() && !m_session.isOpening());
  m_view->setHint(!m_session.planner().hasPlan()
                      ? tr("Press Start to choose directions and to reconstruct the material from its values there.")
                  : m_session.isBusy()             ? tr("Working...")
                  : m_session.values().rgb.empty() ? tr("Paste or open the values that were measured at the samples.")
                                                   : acquisitionStatus(m_session, m_controls));
}

}  // namespace gonio::app

#include "moc_reconstruction_page.cpp"
