// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/progress_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <cmath>

namespace gonio::widgets {

namespace {
constexpr int barSteps = 1000;
}

ProgressStrip::ProgressStrip(QWidget* parent)
    : QWidget(parent), m_text(new QLabel(this)), m_bar(new QProgressBar(this)), m_cancel(new QToolButton(this)) {
  m_bar->setRange(0, barSteps);
  m_bar->setTextVisible(false);
  m_bar->setFixedSize(fontMetrics().height() * 8, fontMetrics().height() * 2 / 3);
  m_cancel->setText(tr("Cancel"));
  m_cancel->setToolTip(tr("Stop this work (Esc)"));
  m_cancel->setAutoRaise(true);
  connect(m_cancel, &QToolButton::clicked, this, &ProgressStrip::cancelRequested);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 0, 0, 0);
  layout->addWidget(m_bar);
  layout->addWidget(m_text);
  layout->addWidget(m_cancel);
  layout->addStretch();
  clear();
}

void ProgressStrip::showProgress(const QString& text, double share, bool canCancel) {
  m_text->setText(text);
  m_bar->setValue(int(std::lround(share * barSteps)));
  m_bar->setAccessibleName(text);
  m_cancel->setVisible(canCancel);
  m_text->show();
  m_bar->show();
}

void ProgressStrip::clear() {
  m_text->hide();
  m_bar->hide();
  m_cancel->hide();
}

}  // namespace gonio::widgets

#include "moc_progress_strip.cpp"
