// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Where the parts of the Acquisition panel stand, and what connects them.
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <cmath>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "widgets/acquisition/error_curve.h"
#include "widgets/acquisition/half_difference_chart.h"
#include "widgets/acquisition/hemisphere_chart.h"
#include "widgets/acquisition/reconstruction_view.h"

namespace gonio::app {

namespace {
constexpr int controlEms = 20;

QVBoxLayout* column(QWidget* widget) {
  auto* layout = new QVBoxLayout(widget);
  layout->setContentsMargins(0, 4, 0, 0);
  return layout;
}
}  // namespace

QSize AcquisitionPanel::sizeHint() const { return QSize(80, 24) * fontMetrics().height(); }

QWidget* AcquisitionPanel::buildControls() {
  auto* scroll = new QScrollArea;
  scroll->setWidget(m_controls);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_start->setToolTip(tr("Chooses where to measure, with the settings above; while it works: stops"));
  m_start->setDefault(true);
  m_progress->setRange(0, 1000);
  m_progress->setTextVisible(false);
  m_progress->setFixedHeight(fontMetrics().height() / 2);
  m_progress->setAccessibleName(tr("Progress"));
  QSizePolicy kept = m_progress->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  m_progress->setSizePolicy(kept);
  m_status->setWordWrap(true);
  m_status->setTextFormat(Qt::PlainText);
  m_status->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_status->setMinimumHeight(2 * fontMetrics().lineSpacing() + 2);
  auto* widget = new QWidget;
  auto* layout = column(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll, 1);
  layout->addWidget(m_start);
  layout->addWidget(m_progress);
  layout->addWidget(m_status);
  widget->setFixedWidth(controlEms * fontMetrics().height());
  return widget;
}

QWidget* AcquisitionPanel::buildCharts() {
  m_slice->setAccessibleName(tr("φd of the slice"));
  m_slice->setToolTip(tr("Which slice of half-difference space the chart shows; a click on a sample goes to its own"));
  m_sliceText->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("180°")) + 2);
  m_sliceText->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_uncertainty->setChecked(true);
  m_uncertainty->setToolTip(
      tr("How uncertain the reconstruction is at each cell, in false colour: the standard deviation of ln ρ that the "
         "samples leave (0.1 is about 10 %)."));
  m_slice->setRange(0, HalfDifferenceGrid().phiDCount - 1);
  m_slice->setValue(HalfDifferenceGrid().phiDCount / 2);
  auto* label = new QLabel(tr("Slice φd"));
  label->setBuddy(m_slice);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(m_slice, 1);
  row->addWidget(m_sliceText);
  row->addWidget(m_uncertainty);
  auto* charts = new QWidget;
  auto* layout = new QHBoxLayout(charts);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_hemisphere, 5);
  auto* right = new QVBoxLayout;
  right->addWidget(m_chart, 1);
  right->addLayout(row);
  layout->addLayout(right, 6);
  return charts;
}

QWidget* AcquisitionPanel::buildPages() {
  m_pages->addTab(buildSamplesPage(), tr("Samples"));
  m_pages->addTab(buildReconstructionPage(), tr("&Reconstruction"));
  m_pages->addTab(buildCurvePage(), tr("Error over m"));
  m_pages->setDocumentMode(true);
  return m_pages;
}

QWidget* AcquisitionPanel::buildSamplesPage() {
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
  m_copy->setToolTip(tr("Copies the plan as comma-separated text"));
  m_save->setToolTip(tr("Writes the plan as CSV: a row for each pair of directions, in degrees"));
  m_paste->setToolTip(tr(
      "Takes measured values from the clipboard, of a spreadsheet or as comma-separated text: a header, then rows of "
      "index, r, g, b in 1/sr"));
  m_read->setToolTip(tr("The same from a CSV file"));
  m_openPlan->setToolTip(tr(
      "Takes the directions of a plan that was saved before, instead of choosing them; the training set is learned"));
  auto* page = new QWidget;
  auto* layout = column(page);
  for (const auto& buttons : {std::vector{m_copy, m_save, m_openPlan}, std::vector{m_paste, m_read}}) {
    auto* row = new QHBoxLayout;
    for (QPushButton* button : buttons) row->addWidget(button);
    row->addStretch();
    layout->addLayout(row);
  }
  layout->addWidget(m_table, 1);
  return page;
}

QWidget* AcquisitionPanel::buildReconstructionPage() {
  m_numbers->setWordWrap(true);
  m_numbers->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_open->setToolTip(
      tr("The reconstruction becomes the open material, to be edited, saved and exported like any other.\n"
         "Its table is kept as a file in Gonio's data folder. Undo brings back what was open."));
  auto* row = new QHBoxLayout;
  row->addWidget(m_numbers, 1);
  row->addWidget(m_open, 0, Qt::AlignTop);
  auto* page = new QWidget;
  auto* layout = column(page);
  layout->addWidget(m_view, 1);
  layout->addLayout(row);
  return page;
}

