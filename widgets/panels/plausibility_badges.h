// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractButton>
#include <vector>

#include "core/metrics/plausibility.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace gonio::widgets {

/// A word with a symbol: passed, failed, a property of the measurement, or not known yet. Does not rely on colour.
class PlausibilityBadge : public QAbstractButton {
  Q_OBJECT

 public:
  enum class State { unknown, passed, failed, inherent };
  explicit PlausibilityBadge(QWidget* parent = nullptr);

  void setState(State state);
  State state() const { return m_state; }

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  State m_state = State::unknown;
};

/// A badge per plausibility check. Pressing one shows its meaning, the worst value with its directions, advice, and a
/// button that plots the checked quantity.
class PlausibilityBadges : public QWidget {
  Q_OBJECT

 public:
  explicit PlausibilityBadges(QWidget* parent = nullptr);

  /// @param untouched whether the material has no edits: a measurement that is not reciprocal is not a fault then.
  void setChecks(const std::vector<metrics::PlausibilityCheck>& checks, bool untouched = false);
  /// The checks are out of date: shows them as not known yet, with their last text.
  void setPending();
  /// Nothing to check.
  void clear();

 Q_SIGNALS:
  /// The user wants to display a check ("energy", "reciprocity", ...). @param theta polar angle of the worst value,
  /// rad: of the viewer for energy, of the light for the other checks.
  void showRequested(const QString& check, double theta);

 private:
  void explain();
  int current() const;
  bool isInherent(const metrics::PlausibilityCheck& check) const;

  std::vector<metrics::PlausibilityCheck> m_checks;
  bool m_untouched = false;
  std::vector<PlausibilityBadge*> m_badges;
  QGridLayout* m_grid;
  QLabel *m_empty, *m_explanation;
  QPushButton* m_show;
};

/// The word of a check, and rich text about it. @param inherent whether a check that failed states a property of the
/// measurement, which needs no remedy.
QString plausibilityWord(const metrics::PlausibilityCheck& check);
QString plausibilityText(const metrics::PlausibilityCheck& check, bool inherent = false);

}  // namespace gonio::widgets
