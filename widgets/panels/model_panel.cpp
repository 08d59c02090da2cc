// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/model_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/panels/model_box.h"

namespace gonio::widgets {

ModelPanel::ModelPanel(QWidget* parent)
    : QWidget(parent),
      m_models(new ModelBox(this)),
      m_fit(new QPushButton(tr("Fit"), this)),
      m_residual(new QLabel(this)) {
  m_fit->setToolTip(tr("Fits the model to the measurement (Ctrl+F5)"));
  m_residual->setWordWrap(true);
  m_residual->setForegroundRole(QPalette::PlaceholderText);
  auto* top = new QHBoxLayout;
  top->addWidget(m_models, 1);
  top->addWidget(m_fit);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(top);
  layout->addWidget(m_residual);
  connect(m_fit, &QPushButton::clicked, this, &ModelPanel::fitRequested);
  connect(m_models, &ModelBox::modelChosen, this, &ModelPanel::modelChosen);
  setModel(nullptr, {});
}

void ModelPanel::setModel(const models::Model* model, const QString& residual) {
  m_models->setModel(model);
  m_residual->setText(residual);
  m_residual->setVisible(!residual.isEmpty());
}

void ModelPanel::setBusy(bool busy) { m_fit->setText(busy ? tr("Fitting") : tr("Fit")); }

}  // namespace gonio::widgets

#include "moc_model_panel.cpp"