QWidget* AcquisitionPanel::buildCurvePage() {
  m_quality->addItems({tr("rendered SNR"), tr("log error")});
  m_quality->setToolTip(tr("Of the material that the first m of the samples give, against the one that is measured"));
  auto* label = new QLabel(tr("Sho&w"));
  label->setBuddy(m_quality);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(m_quality);
  row->addStretch();
  auto* page = new QWidget;
  auto* layout = column(page);
  layout->addLayout(row);
  layout->addWidget(m_curve, 1);
  return page;
}

void AcquisitionPanel::connectSession() {
  connect(&m_session, &AcquisitionSession::directionsChanged, this, &AcquisitionPanel::showDirections);
  connect(&m_session, &AcquisitionSession::planChanged, this, [this] {
    showDirections();
    showSlice();
    showCurve();
  });
  connect(&m_session, &AcquisitionSession::valuesChanged, this, [this] {
    m_model.setValues(m_session.values());
    refresh();
  });
  connect(&m_session, &AcquisitionSession::referenceChanged, this, &AcquisitionPanel::showReference);
  connect(&m_session, &AcquisitionSession::resultChanged, this, &AcquisitionPanel::showResult);
  connect(&m_session, &AcquisitionSession::curveChanged, this, &AcquisitionPanel::showCurve);
  connect(&m_session, &AcquisitionSession::progressed, this, &AcquisitionPanel::refresh);
  connect(&m_session, &AcquisitionSession::failed, this, &AcquisitionPanel::failed);
  connect(&m_document, &Document::materialChanged, this, &AcquisitionPanel::takeOpenMaterial);
  connect(m_controls, &AcquisitionControls::subjectEdited, this, &AcquisitionPanel::subjectEdited);
  connect(m_controls, &AcquisitionControls::subjectWanted, this, &AcquisitionPanel::subjectWanted);
  connect(m_controls, &AcquisitionControls::planSettingsEdited, this, [this] {
    showSlice();
    refresh();
  });
  connect(m_controls, &AcquisitionControls::noiseEdited, this, [this] { m_session.simulate(m_controls->noise()); });
  connect(m_controls, &AcquisitionControls::reconstructionEdited, this,
          [this] { m_session.setReconstruction(m_controls->reconstruction()); });
}

void AcquisitionPanel::connectCharts() {
  for (widgets::SampleChart* chart : std::initializer_list<widgets::SampleChart*>{m_hemisphere, m_chart}) {
    connect(chart, &widgets::SampleChart::currentChanged, this, &AcquisitionPanel::mark);
    connect(chart, &widgets::SampleChart::chosen, this, [this](int sample) {
      const DirectionPair& pair = m_hemisphere->samples()[std::size_t(sample)];
      const double period = pi, phiD = foldPhiD(toHalfDifference(pair.wi, pair.wo).phiD);
      const int count = m_slice->maximum() + 1;
      m_slice->setValue(int(std::lround(phiD / period * count)) % count);
    });
  }
  connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) { mark(current.row()); });
  connect(m_slice, &QSlider::valueChanged, this, &AcquisitionPanel::showSlice);
  connect(m_uncertainty, &QCheckBox::toggled, this, &AcquisitionPanel::showSlice);
  connect(m_quality, &QComboBox::currentIndexChanged, this, &AcquisitionPanel::showCurve);
  connect(m_pages, &QTabWidget::tabBarClicked, this, [this] { m_pageChosen = true; });
}

void AcquisitionPanel::connectButtons() {
  connect(m_start, &QPushButton::clicked, this, &AcquisitionPanel::start);
  connect(m_open, &QPushButton::clicked, this, &AcquisitionPanel::openResult);
  connect(m_copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(planText()); });
  connect(m_paste, &QPushButton::clicked, this, [this] { paste(QApplication::clipboard()->text()); });
  connect(m_read, &QPushButton::clicked, this, &AcquisitionPanel::askForValues);
  connect(m_openPlan, &QPushButton::clicked, this, &AcquisitionPanel::askForPlan);
  connect(m_save, &QPushButton::clicked, this, &AcquisitionPanel::askForPlanFile);
}

void AcquisitionPanel::askForValues() {
  auto* dialog = new QFileDialog(this, tr("Open Values"), {}, tr("Values (*.csv *.txt);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &AcquisitionPanel::readValues);
  dialog->open();
}

void AcquisitionPanel::askForPlan() {
  auto* dialog = new QFileDialog(this, tr("Open Plan"), {}, tr("Plans (*.csv);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &AcquisitionPanel::readPlan);
  dialog->open();
}

void AcquisitionPanel::askForPlanFile() {
  auto* dialog = new QFileDialog(this, tr("Save Plan"), {}, tr("Plan (*.csv)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("csv"));
  connect(dialog, &QFileDialog::fileSelected, this, &AcquisitionPanel::savePlan);
  dialog->open();
}

}  // namespace gonio::app
