// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_overlay.h"

#include <QFocusEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "widgets/preview/false_colour_legend.h"
#include "widgets/preview/split_bar.h"

namespace gonio::widgets {

PreviewBanner::PreviewBanner(QWidget* viewport)
    : QFrame(viewport), m_text(new QLabel(this)), m_button(new QPushButton(this)) {
  setObjectName(QStringLiteral("previewBanner"));
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  m_text->setTextFormat(Qt::PlainText);
  m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 3, 3, 3);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_button);
  connect(m_button, &QPushButton::clicked, this, &PreviewBanner::dismissed);
  hide();
}

void PreviewBanner::showText(const QString& text, const QString& button) {
  m_whole = text;
  m_text->setToolTip(text);
  m_text->setMinimumWidth(0);
  m_text->setText(text);
  m_button->setText(button);
  setVisible(!text.isEmpty());
  elide();
}

QSize PreviewBanner::sizeHint() const {
  const QMargins margins = layout()->contentsMargins();
  const QSize button = m_button->sizeHint();
  return {fontMetrics().horizontalAdvance(m_whole) + button.width() + layout()->spacing() + margins.left() +
              margins.right() + 2 * frameWidth() + fontMetrics().averageCharWidth(),
          button.height() + margins.top() + margins.bottom() + 2 * frameWidth()};
}

void PreviewBanner::elide() {
  m_text->setText(fontMetrics().elidedText(m_whole, Qt::ElideMiddle, std::max(1, m_text->width())));
}

void PreviewBanner::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  elide();
}

namespace {
constexpr int edgeMargin = 10;
}

QString samplesText(int samples) {
  return samples == 1 ? PreviewOverlay::tr("1 sample") : PreviewOverlay::tr("%1 samples").arg(samples);
}

QString effectsText(const rendering::EffectPlan& plan, int followed) {
  QStringList parts;
  if (plan.simulates(rendering::Effect::environmentLight)) parts << PreviewOverlay::tr("environment");
  if (plan.simulates(rendering::Effect::directLight)) parts << PreviewOverlay::tr("lights");
  if (plan.simulates(rendering::Effect::castShadows) || plan.simulates(rendering::Effect::selfShadowing))
    parts << PreviewOverlay::tr("shadows");
  if (plan.reflections > followed)
    parts << PreviewOverlay::tr("%1 of %2 reflections").arg(followed).arg(plan.reflections);
  else if (plan.reflections > 1)
    parts << PreviewOverlay::tr("%1 reflections").arg(plan.reflections);
  return parts.isEmpty() ? PreviewOverlay::tr("No light") : PreviewOverlay::tr("Effects: %1").arg(parts.join(", "));
}

PreviewOverlay::PreviewOverlay(QWidget* viewport)
    : QObject(viewport),
      m_viewport(viewport),
      m_status(addLabel()),
      m_hint(new QLabel(viewport)),
      m_names{addLabel(), addLabel()},
      m_banner(new PreviewBanner(viewport)),
      m_split(new SplitBar(viewport)),
      m_legend(new FalseColourLegend(viewport)),
      m_ring(new QFrame(viewport)) {
  m_hint->setStyleSheet("color: #c8c8c8; background: transparent;");
  m_hint->setAlignment(Qt::AlignCenter);
  m_hint->setWordWrap(true);
  m_hint->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_split->hide();
  m_legend->hide();
  m_ring->setStyleSheet("border: 2px solid palette(highlight); background: transparent;");
  m_ring->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_ring->hide();
  viewport->installEventFilter(this);
}

QLabel* PreviewOverlay::addLabel() {
  auto* label = new QLabel(m_viewport);
  label->setStyleSheet("background: rgba(0, 0, 0, 150); color: #e8e8e8; padding: 4px 8px; border-radius: 4px;");
  label->setTextFormat(Qt::PlainText);
  label->setAttribute(Qt::WA_TransparentForMouseEvents);
  label->hide();
  return label;
}

