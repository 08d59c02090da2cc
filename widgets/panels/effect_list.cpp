// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/effect_list.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>

namespace gonio::widgets {

namespace {

enum Choice { byPlan, forcedOn, forcedOff };

struct EffectText {
  const char *name, *toolTip;
};
/// In the order of Effect.
constexpr EffectText texts[rendering::effectCount] = {
    {QT_TRANSLATE_NOOP("EffectList", "Emitted light"),
     QT_TRANSLATE_NOOP("EffectList", "Area lights and the environment, where the camera sees them directly")},
    {QT_TRANSLATE_NOOP("EffectList", "Direct light"),
     QT_TRANSLATE_NOOP("EffectList", "Light from distant, point and area lights after one reflection")},
    {QT_TRANSLATE_NOOP("EffectList", "Environment light"),
     QT_TRANSLATE_NOOP("EffectList", "Light from the environment after one reflection")},
    {QT_TRANSLATE_NOOP("EffectList", "Cast shadows"),
     QT_TRANSLATE_NOOP("EffectList", "Shadows that one object casts on another")},
    {QT_TRANSLATE_NOOP("EffectList", "Self-shadowing"),
     QT_TRANSLATE_NOOP("EffectList", "Shadows that an object casts on itself; only where it is not convex")},
    {QT_TRANSLATE_NOOP("EffectList", "Interreflection"),
     QT_TRANSLATE_NOOP("EffectList", "Light after two or more reflections")},
    {QT_TRANSLATE_NOOP("EffectList", "Anisotropic frames"),
     QT_TRANSLATE_NOOP("EffectList", "Tangent directions on the surface, which anisotropic materials need")},
    {QT_TRANSLATE_NOOP("EffectList", "Area light sampling"),
     QT_TRANSLATE_NOOP("EffectList", "Samples points on area lights, which lowers the noise")},
};

QString costText(const rendering::EffectCosts& costs, const rendering::EffectCost& cost) {
  if (cost.isWithinNoise()) return EffectList::tr("within noise");
  const double fraction = costs.seconds > 0 ? 100 * cost.seconds / costs.seconds : 0;
  return EffectList::tr("%1 ms (%2 %)").arg(1000 * cost.seconds, 0, 'f', 1).arg(fraction, 0, 'f', 0);
}

QString costToolTip(const rendering::EffectCost& cost) {
  return EffectList::tr(
             "CPU time that the effect adds to the image: %1 ± %2 ms. The effect changes the image by %3 %; noise "
             "alone changes it by %4 %.")
      .arg(1000 * cost.seconds, 0, 'f', 1)
      .arg(1000 * cost.secondsNoise, 0, 'f', 1)
      .arg(100 * cost.difference, 0, 'g', 2)
      .arg(100 * cost.noise, 0, 'g', 2);
}

}  // namespace

EffectList::EffectList(QWidget* parent) : QWidget(parent) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setVerticalSpacing(2);
  layout->setHorizontalSpacing(fontMetrics().averageCharWidth() * 2);
  int column = 0;
  for (const QString& title : {tr("Effect"), tr("Simulated"), tr("Mode"), tr("Cost"), tr("Reason")}) {
    auto* label = new QLabel(title);
    label->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(label, 0, column++);
  }
  layout->setColumnStretch(4, 1);
  for (std::size_t i = 0; i < rendering::effectCount; ++i) addRow(rendering::Effect(i));
  setCosts(std::nullopt);
}

void EffectList::addRow(rendering::Effect effect) {
  auto* layout = static_cast<QGridLayout*>(this->layout());
  const EffectText& text = texts[std::size_t(effect)];
  const QString name = QCoreApplication::translate("EffectList", text.name);
  Row& row = m_rows[std::size_t(effect)];
  row = {new QLabel, new QLabel(name), new QLabel, new QLabel, new QComboBox};
  row.name->setToolTip(QCoreApplication::translate("EffectList", text.toolTip));
  row.choice->addItems({tr("auto"), tr("on"), tr("off")});
  row.choice->setAccessibleName(tr("%1: auto, on or off").arg(name));
  row.choice->setToolTip(
      tr("auto: simulated if the scene needs it.\n"
         "on: always, to verify that an effect left out by auto does not change the image.\n"
         "off: never, to see what the effect contributes."));
  row.choice->setFocusPolicy(Qt::StrongFocus);
  row.cost->setObjectName(QStringLiteral("cost"));
  row.cost->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row.reason->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row.reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
  const int at = int(effect) + 1;
  int column = 0;
  for (QWidget* part : std::initializer_list<QWidget*>{row.name, row.state, row.choice, row.cost, row.reason})
    layout->addWidget(part, at, column++);
  connect(row.choice, &QComboBox::activated, this, [this] { Q_EMIT overridesChanged(overrides()); });
}

void EffectList::setPlan(const rendering::EffectPlan& plan) {
  for (std::size_t i = 0; i < rendering::effectCount; ++i) {
    const rendering::EffectDecision& decision = plan.decisions[i];
    const bool forced = decision.simulated != decision.calledFor;
    QString state = decision.simulated ? tr("yes") : tr("no");
    if (forced) state += tr(", forced");
    m_rows[i].state->setText(state);
    for (QLabel* label : {m_rows[i].state, m_rows[i].name}) {
      QFont font = label->font();
      font.setBold(decision.simulated);
      label->setFont(font);
    }
    const QString reason = QString::fromStdString(decision.reason);
    m_rows[i].reason->setText(reason);
    m_rows[i].reason->setToolTip(reason);
  }
}

void EffectList::setCosts(const std::optional<rendering::EffectCosts>& costs) {
  for (std::size_t i = 0; i < rendering::effectCount; ++i) {
    QLabel& label = *m_rows[i].cost;
    label.setEnabled(costs.has_value());
    label.setText(costs ? costText(*costs, costs->effects[i]) : tr("-"));
    label.setToolTip(costs ? costToolTip(costs->effects[i]) : tr("Not measured yet"));
  }
}

void EffectList::setOverrides(const rendering::EffectOverrides& overrides) {
  for (std::size_t i = 0; i < rendering::effectCount; ++i)
    m_rows[i].choice->setCurrentIndex(!overrides[i] ? byPlan : *overrides[i] ? forcedOn : forcedOff);
}

rendering::EffectOverrides EffectList::overrides() const {
  rendering::EffectOverrides overrides;
  for (std::size_t i = 0; i < rendering::effectCount; ++i)
    if (const int choice = m_rows[i].choice->currentIndex(); choice != byPlan) overrides[i] = choice == forcedOn;
  return overrides;
}

}  // namespace gonio::widgets

#include "moc_effect_list.cpp"
