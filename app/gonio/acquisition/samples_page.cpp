// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/samples_page.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gonio/acquisition/acquisition_files.h"
#include "app/gonio/acquisition/acquisition_status.h"

namespace gonio::app {

SamplesPage::SamplesPage(const AcquisitionSession& session, const AcquisitionControls& controls,
                         AcquisitionFiles& files)
    : m_session(session), m_controls(controls), m_table(new QTableView) {
  QPushButton* copy = button(tr("&Copy"), tr("Copies the plan as comma-separated text"),
                             [&files] { QApplication::clipboard()->setText(files.planText()); });
  QPushButton* save =
      button(tr("Save Plan..."), tr("Saves the plan as CSV: one row for each pair of directions, in degrees"),
             [&files] { files.askForPlanFile(); });
  m_openPlan =
      button(tr("Open Plan..."),
             tr("Uses the directions of a saved plan instead of choosing new ones; the reconstruction still uses the "
                "training set"),
             [&files] { files.askForPlan(); });
  QPushButton* paste = button(tr("Pas&te Values"),
                              tr("Pastes measured values from a spreadsheet or comma-separated text: a header, then "
                                 "rows of index, r, g, b in 1/sr"),
                              [&files] { files.paste(QApplication::clipboard()->text()); });
  QPushButton* read = button(tr("&Open Values..."),
                             tr("Reads measured values from a CSV file: a header, then rows of index, r, g, b in 1/sr"),
                             [&files] { files.askForValues(); });
  m_needPlan = {copy, save, paste, read};
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  for (const auto& buttons : {std::vector{copy, save, m_openPlan}, std::vector{paste, read}}) {
    auto* row = new QHBoxLayout;
    for (QPushButton* one : buttons) row->addWidget(one);
    row->addStretch();
    layout->addLayout(row);
  }
  layout->addWidget(m_table, 1);
  buildTable();
  for (const auto signal : {&AcquisitionSession::directionsChanged, &AcquisitionSession::planChanged})
    connect(&m_session, signal, this, &SamplesPage::showDirections);
  connect(&m_session, &AcquisitionSession::valuesChanged, this, [this] { m_model.setValues(m_session.values()); });
  showDirections();
}

QPushButton* SamplesPage::button(const QString& text, const QString& toolTip, std::function<void()> clicked) {
  auto* made = new QPushButton(text);
  made->setToolTip(toolTip);
  connect(made, &QPushButton::clicked, this, std::move(clicked));
  return made;
}

void SamplesPage::buildTable() {
  m_table->setModel(&m_model);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setHighlightSections(false);
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setSelectionMode(QAbstractItemView::SingleSelection);
  m_table->setShowGrid(false);
  m_table->setTabKeyNavigation(false);
  m_table->setAccessibleName(tr("Samples"));
  connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) { Q_EMIT currentChanged(current.row()); });
}

void SamplesPage::setCurrent(int sample) {
  if (m_table->currentIndex().row() != sample)
    m_table->setCurrentIndex(sample < 0 ? QModelIndex() : m_model.index(sample, 0));
}

void SamplesPage::showDirections() {
  if (m_session.planner().hasPlan())
    m_model.setPlan(m_session.planner().samplingPlan());
  else
    m_model.setDirections(m_session.planner().directions());
  m_model.setValues(m_session.values());
}

void SamplesPage::refresh() {
  for (QPushButton* one : m_needPlan) one->setEnabled(m_session.planner().hasPlan());
  m_openPlan->setEnabled(!startCancels(m_session, m_controls));
}

}  // namespace gonio::app

#include "moc_samples_page.cpp"
