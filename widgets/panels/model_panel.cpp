// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/model_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/parameters/parameter_text.h"

namespace gonio::widgets {

QString modelToolTip(const models::ModelSpec& spec) {
  return QStringLiteral("<p><b>%1</b></p><p>%2</p><p><tt>%3</tt></p><p>%4</p>")
      .arg(fromView(spec.name).toHtmlEscaped(), fromView(spec.description).toHtmlEscaped(),
           fromView(spec.formula).toHtmlEscaped(), fromView(spec.reference).toHtmlEscaped());
}

namespace {

QString familyTitle(models::ModelFamily family) {
  switch (family) {
    case models::ModelFamily::empirical:
      return ModelPanel::tr("Empirical");
    case models::ModelFamily::analytic:
      return ModelPanel::tr("Analytic");
    case models::ModelFamily::series:
      return ModelPanel::tr("Series");
  }
  return {};
}

}  // namespace

ModelPanel::ModelPanel(QWidget* parent)
    : QWidget(parent),
      m_models(new QComboBox(this)),
      m_fit(new QPushButton(tr("Fit"), this)),
      m_residual(new QLabel(this)) {
  m_models->setAccessibleName(tr("Model"));
  fillModels();
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
          [this](int index) { Q_EMIT modelChosen(m_entries[std::size_t(index)]); });
  setModel(nullptr, {});
}

void ModelPanel::fillModels() {
  auto* items = qobject_cast<QStandardItemModel*>(m_models->model());
  for (const auto family :
       {models::ModelFamily::empirical, models::ModelFamily::analytic, models::ModelFamily::series}) {
    // A title is an entry that cannot be chosen.
    m_models->addItem(familyTitle(family));
    QStandardItem* title = items->item(m_models->count() - 1);
    title->setFlags(Qt::NoItemFlags);
    QFont bold = font();
    bold.setBold(true);
    title->setFont(bold);
    m_entries.push_back(nullptr);
    for (const models::Model* model : models::allModels()) {
      if (model->spec().family != family) continue;
      m_models->addItem(fromView(model->spec().name));
      m_models->setItemData(m_models->count() - 1, modelToolTip(model->spec()), Qt::ToolTipRole);
      m_entries.push_back(model);
    }
  }
  m_models->setMaxVisibleItems(int(m_entries.size()));
}

void ModelPanel::setModel(const models::Model* model, const QString& residual) {
  const auto found = std::find(m_entries.begin(), m_entries.end(), model);
  const int index = model && found != m_entries.end() ? int(found - m_entries.begin()) : -1;
  m_models->setCurrentIndex(index);
  m_models->setToolTip(model ? modelToolTip(model->spec()) : QString());
  m_residual->setText(residual);
  m_residual->setVisible(!residual.isEmpty());
}

void ModelPanel::setBusy(bool busy) { m_fit->setText(busy ? tr("Fitting") : tr("Fit")); }

}  // namespace gonio::widgets

#include "moc_model_panel.cpp"
