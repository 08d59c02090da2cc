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
#include "app/gonio/acquisition/reconstruction_page.h"
#include "core/coordinates/half_difference.h"
#include "widgets/acquisition/sample_chart.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

namespace {

double angleIn(const DirectionPair& pair, int column) {
  const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
  switch (column) {
    case AcquisitionSampleModel::ThetaIColumn:
      return polarAngle(pair.wi);
    case AcquisitionSampleModel::PhiIColumn:
      return azimuth(pair.wi);
    case AcquisitionSampleModel::ThetaOColumn:
      return polarAngle(pair.wo);
    case AcquisitionSampleModel::PhiOColumn:
      return azimuth(pair.wo);
    case AcquisitionSampleModel::ThetaHColumn:
      return at.thetaH;
    case AcquisitionSampleModel::ThetaDColumn:
      return at.thetaD;
    default:
      return foldPhiD(at.phiD);
  }
}

}  // namespace

void AcquisitionSampleModel::setDirections(const std::vector<DirectionPair>& directions) {
  acquisition::SamplingPlan plan;
  for (const DirectionPair& pair : directions)
    plan.samples.push_back({.index = int(plan.samples.size()) + 1, .directions = pair, .order = 0});
  setPlan(plan);
}

void AcquisitionSampleModel::setPlan(const acquisition::SamplingPlan& plan) {
  // Rows are only added while directions are chosen: the view keeps its place.
  const bool grows = plan.samples.size() >= m_samples.size() && !m_samples.empty();
  if (!grows) {
    beginResetModel();
    m_samples = plan.samples;
    m_values = {};
    endResetModel();
    return;
  }
  if (const int old = rowCount(), now = int(plan.samples.size()); now > old) {
    beginInsertRows({}, old, now - 1);
    m_samples = plan.samples;
    endInsertRows();
  }
  m_samples = plan.samples;
  Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void AcquisitionSampleModel::setValues(const acquisition::MeasuredValues& values) {
  m_values = values;
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, RedColumn), index(rowCount() - 1, BlueColumn));
}

int AcquisitionSampleModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(m_samples.size());
}
int AcquisitionSampleModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString AcquisitionSampleModel::text(const QModelIndex& index) const {
  const acquisition::PlannedSample& sample = m_samples[std::size_t(index.row())];
  if (index.column() == IndexColumn) return QString::number(sample.index);
  if (index.column() == OrderColumn) return sample.order > 0 ? QString::number(sample.order) : QString();
  if (index.column() < OrderColumn) return QString::number(degrees(angleIn(sample.directions, index.column())), 'f', 1);
  if (std::size_t(index.row()) >= m_values.rgb.size()) return {};
  return widgets::formatNumber(m_values.rgb[std::size_t(index.row())][index.column() - RedColumn]);
}

QVariant AcquisitionSampleModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (role == Qt::DisplayRole) return text(index);
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole)
    return widgets::sampleText(index.row() + 1, m_samples[std::size_t(index.row())].directions);
  return {};
}

QVariant AcquisitionSampleModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const std::pair<QString, QString> titles[] = {
      {tr("#"), tr("Rank in the order of selection; with the SOMP methods, the first samples contribute most")},
      {tr("θi [°]"), tr("Polar angle of the light, degrees")},
      {tr("φi [°]"), tr("Azimuth of the light, degrees")},
      {tr("θo [°]"), tr("Polar angle of the viewer, degrees")},
      {tr("φo [°]"), tr("Azimuth of the viewer, degrees")},
      {tr("θh [°]"), tr("Half angle: between half vector and normal, degrees")},
      {tr("θd [°]"), tr("Difference angle: half the angle between light and viewer, degrees")},
      {tr("φd [°]"), tr("Azimuth of the light about the half vector, degrees")},
      {tr("Order"), tr("Position in a measurement order that shortens the travel of the goniometer's arms")},
      {tr("R [1/sr]"), tr("Measured BRDF value, linear red, 1/sr")},
      {tr("G [1/sr]"), tr("Measured BRDF value, linear green, 1/sr")},
      {tr("B [1/sr]"), tr("Measured BRDF value, linear blue, 1/sr")}};
  if (role == Qt::DisplayRole) return titles[section].first;
  if (role == Qt::ToolTipRole) return titles[section].second;
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

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
