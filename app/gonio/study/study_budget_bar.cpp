// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_budget_bar.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace gonio::app {

namespace {

constexpr double bytesOfKilobyte = 1000;

std::optional<double> limitOf(const QDoubleSpinBox& field) {
  return field.value() > field.minimum() ? std::optional(field.value()) : std::nullopt;
}

}  // namespace

StudyBudgetBar::StudyBudgetBar(QWidget* parent)
    : QWidget(parent), m_result(new QLabel), m_use(new QPushButton(tr("&Use This Representation"))) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  m_frame = field(tr("&Frame time ≤"), tr(" ms"), 1e6,
                  tr("Maximum frame time of the reference renderer; \"any\" sets no limit"));
  m_snr = field(tr("&Rendered SNR ≥"), tr(" dB"), 200, tr("Minimum rendered SNR; \"any\" sets no limit"));
  m_kilobytes = field(tr("Si&ze ≤"), tr(" kB"), 1e6, tr("Maximum size; \"any\" sets no limit"));
  m_result->setTextFormat(Qt::PlainText);
  m_use->setToolTip(
      tr("Uses the best representation: a fit becomes the model in use, a code is shown in the Representation "
         "section,\nany other is shown in the preview"));
  layout->addWidget(m_result, 1);
  layout->addWidget(m_use);
  connect(m_use, &QPushButton::clicked, this, &StudyBudgetBar::useRequested);
  setResult({}, false);
}

QDoubleSpinBox* StudyBudgetBar::field(const QString& text, const QString& unit, double maximum,
                                      const QString& toolTip) {
  auto* label = new QLabel(text);
  auto* box = new QDoubleSpinBox;
  label->setBuddy(box);
  box->setRange(0, maximum);
  box->setDecimals(1);
  box->setSuffix(unit);
  box->setSpecialValueText(tr("any"));
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setKeyboardTracking(false);
  box->setFocusPolicy(Qt::StrongFocus);
  box->setAccessibleName(text + unit);
  box->setToolTip(toolTip);
  layout()->addWidget(label);
  layout()->addWidget(box);
  connect(box, &QDoubleSpinBox::valueChanged, this, &StudyBudgetBar::budgetChanged);
  return box;
}

study::Budget StudyBudgetBar::budget() const {
  study::Budget budget{.frameMilliseconds = limitOf(*m_frame), .renderedSnr = limitOf(*m_snr), .bytes = {}};
  if (const auto kilobytes = limitOf(*m_kilobytes)) budget.bytes = bytesOfKilobyte * *kilobytes;
  return budget;
}

void StudyBudgetBar::setBudget(const study::Budget& budget) {
  m_frame->setValue(budget.frameMilliseconds.value_or(0));
  m_snr->setValue(budget.renderedSnr.value_or(0));
  m_kilobytes->setValue(budget.bytes.value_or(0) / bytesOfKilobyte);
}

void StudyBudgetBar::setResult(const QString& text, bool canUse) {
  m_result->setText(text);
  m_use->setEnabled(canUse);
}

}  // namespace gonio::app

#include "moc_study_budget_bar.cpp"
