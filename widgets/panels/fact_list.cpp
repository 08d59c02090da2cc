// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/fact_list.h"

#include <QGridLayout>
#include <QLabel>

namespace gonio::widgets {

FactList::FactList(QWidget* parent) : QWidget(parent), m_layout(new QGridLayout(this)) {
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setVerticalSpacing(2);
  m_layout->setColumnStretch(1, 1);
}

void FactList::setFacts(const std::vector<Fact>& facts, const QString& emptyText) {
  while (QLayoutItem* item = m_layout->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  const auto label = [this](const QString& text) {
    auto* result = new QLabel(text, this);
    result->setTextFormat(Qt::PlainText);
    return result;
  };
  int row = 0;
  for (const Fact& fact : facts) {
    auto* name = label(fact.name);
    name->setForegroundRole(QPalette::PlaceholderText);
    auto* value = label(fact.value);
    value->setWordWrap(true);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setToolTip(fact.toolTip);
    value->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    value->setMinimumWidth(1);  // a long name must not widen the whole inspector
    m_layout->addWidget(name, row, 0, Qt::AlignTop);
    m_layout->addWidget(value, row, 1);
    ++row;
  }
  if (facts.empty() && !emptyText.isEmpty()) {
    auto* hint = label(emptyText);
    hint->setWordWrap(true);
    hint->setForegroundRole(QPalette::PlaceholderText);
    m_layout->addWidget(hint, 0, 0, 1, 2);
  }
}

}  // namespace gonio::widgets

#include "moc_fact_list.cpp"
