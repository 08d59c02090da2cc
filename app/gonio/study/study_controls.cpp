// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_controls.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <algorithm>

#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

constexpr double bytesOfKilobyte = 1000;
constexpr int idRole = Qt::UserRole;

QTreeWidgetItem* item(const QString& text, std::string_view id) {
  auto* one = new QTreeWidgetItem({text});
  one->setData(0, idRole, widgets::toQString(id));
  one->setFlags(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  one->setCheckState(0, Qt::Unchecked);
  return one;
}

QString capitalised(std::string_view text) {
  QString result = widgets::toQString(text);
  return result.replace(0, 1, result.at(0).toUpper());
}

std::optional<double> limitOf(const QDoubleSpinBox& field) {
  return field.value() > field.minimum() ? std::optional(field.value()) : std::nullopt;
}

}  // namespace

QLabel* labelFor(const QString& text, QWidget* buddy) {
  auto* label = new QLabel(text);
  label->setBuddy(buddy);
  return label;
}

/// Families with more than one row have these below them.
StudyChoice::StudyChoice() {
  // Boxes that are not ticked have an outline of this colour, which otherwise vanishes in a dark theme.
  QPalette outlined = palette();
  outlined.setColor(QPalette::Window, Qt::gray);
  setPalette(outlined);
  setHeaderHidden(true);
  setAccessibleName(tr("Representations to compare"));
  setToolTip(tr("Tick the representations to compare; those that are no longer ticked lose their results"));
  QTreeWidgetItem* family = nullptr;
  for (const study::RepresentationKind& kind : study::representationKinds()) {
    if (kind.needsFurtherData) continue;
    if (!family || family->data(0, idRole) != widgets::toQString(kind.family->id)) {
      family = item(capitalised(kind.family->name), kind.family->id);
      family->setToolTip(0, widgets::toQString(kind.family->hint));
      addTopLevelItem(family);
    }
    auto* one = item(widgets::toQString(kind.label), kind.id);
    if (kind.model) one->setToolTip(0, widgets::toQString(kind.model->spec().reference));
    family->addChild(one);
  }
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* one = topLevelItem(i);
    if (one->childCount() == 1)
      delete one->takeChild(0);
    else
      one->setFlags(one->flags() | Qt::ItemIsAutoTristate);
  }
  connect(this, &QTreeWidget::itemChanged, this, [this] {
    if (!m_filling) Q_EMIT namesChanged();
  });
}

void StudyChoice::setNames(const std::vector<std::string>& names) {
  const study::RepresentationChoice choice{.names = names};
  m_filling = true;
  const auto tick = [&](QTreeWidgetItem& one) {
    const std::string id = one.data(0, idRole).toString().toStdString();
    const study::RepresentationKind* kind = study::findRepresentationKind(id);
    const bool ticked = std::ranges::count(names, id) > 0 || (kind && choice.selects(*kind));
    one.setCheckState(0, ticked ? Qt::Checked : Qt::Unchecked);
  };
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* family = topLevelItem(i);
    if (family->childCount() == 0) tick(*family);
    for (int j = 0; j < family->childCount(); ++j) tick(*family->child(j));
  }
  m_filling = false;
  Q_EMIT namesChanged();
}

std::vector<std::string> StudyChoice::names() const {
  std::vector<std::string> names;
  for (int i = 0; i < topLevelItemCount(); ++i) {
    const QTreeWidgetItem* family = topLevelItem(i);
    if (family->checkState(0) == Qt::Checked)
      names.push_back(family->data(0, idRole).toString().toStdString());
    else
      for (int j = 0; j < family->childCount(); ++j)
        if (family->child(j)->checkState(0) == Qt::Checked)
          names.push_back(family->child(j)->data(0, idRole).toString().toStdString());
  }
  return names;
}

StudyBudgetBar::StudyBudgetBar() : m_result(new QLabel), m_use(new QPushButton(tr("&Use This Representation"))) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  m_maxFrame = field(tr("&Frame time ≤"), tr(" ms"), 1e6);
  m_maxFrame->setToolTip(tr("Maximum frame time of the reference renderer; \"any\" sets no limit"));
  m_minSnr = field(tr("Re&ndered SNR ≥"), tr(" dB"), 200);
  m_minSnr->setToolTip(tr("Minimum rendered SNR; \"any\" sets no limit"));
  m_maxSize = field(tr("Si&ze ≤"), tr(" kB"), 1e6);
  m_maxSize->setToolTip(tr("Maximum size; \"any\" sets no limit"));
  m_result->setTextFormat(Qt::PlainText);
  m_result->setWordWrap(true);
  m_use->setToolTip(
      tr("Uses the best representation: a fit becomes the model in use, a code is shown in the Representation "
         "section,\nany other is shown in the preview. A double click uses any other row."));
  layout->addSpacing(fontMetrics().height());
  layout->addWidget(m_result, 1);
  layout->addWidget(m_use);
  connect(m_use, &QPushButton::clicked, this, &StudyBudgetBar::useRequested);
}

QDoubleSpinBox* StudyBudgetBar::field(const QString& text, const QString& unit, double maximum) {
  auto* box = new QDoubleSpinBox;
  box->setRange(0, maximum);
  box->setDecimals(1);
  box->setSuffix(unit);
  box->setSpecialValueText(tr("any"));
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setKeyboardTracking(false);
  box->setFocusPolicy(Qt::StrongFocus);
  box->setAccessibleName(QString(text).remove('&') + unit);
  layout()->addWidget(labelFor(text, box));
  layout()->addWidget(box);
  connect(box, &QDoubleSpinBox::valueChanged, this, &StudyBudgetBar::budgetChanged);
  return box;
}

study::Budget StudyBudgetBar::budget() const {
  study::Budget budget{.frameMilliseconds = limitOf(*m_maxFrame), .renderedSnr = limitOf(*m_minSnr), .bytes = {}};
  if (const auto kilobytes = limitOf(*m_maxSize)) budget.bytes = bytesOfKilobyte * *kilobytes;
  return budget;
}

void StudyBudgetBar::setBudget(const study::Budget& budget) {
  m_maxFrame->setValue(budget.frameMilliseconds.value_or(0));
  m_minSnr->setValue(budget.renderedSnr.value_or(0));
  m_maxSize->setValue(budget.bytes.value_or(0) / bytesOfKilobyte);
}

void StudyBudgetBar::setResult(const QString& text, bool canUse) {
  m_result->setText(text);
  m_use->setEnabled(canUse);
}

}  // namespace gonio::app

#include "moc_study_controls.cpp"
