// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/model_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/inputs/icons.h"
#include "widgets/inputs/plain_text_style.h"
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

/// A title is an entry that cannot be chosen.
void ModelBox::addTitle(const QString& title) {
  addItem(title);
  QStandardItem* item = qobject_cast<QStandardItemModel*>(QComboBox::model())->item(count() - 1);
  item->setFlags(Qt::NoItemFlags);
  QFont bold = font();
  bold.setBold(true);
  item->setFont(bold);
  m_entries.push_back(nullptr);
}

void ModelBox::addModel(const models::Model& model) {
  addItem(toQString(model.spec().name));
  setItemData(count() - 1, modelToolTip(model.spec()), richToolTipRole);
  m_entries.push_back(&model);
}

void ModelBox::fill() {
  if (!m_suggested.empty()) addTitle(tr("Suggested"));
  for (const models::Model* one : m_suggested) addModel(*one);
  for (const auto family :
       {models::ModelFamily::empirical, models::ModelFamily::analytic, models::ModelFamily::series}) {
    addTitle(familyTitle(family));
    for (const models::Model* one : models::allModels())
      if (one->spec().family == family) addModel(*one);
  }
  setMaxVisibleItems(int(m_entries.size()));
}

void ModelBox::setSuggested(const std::vector<const models::Model*>& suggested) {
  if (suggested == m_suggested) return;
  const models::Model* chosen = currentIndex() >= 0 ? m_entries[std::size_t(currentIndex())] : nullptr;
  m_suggested = suggested;
  clear();
  m_entries.clear();
  fill();
  setModel(chosen);
}

void ModelBox::setModel(const models::Model* model) {
  const auto found = std::find(m_entries.begin(), m_entries.end(), model);
  setCurrentIndex(model && found != m_entries.end() ? int(found - m_entries.begin()) : -1);
  setRichToolTip(*this, model ? modelToolTip(model->spec()) : QString());
}

ModelPanel::ModelPanel(QWidget* parent)
    : QWidget(parent), m_models(new ModelBox(this)), m_fit(new QPushButton(tr("Fit"), this)) {
  m_fit->setToolTip(tr("Fits the model to the measurement (Ctrl+F5)"));
  auto* top = new QHBoxLayout;
  top->addWidget(m_models, 1);
  top->addWidget(m_fit);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(top);
  connect(m_fit, &QPushButton::clicked, this, &ModelPanel::fitRequested);
  connect(m_models, &ModelBox::modelChosen, this, &ModelPanel::modelChosen);
  setModel(nullptr);
}

void ModelPanel::setModel(const models::Model* model) { m_models->setModel(model); }

void ModelPanel::setBusy(bool busy) { m_fit->setText(busy ? tr("Fitting") : tr("Fit")); }

CostLine::CostLine(QWidget* parent) : QWidget(parent), m_line(new QToolButton(this)), m_details(new QLabel(this)) {
  m_line->setCheckable(true);
  m_line->setAutoRaise(true);
  m_line->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_line->setIcon(themedIcon(QStringLiteral("collapsed")));
  m_line->setFocusPolicy(Qt::StrongFocus);
  m_line->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  m_line->setToolTip(
      tr("How closely the fitted model matches the measurement, and what the material costs. Press to show the "
         "numbers."));
  m_details->setWordWrap(true);
  m_details->setTextFormat(Qt::PlainText);
  m_details->setForegroundRole(QPalette::PlaceholderText);
  m_details->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_details->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_line);
  layout->addWidget(m_details);
  connect(m_line, &QToolButton::toggled, this, [this](bool open) {
    m_line->setIcon(themedIcon(open ? QStringLiteral("expanded") : QStringLiteral("collapsed")));
    m_details->setVisible(open);
  });
  setCosts({}, {});
}

QString CostLine::line() const { return m_line->text(); }

void CostLine::setCosts(const QString& line, const QString& details) {
  // Equal texts too would lay out the inspector anew, at each step of a slider.
  if (line != m_line->text()) m_line->setText(line);
  if (details != m_details->text()) m_details->setText(details);
  setVisible(!line.isEmpty());
}

}  // namespace gonio::widgets

#include "moc_model_panel.cpp"
