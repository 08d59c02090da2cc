// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/model_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/inputs/plain_text_style.h"
#include "widgets/panels/elided_label.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::widgets {

QString modelToolTip(const models::ModelSpec& spec) {
  return QStringLiteral("<p><b>%1</b></p><p>%2</p><p>%3</p><p>%4</p>")
      .arg(toQString(spec.name).toHtmlEscaped(), toQString(spec.description).toHtmlEscaped(), formulaHtml(spec.formula),
           toQString(spec.reference).toHtmlEscaped());
}

namespace {

QString familyTitle(models::ModelFamily family) {
  switch (family) {
    case models::ModelFamily::empirical:
      return ModelBox::tr("Empirical");
    case models::ModelFamily::analytic:
      return ModelBox::tr("Physically based");
    case models::ModelFamily::series:
      return ModelBox::tr("Series expansions");
  }
  return {};
}

}  // namespace

ModelBox::ModelBox(QWidget* parent) : QComboBox(parent) {
  setAccessibleName(tr("Model"));
  fill();
  connect(this, &QComboBox::activated, this, [this](int index) { Q_EMIT modelChosen(m_entries[std::size_t(index)]); });
}

void ModelBox::fill() {
  auto* items = qobject_cast<QStandardItemModel*>(QComboBox::model());
  for (const auto family :
       {models::ModelFamily::empirical, models::ModelFamily::analytic, models::ModelFamily::series}) {
    // A title is an entry that cannot be chosen.
    addItem(familyTitle(family));
    QStandardItem* title = items->item(count() - 1);
    title->setFlags(Qt::NoItemFlags);
    QFont bold = font();
    bold.setBold(true);
    title->setFont(bold);
    m_entries.push_back(nullptr);
    for (const models::Model* one : models::allModels()) {
      if (one->spec().family != family) continue;
      addItem(toQString(one->spec().name));
      setItemData(count() - 1, modelToolTip(one->spec()), richToolTipRole);
      m_entries.push_back(one);
    }
  }
  setMaxVisibleItems(int(m_entries.size()));
}

void ModelBox::setModel(const models::Model* model) {
  const auto found = std::find(m_entries.begin(), m_entries.end(), model);
  setCurrentIndex(model && found != m_entries.end() ? int(found - m_entries.begin()) : -1);
  setRichToolTip(*this, model ? modelToolTip(model->spec()) : QString());
}

ModelPanel::ModelPanel(QWidget* parent)
    : QWidget(parent),
      m_models(new ModelBox(this)),
      m_fit(new QPushButton(tr("Fit"), this)),
      m_costs(new ElidedLabel(this)) {
  m_fit->setToolTip(tr("Fits the model to the measurement (Ctrl+F5)"));
  m_costs->setForegroundRole(QPalette::PlaceholderText);
  auto* top = new QHBoxLayout;
  top->addWidget(m_models, 1);
  top->addWidget(m_fit);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(top);
  layout->addWidget(m_costs);
  connect(m_fit, &QPushButton::clicked, this, &ModelPanel::fitRequested);
  connect(m_models, &ModelBox::modelChosen, this, &ModelPanel::modelChosen);
  setModel(nullptr);
}

void ModelPanel::setModel(const models::Model* model) { m_models->setModel(model); }

void ModelPanel::setCosts(const QString& line, const QString& details) {
  // Equal texts too would make a label and its tooltip anew, at each step of a slider.
  if (line != m_costs->text()) m_costs->setText(line);
  if (details != m_costs->toolTip()) m_costs->setToolTip(details);
}

void ModelPanel::setBusy(bool busy) { m_fit->setText(busy ? tr("Fitting") : tr("Fit")); }

}  // namespace gonio::widgets

#include "moc_model_panel.cpp"
