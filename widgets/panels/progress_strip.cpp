// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/progress_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QToolButton>
#include <cmath>

#include "widgets/inputs/menu_text.h"
#include "widgets/panels/elided_label.h"

namespace gonio::widgets {

namespace {
constexpr int barSteps = 1000;
}

ProgressStrip::ProgressStrip(QWidget* parent)
    : QWidget(parent),
      m_text(new ElidedLabel(this)),
      m_notice(new ElidedLabel(this)),
      m_bar(new QProgressBar(this)),
      m_cancel(new QToolButton(this)),
      m_pause(new QToolButton(this)),
      m_entries(new QToolButton(this)) {
  m_bar->setRange(0, barSteps);
  m_bar->setTextVisible(false);
  m_bar->setFixedSize(fontMetrics().height() * 8, fontMetrics().height() * 2 / 3);
  m_cancel->setText(tr("Cancel"));
  m_cancel->setToolTip(tr("Cancels this task (Escape)"));
  m_cancel->setAutoRaise(true);
  connect(m_cancel, &QToolButton::clicked, this, &ProgressStrip::cancelRequested);
  m_pause->setAutoRaise(true);
  m_pause->setCheckable(true);
  m_pause->setToolTip(tr("Pauses this task to free the processor; press again to resume"));
  connect(m_pause, &QToolButton::clicked, this, &ProgressStrip::pauseRequested);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 0, 0, 0);
  layout->addWidget(m_bar);
  layout->addWidget(m_text);
  layout->addWidget(m_pause);
  layout->addWidget(m_cancel);
  layout->addWidget(m_entries);
  layout->addWidget(m_notice, 1);
  // A long path must not push the numbers at the right out of the window.
  m_notice->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_notice->setTextFormat(Qt::PlainText);
  m_entries->setAutoRaise(true);
  m_entries->setPopupMode(QToolButton::InstantPopup);
  m_entries->setMenu(new QMenu(m_entries));
  m_entries->setToolTip(tr("All tasks in progress; each can be cancelled"));
  m_noticeTime.setSingleShot(true);
  connect(&m_noticeTime, &QTimer::timeout, m_notice, &QLabel::clear);
  setEntries({});
  clear();
}

void ProgressStrip::showProgress(const QString& text, double fraction, bool canCancel, Pausing pausing) {
  m_text->setText(text);
  m_text->setToolTip(text);
  m_bar->setValue(int(std::lround(fraction * barSteps)));
  m_bar->setAccessibleName(text);
  m_cancel->setVisible(canCancel);
  m_pause->setVisible(pausing != Pausing::no);
  m_pause->setChecked(pausing == Pausing::paused);
  m_pause->setText(pausing == Pausing::paused ? tr("Resume") : tr("Pause"));
  m_text->show();
  m_bar->show();
}

void ProgressStrip::setEntries(const std::vector<Entry>& entries) {
  m_entries->setVisible(entries.size() > 1);
  m_entries->setText(tr("%n tasks", nullptr, int(entries.size())));
  QMenu* menu = m_entries->menu();
  const QList<QAction*> actions = menu->actions();
  // An open menu keeps its entries under the pointer: only their texts change while the same work goes on.
  bool same = actions.size() == qsizetype(entries.size());
  for (std::size_t i = 0; same && i < entries.size(); ++i)
    same = actions[qsizetype(i)]->data().toInt() == entries[i].id;
  if (!same) menu->clear();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const int id = entries[i].id;
    // Each task is a menu of its own, so that the press that opens the list cannot cancel the task under the pointer.
    QAction* action = same ? actions[qsizetype(i)] : menu->addMenu(QString())->menuAction();
    action->setText(menuText(entries[i].text));
    action->setData(id);
    if (!same) action->menu()->addAction(tr("Cancel"), this, [this, id] { Q_EMIT entryCancelRequested(id); });
  }
}

void ProgressStrip::showNotice(const QString& text, int milliseconds) {
  m_notice->setText(text);
  m_notice->setToolTip(text);
  m_noticeTime.start(milliseconds);
}

QString ProgressStrip::notice() const { return m_notice->text(); }

void ProgressStrip::clear() {
  m_text->hide();
  m_bar->hide();
  m_pause->hide();
  m_cancel->hide();
}

}  // namespace gonio::widgets

#include "moc_progress_strip.cpp"
