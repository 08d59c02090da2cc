// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gonio/study/sheet_sources.h"
#include "app/gonio/study/study_view.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {
const QString showKey = QStringLiteral("study preview"), plotPurpose = QStringLiteral("plot");
}

StudyPanel::StudyPanel(const Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_tasks(tasks),
      m_run(new StudyRun(document, tasks, m_model, this)),
      m_measure(new QPushButton),
      m_families(new QPushButton(tr("&Kinds"))),
      m_back(new QPushButton(tr("&Back to the Material"))),
      m_sheet(new QPushButton(tr("Contact &Sheet..."))),
      m_copy(new QPushButton(tr("Copy as &CSV"))),
      m_export(new QPushButton(tr("E&xport as SVG..."))),
      m_quality(new QComboBox),
      m_cost(new QComboBox),
      m_view(new StudyView(m_model)),
      m_budget(new StudyBudgetBar),
      m_footer(new QLabel) {
  m_footer->setForegroundRole(QPalette::PlaceholderText);
  m_footer->setTextFormat(Qt::PlainText);
  m_footer->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_footer->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(buildChoice());
  layout->addWidget(m_view, 1);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(m_budget, 1);
  bottom->addWidget(m_back);
  layout->addLayout(bottom);
  layout->addWidget(m_footer);
  connectParts();
  refreshPlot();
}

QWidget* StudyPanel::buildChoice() {
  m_quality->addItem(tr("rendered SNR"));
  for (const metrics::MetricRecord& record : metrics::metricRecords()) {
    m_quality->addItem(widgets::toQString(record.name));
    m_quality->setItemData(m_quality->count() - 1, widgets::formulaHtml(record.formula), widgets::richToolTipRole);
  }
  m_quality->setToolTip(tr("Metric of the vertical axis of the plot and of the errors in the table"));
  for (const study::Cost cost : study::allCosts) m_cost->addItem(QString::fromStdString(study::axisTitle(cost)));
  m_cost->setToolTip(tr("Cost of the horizontal axis of the plot"));
  m_sheet->setToolTip(tr("The measured representations as images side by side, with error maps"));
  m_copy->setToolTip(tr("Copies all measured values, with the errors in every metric, as comma-separated text"));
  m_export->setToolTip(tr("Saves the plot as shown, on a white background"));
  m_back->setToolTip(tr("Shows the material in the preview again (Escape)"));
  m_measure->setToolTip(tr("Measures the missing representations in the background, or all of them again"));
  m_families->setToolTip(tr("Kinds of representations to measure; deselecting a kind removes its results"));
  buildFamilies();
  auto* choice = new QWidget;
  auto* top = new QHBoxLayout(choice);
  top->setContentsMargins(0, 0, 0, 0);
  top->addWidget(m_measure);
  top->addWidget(m_families);
  const auto labelled = [&](const QString& text, QComboBox* box) {
    auto* label = new QLabel(text);
    label->setBuddy(box);
    top->addWidget(label);
    top->addWidget(box);
  };
  labelled(tr("Met&ric"), m_quality);
  labelled(tr("&vs."), m_cost);
  top->addStretch();
  for (QPushButton* button : {m_sheet, m_copy, m_export}) top->addWidget(button);
  return choice;
}

void StudyPanel::buildFamilies() {
  auto* menu = new QMenu(m_families);
  menu->setToolTipsVisible(true);
  const auto offered = study::familiesWithoutFurtherData();
  for (const study::RepresentationFamily* family : study::representationFamilies()) {
    if (!std::ranges::count(offered, family->id)) continue;
    QAction* action = menu->addAction(widgets::toQString(family->name));
    action->setCheckable(true);
    action->setChecked(std::ranges::count(m_run->families(), family->id) > 0);
    action->setData(widgets::toQString(family->id));
    action->setToolTip(widgets::toQString(family->hint));
    connect(action, &QAction::toggled, this, &StudyPanel::chooseFamilies);
  }
  m_families->setMenu(menu);
}

void StudyPanel::chooseFamilies() {
  std::vector<std::string> families;
  for (const QAction* action : m_families->menu()->actions())
    if (action->isChecked()) families.push_back(action->data().toString().toStdString());
  m_run->setFamilies(families);
}

void StudyPanel::connectParts() {
  connect(m_measure, &QPushButton::clicked, this, [this] { m_run->isRunning() ? m_run->cancel() : measure(); });
  connect(m_back, &QPushButton::clicked, this, [this] { show(-1); });
  connect(m_sheet, &QPushButton::clicked, this, &StudyPanel::openSheet);
  connect(m_copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(m_run->csv()); });
  connect(m_export, &QPushButton::clicked, this, &StudyPanel::exportSvg);
  connect(m_cost, &QComboBox::currentIndexChanged, this, &StudyPanel::refreshPlot);
  connect(m_quality, &QComboBox::currentIndexChanged, this, [this] {
    if (const auto metric = axes().quality) m_model.setMetric(*metric);
    refreshPlot();
  });
  connect(m_view, &StudyView::chosen, this, &StudyPanel::show);
  connect(m_view, &StudyView::dismissed, this, [this] { show(-1); });
  connect(m_budget, &StudyBudgetBar::budgetChanged, this, &StudyPanel::refresh);
  connect(m_budget, &StudyBudgetBar::useRequested, this, &StudyPanel::useBest);
  connect(m_run, &StudyRun::restarted, this, [this] {
    show(-1);
    refreshPlot();
  });
  connect(m_run, &StudyRun::rowMeasured, this, &StudyPanel::refreshPlot);
  connect(m_run, &StudyRun::runningChanged, this, &StudyPanel::refresh);
  connect(m_run, &StudyRun::failed, this, &StudyPanel::failed);
  // What is edited is what the user wants to see.
  for (const auto signal : {&Document::editChanged, &Document::stateChanged})
    connect(&m_document, signal, this, [this] { show(-1); });
}

