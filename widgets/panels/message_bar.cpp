// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "widgets/inputs/icons.h"

namespace gonio::widgets {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      m_text(new QLabel(this)),
      m_apply(new QPushButton(tr("&Apply"), this)),
      m_discard(new QPushButton(tr("&Discard"), this)),
      m_close(new QToolButton(this)) {
  setObjectName(QStringLiteral("messageBar"));
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  m_text->setWordWrap(true);
  m_text->setMinimumWidth(1);  // a long name must not widen the window
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_close->setIcon(themedIcon(QStringLiteral("close")));
  m_close->setAutoRaise(true);
  m_close->setToolTip(tr("Dismiss"));
  m_close->setAccessibleName(tr("Dismiss the message"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 6, 6, 6);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_apply);
  layout->addWidget(m_discard);
  layout->addWidget(m_close);
  connect(m_apply, &QPushButton::clicked, this, [this] {
    hide();
    Q_EMIT applied();
  });
  connect(m_discard, &QPushButton::clicked, this, &MessageBar::dismiss);
  connect(m_close, &QToolButton::clicked, this, &MessageBar::dismiss);
  hide();
}

void MessageBar::dismiss() {
  const bool proposal = isProposal();
  hide();
  if (proposal) Q_EMIT discarded();
}

bool MessageBar::isProposal() const { return !isHidden() && !m_apply->isHidden(); }

void MessageBar::present(const QString& text, bool proposal) {
  if (isProposal()) Q_EMIT discarded();
  m_text->setText(text);
  m_apply->setVisible(proposal);
  m_discard->setVisible(proposal);
  m_close->setVisible(!proposal);
  show();
}

void MessageBar::showMessage(const QString& text) {
  constexpr qsizetype maxMessages = 5;  // the bar takes its height from the preview
  if (isHidden()) m_shown.clear();
  m_shown.removeAll(text);
  m_shown << text;
  if (m_shown.size() > maxMessages) m_shown.removeFirst();
  present(m_shown.join('\n'), false);
}

void MessageBar::withdraw(const QString& text) {
  if (isHidden() || isProposal() || m_shown.removeAll(text) == 0) return;
  m_text->setText(m_shown.join('\n'));
  setVisible(!m_shown.isEmpty());
}

void MessageBar::showProposal(const QString& text) {
  if (isHidden()) m_shown.clear();
  present((m_shown + QStringList{text}).join('\n'), true);
}

}  // namespace gonio::widgets

#include "moc_message_bar.cpp"
