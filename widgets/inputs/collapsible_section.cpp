// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/collapsible_section.h"

#include <QVBoxLayout>

#include "widgets/inputs/icons.h"

namespace gonio::widgets {

CollapsibleSection::CollapsibleSection(const QString& title, QWidget* content, QWidget* parent)
    : QWidget(parent), m_header(new QToolButton(this)), m_content(content) {
  m_header->setText(title);
  m_header->setAccessibleName(title);
  m_header->setCheckable(true);
  m_header->setChecked(true);
  m_header->setAutoRaise(true);
  m_header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  m_header->setIcon(themedIcon(QStringLiteral("expanded")));
  m_header->setFocusPolicy(Qt::StrongFocus);
  m_header->setObjectName(QStringLiteral("sectionHeader"));
  QFont bold = font();
  bold.setBold(true);
  m_header->setFont(bold);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_header);
  layout->addWidget(m_content);
  connect(m_header, &QToolButton::toggled, this, [this](bool expanded) {
    m_content->setVisible(expanded);
    m_header->setIcon(themedIcon(expanded ? QStringLiteral("expanded") : QStringLiteral("collapsed")));
    Q_EMIT expandedChanged(expanded);
  });
}

void CollapsibleSection::setExpanded(bool expanded) { m_header->setChecked(expanded); }

}  // namespace gonio::widgets

#include "moc_collapsible_section.cpp"
