// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/model_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/parameters/parameter_text.h"

namespace gonio::widgets {

QString modelToolTip(const models::ModelSpec& spec) {
  return QStringLiteral("<p><b>%1</b></p><p>%2</p><p><tt>%3</tt></p><p>%4</p>")
      .arg(fromView(spec.name).toHtmlEscaped(), fromView(spec.description).toHtmlEscaped(),
           fromView(spec.formula).toHtmlEscaped(), fromView(spec.reference).toHtmlEscaped());
}

ModelPanel::ModelPanel(QWidget* parent)
    : QWidget(parent),
      m_models(new QComboBox(this)),
      m_fit(new QPushButton(tr("Fit"), this)),
      m_residual(new QLabel(this)) {
  m_models->setAccessibleName(tr("Model"));
  for (const models::Model* model : models::allModels()) {
    m_models->addItem(fromView(model->spec().name));
    m_models->setItemData(m_models->count() - 1, modelToolTip(model->spec()), Qt::ToolTipRole);
  }
  m_fit->setToolTip(tr("Fit the model to the measurement (Ctrl+F5)"));
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
  connect(m_models, &QComboBox::activated, this,
          [this](int index) { Q_EMIT modelChosen(models::allModels()[std::size_t(index)]); });
  setModel(nullptr, {});
}

void ModelPanel::setModel(const models::Model* model, const QString& residual) {
  int index = -1;
  for (std::size_t i = 0; i < models::allModels().size(); ++i)
    if (models::allModels()[i] == model) index = int(i);
  m_models->setCurrentIndex(index);
  m_models->setToolTip(model ? modelToolTip(model->spec()) : QString());
  m_residual->setText(residual);
  m_residual->setVisible(!residual.isEmpty());
}

void ModelPanel::setBusy(bool busy) { m_fit->setText(busy ? tr("Fitting") : tr("Fit")); }

}  // namespace gonio::widgets

#include "moc_model_panel.cpp"