void PreviewOverlay::setStatusWanted(bool wanted) {
  m_statusWanted = wanted;
  m_status->setVisible(wanted && !m_status->text().isEmpty());
}

void PreviewOverlay::setStatus(const QString& text) {
  m_status->setText(text);
  setStatusWanted(m_statusWanted);
  place();
}

void PreviewOverlay::setHint(const QString& text) {
  m_hint->setText(text);
  m_hint->setVisible(!text.isEmpty());
}

void PreviewOverlay::setComparison(const PreviewComparison& shown, const std::array<QString, 2>& names,
                                   bool flickering) {
  m_mode = flickering ? CompareMode::flicker : shown.mode;
  const bool both = m_mode == CompareMode::split || m_mode == CompareMode::twoUp;
  m_names[0]->setText(m_mode == CompareMode::difference ? tr("%1 against %2").arg(names[0], names[1])
                      : flickering                      ? names[1]
                                                        : names[0]);
  m_names[1]->setText(names[1]);
  m_names[0]->setVisible(m_mode != CompareMode::off);
  m_names[1]->setVisible(both);
  m_split->setPosition(shown.split);
  // Qt would pass the focus on to the list of scenes, of which a letter would choose another.
  if (m_mode != CompareMode::split && m_split->hasFocus()) m_viewport->setFocus(Qt::OtherFocusReason);
  m_split->setVisible(m_mode == CompareMode::split);
  m_legend->setVisible(m_mode == CompareMode::difference);
  place();
}

void PreviewOverlay::setRange(DifferenceKind kind, double range) { m_legend->setDifference(kind, range); }

void PreviewOverlay::setBanner(const QString& text, const QString& button) {
  if (text == m_banner->text() && (text.isEmpty() || button == m_banner->button()->text())) return;
  if (text.isEmpty() && m_banner->button()->hasFocus()) m_viewport->setFocus(Qt::OtherFocusReason);
  m_banner->showText(text, button);
  place();
}

void PreviewOverlay::drawLabels(QPainter& painter) const {
  for (QWidget* part : std::initializer_list<QWidget*>{m_split, m_names[0], m_names[1], m_legend})
    if (!part->isHidden()) part->render(&painter, part->pos(), {}, QWidget::DrawChildren);
}

void PreviewOverlay::place() {
  const int width = m_viewport->width(), height = m_viewport->height();
  m_banner->resize(std::min(m_banner->sizeHint().width(), width - 2 * edgeMargin), m_banner->sizeHint().height());
  m_banner->move((width - m_banner->width()) / 2, edgeMargin);
  const int top = edgeMargin + (m_banner->isHidden() ? 0 : m_banner->height() + edgeMargin);
  m_ring->setGeometry(m_viewport->rect());
  m_hint->setGeometry(m_viewport->rect().adjusted(4 * edgeMargin, 4 * edgeMargin, -4 * edgeMargin, -4 * edgeMargin));
  m_status->adjustSize();
  m_status->move(edgeMargin, height - m_status->height() - edgeMargin);
  for (QLabel* name : m_names) name->adjustSize();
  m_names[0]->move(edgeMargin, top);
  m_names[1]->move(m_mode == CompareMode::twoUp ? width / 2 + edgeMargin : width - m_names[1]->width() - edgeMargin,
                   top);
  const QSize wanted = m_legend->sizeHint();
  m_legend->resize(std::min(wanted.width(), width - 2 * edgeMargin), wanted.height());
  const int below = m_status->isVisible() ? m_status->height() + edgeMargin : 0;
  m_legend->move(edgeMargin, height - m_legend->height() - edgeMargin - below);
}

bool PreviewOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_viewport && event->type() == QEvent::Resize) place();
  if (watched == m_viewport && event->type() == QEvent::FocusOut) m_ring->hide();
  if (watched == m_viewport && event->type() == QEvent::FocusIn) {
    // The hand that clicks knows where it is: a ring about the picture would be in its way.
    const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
    m_ring->setVisible(reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace gonio::widgets

#include "moc_preview_overlay.cpp"
