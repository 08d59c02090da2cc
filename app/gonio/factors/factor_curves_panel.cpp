// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/factors/factor_curves_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/gonio/document/material_files.h"
#include "app/gonio/factors/factor_terms_view.h"
#include "core/factorization/pdv_operations.h"
#include "core/formats/formats.h"
#include "core/formats/pdv.h"
#include "widgets/curves/curve_editor.h"
#include "widgets/curves/curve_view.h"
#include "widgets/curves/residual_strip.h"
#include "widgets/inputs/flow_layout.h"

namespace gonio::app {

namespace {

using editing::FactorEdit;
using factorization::PdvFactors;
using factorization::PdvForm;

const QString factorKey = QStringLiteral("factors");
constexpr int usualTerms = 3;
constexpr double firstLimitDegrees = 45;

widgets::ChannelCurves firstCurves(const PdvFactors& factors, FactorAxis axis) {
  widgets::ChannelCurves curves;
  for (std::size_t c = 0; c < 3; ++c) curves[c] = curveOf(factors.channels[c][0], axis);
  return curves;
}

}  // namespace

const QString FactorCurvesPanel::swapKey = QStringLiteral("factor-swap");

FactorCurvesPanel::FactorCurvesPanel(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_tasks(tasks),
      m_channel(new QComboBox),
      m_form(new QComboBox),
      m_logarithmic(new QCheckBox(tr("&Logarithmic"))),
      m_preserveDetail(new QCheckBox(tr("&Preserve measured detail"))),
      m_details(new QCheckBox(tr("&Details"))),
      m_factorise(new QPushButton(tr("&Factorise"))),
      m_resetAll(new QPushButton(tr("&Reset All"))),
      m_save(new QPushButton(tr("&Save..."))),
      m_columns{new FactorColumn(FactorAxis::theta), new FactorColumn(FactorAxis::deviation),
                new FactorColumn(FactorAxis::phi)},
      m_terms(new FactorTermsView),
      m_warning(new QLabel) {
  buildControls();
  connectColumns();
  showLimits(radians(firstLimitDegrees));
  connectDocument();
  m_terms->setTerms(usualTerms);
  refresh();
}

QSize FactorCurvesPanel::sizeHint() const { return QSize(80, 22) * fontMetrics().height(); }

void FactorCurvesPanel::buildControls() {
  m_channel->addItems({tr("All channels together"), tr("Red"), tr("Green"), tr("Blue")});
  m_channel->setAccessibleName(tr("Channel"));
  m_channel->setToolTip(tr("Channel of the curves that are edited: all three in proportion, or one"));
  m_form->addItems({tr("Two curves: F1 F2"), tr("Three curves: F1 F2 F3")});
  m_form->setAccessibleName(tr("Form of the factors"));
  m_form->setToolTip(
      tr("Two curves describe round highlights; three add the variation with the azimuth about the mirror direction.\n"
         "Changing the form factorises the measurement again and deletes the edits of the factor curves."));
  m_logarithmic->setToolTip(tr("Switches the value axis between logarithmic, over four decades, and linear from 0"));
  m_preserveDetail->setToolTip(
      tr("On: adds the change of the curves to the measurement, which retains the detail that they do not "
         "explain.\nOff: shows the curves alone."));
  m_preserveDetail->setChecked(true);
  m_factorise->setToolTip(tr("Computes the factor curves of the open material"));
  m_save->setToolTip(tr("Saves the current curves as a file (.pdv) that opens as a material"));
  m_resetAll->setToolTip(
      tr("Deletes the active edit of the factor curves, which restores all curves and the measured detail"));
  auto* top = new widgets::FlowLayout;
  for (QWidget* widget : std::initializer_list<QWidget*>{m_channel, m_form, m_logarithmic, m_preserveDetail, m_resetAll,
                                                         m_save, m_factorise, m_details})
    top->addWidget(widget);
  top->addWidget(new widgets::CurveLegend);
  auto* columns = new QHBoxLayout;
  for (FactorColumn* column : m_columns) columns->addWidget(column, 3);
  columns->addWidget(m_terms, 2);
  m_details->setToolTip(tr("Shows the number of terms of the curves, and what they leave out of the measurement"));
  const auto showDetails = [this](bool shown) {
    m_terms->setVisible(shown);
    for (FactorColumn* column : m_columns) column->residuals().setVisible(shown);
  };
  connect(m_details, &QCheckBox::toggled, this, showDetails);
  showDetails(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addLayout(top);
  layout->addLayout(columns, 1);
  m_warning->setObjectName(QStringLiteral("warning"));
  m_warning->setWordWrap(true);
  layout->addWidget(m_warning);
}

void FactorCurvesPanel::connectColumns() {
  for (FactorColumn* column : m_columns) {
    widgets::CurveEditor* editor = &column->editor();
    const FactorAxis axis = column->axis();
    connect(editor, &widgets::CurveEditor::interactionStarted, this, [this] { m_document.beginInteraction(); });
    connect(editor, &widgets::CurveEditor::interactionEnded, this, [this] { m_document.endInteraction(); });
    connect(editor, &widgets::CurveEditor::curvesEdited, this,
            [this, axis](const widgets::ChannelCurves& curves) { curvesEdited(axis, curves); });
    connect(column, &FactorColumn::operationChosen, this,
            [this, axis](FactorOperation operation) { operate(axis, operation); });
    connect(column, &FactorColumn::materialDropped, this, [this, axis](const QString& id) { replaceCurve(axis, id); });
    if (axis == FactorAxis::theta)
      connect(editor, &widgets::CurveEditor::pointedAt, this, &FactorCurvesPanel::showLimits);
    connect(m_logarithmic, &QCheckBox::toggled, editor, &widgets::CurveEditor::setLogarithmic);
    connect(m_channel, &QComboBox::currentIndexChanged, editor, [this, editor] { editor->setChannel(channel()); });
  }
}

void FactorCurvesPanel::connectDocument() {
  connect(m_terms, &FactorTermsView::termsChosen, this, &FactorCurvesPanel::chooseTerms);
  connect(m_form, &QComboBox::activated, this, &FactorCurvesPanel::chooseForm);
  connect(m_resetAll, &QPushButton::clicked, this, &FactorCurvesPanel::resetAll);
  connect(m_save, &QPushButton::clicked, this, &FactorCurvesPanel::save);
  connect(m_factorise, &QPushButton::clicked, this, [this] {
    m_refused = false;
    request();
  });
  connect(m_preserveDetail, &QCheckBox::clicked, this, [this](bool preserve) {
    FactorEdit edit = current();
    if (!edit.original) return;
    edit.preserveDetail = preserve;
    apply(edit, preserve ? tr("Preserve measured detail") : tr("Discard measured detail"));
  });
  connect(&m_document, &Document::materialChanged, this, [this] {
    m_tasks.drop(swapKey);
    forget();
    request();
  });
  // A step may lead to an edit of another form: its terms are measured then.
  connect(&m_document, &Document::stateChanged, this, &FactorCurvesPanel::request);
  connect(&m_document, &Document::editChanged, this, &FactorCurvesPanel::request);
  connect(&m_document, &Document::selectionChanged, this, &FactorCurvesPanel::request);
}

void FactorCurvesPanel::forget() {
  m_tasks.drop(factorKey);
  m_running = m_refused = m_addWhenKnown = false;
  m_measured.reset();
  m_original.reset();
}

void FactorCurvesPanel::showLimits(double thetaR) {
  const QString where = tr("%1°").arg(degrees(thetaR), 0, 'f', 0);
  column(FactorAxis::theta).editor().setLimits({{thetaR, where}});
  // The disk of directions ends at |Dp| = 1 - sin theta_R behind the mirror direction, and at 1 + sin theta_R at last.
  const double sine = std::sin(thetaR);
  column(FactorAxis::deviation)
      .editor()
      .setLimits({{1 - sine, tr("near horizon at %1").arg(where)}, {1 + sine, tr("far horizon")}}, 1 + sine);
}

bool FactorCurvesPanel::isSettled() const { return !isVisible() || (!m_running && !m_tasks.isRunning(swapKey)); }

FactorsWithCosts::Kind FactorCurvesPanel::kind() const {
  if (const auto* edit = m_document.active<FactorEdit>()) return {edit->edited->form, edit->edited->transform};
  return {m_form->currentIndex() == 0 ? PdvForm::twoFactors : PdvForm::threeFactors};
}

int FactorCurvesPanel::channel() const { return m_channel->currentIndex() - 1; }

FactorEdit FactorCurvesPanel::current() const {
  const auto* edit = m_document.active<FactorEdit>();
  return edit ? *edit : FactorEdit{m_original, m_original};
}

void FactorCurvesPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  request();
}

void FactorCurvesPanel::request() {
  const LoadedMaterialPtr material = m_document.material();
  if ((m_running || m_measured) && m_requested != kind()) forget();
  if (material && isVisible() && !m_running && !m_refused && !m_measured) {
    m_running = true;
    m_requested = kind();
    m_tasks.run<FactorsWithCosts>(
        {tr("Factorising %1").arg(widgets::spacedName(QString::fromStdString(material->material.name))), factorKey},
        [material, kind = kind()](const TaskControl& control) { return factorizeWithCosts(material, kind, control); },
        [this](const FactorsWithCosts& measured) { adopt(measured); },
        [this](const QString& error) {
          m_running = false;
          m_refused = true;
          refresh();
          Q_EMIT failed(tr("Cannot factorise"), error);
        },
        [this] {
          m_running = false;
          m_refused = true;
          refresh();
        });
  }
  refresh();
}

void FactorCurvesPanel::adopt(const FactorsWithCosts& measured) {
  m_running = false;
  m_measured = std::make_shared<const FactorsWithCosts>(measured);
  m_original = std::make_shared<const PdvFactors>(m_measured->factorization.factors.truncated(m_terms->terms()));
  if (std::exchange(m_addWhenKnown, false)) return addEdit();
  refresh();
}

void FactorCurvesPanel::save() {
  const Curves curves = current().edited;
  if (!curves) return;
  const QString suffix = formatSuffix(formats::pdvFormat);
  Q_EMIT saveRequested(
      {tr("Save Factors"), m_document.name(), tr("PDV factors (*%1)").arg(suffix), suffix,
       [curves](const std::filesystem::path& path, const TaskControl&) { formats::writePdv(*curves, path); }});
}

void FactorCurvesPanel::refresh() {
  const FactorEdit edit = current();
  const bool known = edit.original != nullptr;
  const bool flat = (known ? edit.edited->form : kind().form) == PdvForm::twoFactors;
  m_factorise->setVisible(m_refused && !m_measured);
  m_terms->setMeasured(m_measured);
  m_columns[2]->setVisible(!flat);
  m_preserveDetail->setChecked(edit.preserveDetail);
  m_preserveDetail->setEnabled(known);
  const std::string warning = known ? factorization::curveLimitWarning(*edit.edited) : std::string();
  m_warning->setText(QStringLiteral("⚠ ") + QString::fromStdString(warning));
  m_warning->setVisible(!warning.empty());
  m_save->setEnabled(known);
  m_resetAll->setEnabled(m_document.active<FactorEdit>());
  m_form->setEnabled(m_document.material() != nullptr);
  for (FactorColumn* column : m_columns) {
    widgets::CurveEditor& editor = column->editor();
    column->setButtonsEnabled(known);
    column->setTransform(known ? edit.edited->transform : kind().transform);
    if (known)
      editor.setCurves(nodesOf(*edit.edited, column->axis()), firstCurves(*edit.edited, column->axis()),
                       firstCurves(*edit.original, column->axis()));
    else
      editor.clear();
    showResiduals(*column);
    editor.setHint(!m_document.material() ? tr("Open a material to see its factor curves.")
                   : m_running            ? tr("The factors are being computed.")
                                          : tr("Press Factorise to compute the curves of this material."));
  }
  if (known) {
    m_form->setCurrentIndex(flat ? 0 : 1);
    m_terms->setTerms(edit.original->terms());
  }
}

void FactorCurvesPanel::showResiduals(FactorColumn& column) {
  const int terms = current().original ? current().original->terms() : 0;
  // A document that was edited elsewhere may have other nodes than the measurement here.
  if (!m_measured || terms < 1 || terms > int(m_measured->along.size()) ||
      nodesOf(m_measured->factorization.factors, column.axis()) != column.editor().nodes())
    return column.residuals().setFractions({}, {});
  column.residuals().setFractions(m_measured->along[std::size_t(terms - 1)][std::size_t(column.axis())],
                                  terms == 1 ? tr("Residual of 1 term") : tr("Residual of %1 terms").arg(terms));
}

}  // namespace gonio::app

#include "moc_factor_curves_panel.cpp"
#include "widgets/inputs/menu_text.h"
