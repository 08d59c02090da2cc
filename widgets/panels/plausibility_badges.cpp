// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/plausibility_badges.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <cmath>

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
  const QString outcome = state == State::passed     ? tr("passed")
                          : state == State::failed   ? tr("failed")
                          : state == State::inherent ? tr("a property of the measurement")
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
  const char* icon = m_state == State::passed     ? "passed"
                     : m_state == State::failed   ? "warning"
                     : m_state == State::inherent ? "note"
                                                  : "pending";
  paintIcon(painter, QString::fromLatin1(icon), QRectF(line * 0.6, (height() - line) / 2, line, line));
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
  m_explanation->setObjectName(QStringLiteral("explanation"));
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

bool PlausibilityBadges::isInherent(const metrics::PlausibilityCheck& check) const {
  return m_untouched && !check.passed && check.name == "reciprocity";
}

void PlausibilityBadges::setChecks(const std::vector<metrics::PlausibilityCheck>& checks, bool untouched) {
  m_checks = checks;
  m_untouched = untouched;
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
    m_badges[i]->setState(checks[i].passed        ? PlausibilityBadge::State::passed
                          : isInherent(checks[i]) ? PlausibilityBadge::State::inherent
                                                  : PlausibilityBadge::State::failed);
  }
  m_empty->setVisible(checks.empty());
  explain();
}

void PlausibilityBadges::setPending() {
  m_empty->setText(tr("Checking..."));
  for (PlausibilityBadge* badge : m_badges)
    if (badge->state() != PlausibilityBadge::State::unknown) badge->setState(PlausibilityBadge::State::unknown);
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
  if (!open) return;
  const metrics::PlausibilityCheck& check = m_checks[std::size_t(index)];
  m_explanation->setText(plausibilityText(check, isInherent(check)));
}

// What the checks of plausibility mean, for people.

namespace {

struct PlausibilityText {
  Q_DECLARE_TR_FUNCTIONS(PlausibilityText)
};
QString number(double value) { return QString::number(value, 'g', 3); }
QString percent(double fraction) { return QStringLiteral("%1 %").arg(number(100 * fraction)); }

struct Text {
  QString word, meaning, worst, remedy;
};

QString where(const metrics::PlausibilityCheck& check) {
  if (!check.at) return {};
  const double o = degrees(polarAngle(check.at->wo));
  if (check.name == "energy") return PlausibilityText::tr("for a viewer at %1°").arg(o, 0, 'f', 0);
  return PlausibilityText::tr("for light at %1°, viewer at %2°, %3° apart in azimuth")
      .arg(degrees(polarAngle(check.at->wi)), 0, 'f', 0)
      .arg(o, 0, 'f', 0)
      .arg(std::abs(degrees(std::remainder(azimuth(check.at->wi) - azimuth(check.at->wo), 2 * pi))), 0, 'f', 0);
}

Text textOf(const metrics::PlausibilityCheck& check) {
  if (check.name == "energy")
    return {PlausibilityText::tr("Energy"),
            PlausibilityText::tr(
                "A surface reflects at most the light that it receives: the directional albedo is at most 1."),
            PlausibilityText::tr("Maximum albedo: %1 (limit %2)").arg(number(check.worst), number(check.limit)),
            PlausibilityText::tr("Lower the specular strength or the diffuse colour, or raise the roughness.")};
  if (check.name == "reciprocity")
    return {
        PlausibilityText::tr("Reciprocity"),
        PlausibilityText::tr("Exchanging light and viewer does not change the BRDF value."),
        PlausibilityText::tr("Maximum difference: %1 of the value (limit %2)")
            .arg(percent(check.worst), percent(check.limit)),
        PlausibilityText::tr("Choose a reciprocal model; the tooltip of each model states whether it is reciprocal. "
                             "Measured RGL and UTIA files are reciprocal only if \"Incident direction\" in the section "
                             "\"Source\" is set to \"Mean of both (reciprocal)\".")};
  if (check.name == "negative")
    return {PlausibilityText::tr("Non-negative"),
            PlausibilityText::tr("BRDF values are at least 0. Where an edit subtracts more than was measured, the "
                                 "image shows black patches."),
            check.worst > 0 ? PlausibilityText::tr("Negative at %1 of the directions; most negative value: %2 1/sr")
                                  .arg(percent(check.fraction), number(-check.worst))
                            : PlausibilityText::tr("No negative values"),
            PlausibilityText::tr("Reduce the edit, or fit a model that explains the measurement better.")};
  if (check.name == "non-finite")
    return {PlausibilityText::tr("Finite"), PlausibilityText::tr("Every BRDF value is a finite number."),
            PlausibilityText::tr("Values that are not finite: %1").arg(check.worst),
            PlausibilityText::tr(
                "This is an error in the program: undo the last change to continue, and please report the error.")};
  return {
      PlausibilityText::tr("Complete"),
      PlausibilityText::tr("Where the table has no data, the image is black or uses the values of neighbouring cells."),
      PlausibilityText::tr("Fraction of directions without data, weighted by both cosines: %1 (limit %2)")
          .arg(percent(check.worst), percent(check.limit)),
      PlausibilityText::tr("Treat angles without data with caution.")};
}

}  // namespace

QString plausibilityWord(const metrics::PlausibilityCheck& check) { return textOf(check).word; }

QString plausibilityText(const metrics::PlausibilityCheck& check, bool inherent) {
  const Text text = textOf(check);
  const bool locate = check.at && (check.worst > 0 || !check.passed);
  const QString worst = locate ? PlausibilityText::tr("%1, %2.").arg(text.worst, where(check))
                               : PlausibilityText::tr("%1.").arg(text.worst);
  return QStringLiteral("<p><b>%1</b> %2</p><p>%3</p>%4")
      .arg(check.passed ? PlausibilityText::tr("Passed.")
           : inherent   ? PlausibilityText::tr("A property of the measurement.")
                        : PlausibilityText::tr("Failed."),
           text.meaning.toHtmlEscaped(), worst.toHtmlEscaped(),
           check.passed || inherent ? QString() : QStringLiteral("<p>%1</p>").arg(text.remedy.toHtmlEscaped()));
}

}  // namespace gonio::widgets

#include "moc_plausibility_badges.cpp"