void StudyPanel::show(int row) {
  m_tasks.drop(showKey);
  m_wanted = row < 0 || row == m_shown || row == m_wanted || !m_model.studied(row) ? -1 : row;
  if (m_wanted < 0) {
    const bool was = m_subject.has_value();
    m_subject.reset();
    m_shown = -1;
    refresh();
    if (was) Q_EMIT subjectChanged();
    return;
  }
  m_tasks.run<widgets::PreviewSubject>(
      {tr("Preparing %1").arg(QString::fromStdString(m_model.representation(row).fullLabel())), showKey},
      [studied = m_model.studied(row)](const TaskControl& control) { return studiedSubject(*studied, control); },
      [this, row](const widgets::PreviewSubject& subject) { adopt(row, subject); },
      [this](const QString& error) {
        m_wanted = -1;
        Q_EMIT failed(tr("Cannot show the representation"), error);
      },
      [this] { m_wanted = -1; });
  refresh();
}

void StudyPanel::adopt(int row, const widgets::PreviewSubject& subject) {
  m_wanted = -1;
  m_shown = row;
  m_subject = subject;
  refresh();
  Q_EMIT subjectChanged();
}

QString StudyPanel::shownName() const {
  return m_shown < 0 ? QString() : QString::fromStdString(m_model.representation(m_shown).fullLabel());
}

study::StudyAxes StudyPanel::axes() const {
  study::StudyAxes axes{.cost = study::allCosts[m_cost->currentIndex()], .quality = {}};
  if (const int metric = m_quality->currentIndex() - 1; metric >= 0)
    axes.quality = metrics::metricRecords()[std::size_t(metric)].metric;
  return axes;
}

void StudyPanel::useBest() {
  if (m_best < 0) return;
  const study::Representation representation = m_model.representation(m_best);
  if (m_shown != m_best) show(m_best);
  Q_EMIT useRequested(representation);
}

void StudyPanel::exportSvg() {
  const QString name = QString::fromStdString(m_run->title() + " accuracy.svg").replace('/', '-');
  const QString proposed = widgets::inDialogFolder(plotPurpose, name);
  widgets::askForPath(this, tr("Export Plot"), proposed, tr("SVG file (*.svg)"), [this](const QString& path) {
    widgets::rememberDialogFolder(plotPurpose, path);
    try {
      m_run->writeSvg(path, axes());
      Q_EMIT exported(path);
    } catch (const Error& error) {
      Q_EMIT failed(tr("Cannot export the plot"), QString::fromUtf8(error.what()));
    }
  });
}

void StudyPanel::refreshPlot() {
  m_view->showPoints(axes());
  refresh();
}

bool StudyPanel::openSheet() {
  if (m_model.measuredRows().empty()) return false;
  Q_EMIT contactSheetRequested(sheetSource(m_document.name(), m_document.material(), m_model));
  return true;
}

void StudyPanel::refresh() {
  const bool open = m_document.material() != nullptr, running = m_run->isRunning();
  const bool whole = open && m_model.missing().empty();
  m_measure->setText(running ? tr("Stop") : whole ? tr("Re-meas&ure") : tr("Meas&ure"));
  m_measure->setEnabled(open && m_model.rowCount() > 0);
  m_families->setEnabled(!running);
  m_back->setVisible(m_subject.has_value());
  refreshBudget();
  m_view->setMarks(m_shown, m_best);
  m_view->setHint(!open     ? tr("Open a material to compare accuracy and cost of its representations.")
                  : running ? tr("The first representation is being measured.")
                  : m_model.rowCount() == 0
                      ? tr("Choose at least one kind of representation.")
                      : tr("Press Measure to measure the error and cost of every representation of this material "
                           "in the background (a few minutes)."));
  QStringList facts;
  for (const std::string& line : m_run->machine()) facts << QString::fromStdString(line);
  m_footer->setText(facts.join(QStringLiteral(" · ")));
}

void StudyPanel::refreshBudget() {
  const auto rows = m_model.measuredRows();
  for (QPushButton* button : {m_sheet, m_copy, m_export}) button->setEnabled(!rows.empty());
  const auto best = study::bestWithin(m_model.records(), m_budget->budget());
  m_best = best ? rows[*best] : -1;
  m_budget->setEnabled(!rows.empty());
  m_budget->setResult(rows.empty() ? QString()
                      : best ? tr("Best: %1").arg(QString::fromStdString(m_model.representation(m_best).fullLabel()))
                             : tr("None of the %1 measured representations meets this budget.").arg(rows.size()),
                      best.has_value());
}

}  // namespace gonio::app

#include "moc_study_panel.cpp"
