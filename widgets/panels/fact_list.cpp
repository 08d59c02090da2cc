// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/fact_list.h"

#include <QGridLayout>
#include <QLabel>

namespace gonio::widgets {

FactList::FactList(QWidget* parent)
    : QWidget(parent), m_layout(new QGridLayout(this)), m_hint(newLabel(QPalette::PlaceholderText)) {
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setVerticalSpacing(2);
  m_layout->setColumnStretch(1, 1);
  m_layout->addWidget(m_hint, 0, 0, 1, 2);
  m_hint->setWordWrap(true);
  m_hint->hide();
}

QLabel* FactList::newLabel(QPalette::ColorRole colour) {
  auto* label = new QLabel(this);
  label->setTextFormat(Qt::PlainText);
  label->setForegroundRole(colour);
  return label;
}

void FactList::addRow() {
  QLabel* name = newLabel(QPalette::PlaceholderText);
  QLabel* value = newLabel(QPalette::WindowText);
  value->setWordWrap(true);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  value->setMinimumWidth(1);  // a long name must not widen the whole inspector
  const int row = 1 + int(m_rows.size());
  m_layout->addWidget(name, row, 0, Qt::AlignTop);
  m_layout->addWidget(value, row, 1);
  m_rows.emplace_back(name, value);
}

void FactList::setFacts(const std::vector<Fact>& facts, const QString& emptyText) {
  // Labels are kept: the text of one may just be dragged by the mouse.
  while (m_rows.size() < facts.size()) addRow();
  for (std::size_t row = 0; row < m_rows.size(); ++row) {
    const auto [name, value] = m_rows[row];
    const Fact fact = row < facts.size() ? facts[row] : Fact();
    name->setText(fact.name);
    value->setText(fact.value);
    value->setToolTip(fact.toolTip);
    name->setVisible(row < facts.size());
    value->setVisible(row < facts.size());
  }
  m_hint->setText(emptyText);
  m_hint->setVisible(facts.empty() && !emptyText.isEmpty());
}

}  // namespace gonio::widgets

#include "moc_fact_list.cpp"
