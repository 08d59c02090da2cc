// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/plausibility_badges.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "widgets/inputs/icons.h"

namespace gonio::widgets {

namespace {

constexpr int badgesPerRow = 3;

bool isDark(const QPalette& palette) { return palette.color(QPalette::Window).lightness() < 128; }

/// Readable (4.5 : 1) as text on the window's colour.
QColor signColour(PlausibilityBadge::State state, const QPalette& palette) {
  if (state == PlausibilityBadge::State::passed) return isDark(palette) ? QColor(126, 200, 140) : QColor(24, 105, 48);
  if (state == PlausibilityBadge::State::failed) return isDark(palette) ? QColor(245, 176, 84) : QColor(148, 70, 0);
  return palette.color(QPalette::PlaceholderText);
}

}  // namespace

PlausibilityBadge::PlausibilityBadge(QWidget* parent) : QAbstractButton(parent) {
  setCheckable(true);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
}

void PlausibilityBadge::setState(State state) {
  m_state = state;
  const QString outcome = state == State::passed   ? tr("passed")
                          : state == State::failed ? tr("failed")
                                                   : tr("checking");
  setAccessibleName(tr("%1: %2").arg(text(), outcome));
  setToolTip(tr("%1: %2. Press for an explanation.").arg(text(), outcome));
  update();
}

QSize PlausibilityBadge::sizeHint() const {
  const int line = fontMetrics().height();
  return {fontMetrics().horizontalAdvance(text()) + line * 5 / 2, line * 3 / 2};
}

void PlausibilityBadge::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor colour = signColour(m_state, palette());
  QColor fill = colour;
  fill.setAlphaF(isChecked() || underMouse() ? 0.28f : 0.12f);
  const bool focused = hasFocus();
  painter.setPen(QPen(focused ? palette().color(QPalette::Highlight) : colour, focused ? 2 : 1));
  painter.setBrush(fill);
  const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
  painter.drawRoundedRect(frame, frame.height() / 2, frame.height() / 2);
  const double line = fontMetrics().height() * 0.85;
  painter.setPen(colour);
  const Glyph glyph = m_state == State::passed   ? Glyph::passed
                      : m_state == State::failed ? Glyph::warning
                                                 : Glyph::pending;
  paintGlyph(painter, glyph, QRectF(line * 0.6, (height() - line) / 2, line, line));
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRectF(line * 1.9, 0, width() - line * 2.2, height()), Qt::AlignVCenter | Qt::AlignLeft, text());
}

PlausibilityBadges::PlausibilityBadges(QWidget* parent)
    : QWidget(parent),
      m_grid(new QGridLayout),
      m_empty(new QLabel(this)),
      m_explanation(new QLabel(this)),
      m_show(new QPushButton(tr("Show in Plot"), this)) {
  m_empty->setForegroundRole(QPalette::PlaceholderText);
  m_explanation->setWordWrap(true);
  m_explanation->setTextFormat(Qt::RichText);
  m_explanation->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  m_show->setToolTip(tr("Opens the plots at the angle of the worst value"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_empty);
  layout->addLayout(m_grid);
  layout->addWidget(m_explanation);
  layout->addWidget(m_show, 0, Qt::AlignLeft);
  m_grid->setSpacing(4);
  connect(m_show, &QPushButton::clicked, this, [this] {
    const metrics::PlausibilityCheck& check = m_checks[std::size_t(current())];
    const Direction& at = check.name == "energy" ? check.at->wo : check.at->wi;
    Q_EMIT showRequested(QString::fromStdString(check.name), polarAngle(at));
  });
  clear();
}

int PlausibilityBadges::current() const {
  for (std::size_t i = 0; i < m_badges.size(); ++i)
    if (m_badges[i]->isChecked()) return int(i);
  return -1;
}

void PlausibilityBadges::setChecks(const std::vector<metrics::PlausibilityCheck>& checks) {
  m_checks = checks;
  while (m_badges.size() < checks.size()) {
    auto* badge = new PlausibilityBadge(this);
    const int place = int(m_badges.size());
    m_grid->addWidget(badge, place / badgesPerRow, place % badgesPerRow);
    m_badges.push_back(badge);
    connect(badge, &PlausibilityBadge::clicked, this, [this, badge] {
      for (PlausibilityBadge* other : m_badges)
        if (other != badge) other->setChecked(false);
      explain();
    });
  }
  for (std::size_t i = 0; i < m_badges.size(); ++i) {
    m_badges[i]->setVisible(i < checks.size());
    if (i >= checks.size()) continue;
    m_badges[i]->setText(plausibilityWord(checks[i]));
    m_badges[i]->setState(checks[i].passed ? PlausibilityBadge::State::passed : PlausibilityBadge::State::failed);
  }
  m_empty->setVisible(checks.empty());
  explain();
}

void PlausibilityBadges::setPending() {
  m_empty->setText(tr("Checking..."));
  for (PlausibilityBadge* badge : m_badges) badge->setState(PlausibilityBadge::State::unknown);
}

void PlausibilityBadges::clear() {
  for (PlausibilityBadge* badge : m_badges) badge->setChecked(false);
  m_empty->setText(tr("Open a material to check it."));
  setChecks({});
}

void PlausibilityBadges::explain() {
  const int index = current();
  const bool open = index >= 0 && index < int(m_checks.size());
  m_explanation->setVisible(open);
  m_show->setVisible(open && m_checks[std::size_t(index)].at);
  if (open) m_explanation->setText(plausibilityText(m_checks[std::size_t(index)]));
}

}  // namespace gonio::widgets

#include "moc_plausibility_badges.cpp"
