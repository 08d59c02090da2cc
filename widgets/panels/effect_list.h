// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <optional>

#include "core/rendering/effect_costs.h"

class QComboBox;
class QLabel;

namespace gonio::widgets {

/// The effect plan of a scene, one row per effect: whether it is simulated, the reason, the measured cost, and a switch
/// that forces it on or off.
class EffectList : public QWidget {
  Q_OBJECT

 public:
  explicit EffectList(QWidget* parent = nullptr);

  void setPlan(const rendering::EffectPlan& plan);
  /// Empty: not measured.
  void setCosts(const std::optional<rendering::EffectCosts>& costs);
  void setOverrides(const rendering::EffectOverrides& overrides);
  rendering::EffectOverrides overrides() const;

 Q_SIGNALS:
  /// By the user.
  void overridesChanged(const gonio::rendering::EffectOverrides& overrides);

 private:
  struct Row {
    QLabel *state, *name, *cost, *reason;
    QComboBox* choice;
  };
  void addRow(rendering::Effect effect);

  std::array<Row, rendering::effectCount> m_rows{};
};

}  // namespace gonio::widgets
