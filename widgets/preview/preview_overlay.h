// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFrame>
#include <QLabel>
#include <array>

#include "core/rendering/effect_plan.h"
#include "widgets/preview/gl/preview_comparison.h"

class QLabel;
class QPushButton;

namespace gonio::widgets {

/// A line over the preview that states that something other than the material is shown, with a button to end this.
class PreviewBanner : public QFrame {
  Q_OBJECT

 public:
  explicit PreviewBanner(QWidget* viewport);

  /// An empty text hides it.
  void showText(const QString& text, const QString& button);
  QString text() const { return m_whole; }
  QPushButton* button() const { return m_button; }
  QSize sizeHint() const override;

 Q_SIGNALS:
  void dismissed();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();

  QString m_whole;
  QLabel* m_text;
  QPushButton* m_button;
};

/// "1 sample", "64 samples".
QString samplesText(int samples);
/// Short description of the simulated effects, e.g. "Effects: environment, shadows, 8 of 64 reflections".
/// @param followed maximum number of reflections that are rendered.
QString effectsText(const rendering::EffectPlan& plan, int followed);

class FalseColourLegend;
class SplitBar;

/// The overlays of the preview's picture: facts about the frame, a ring for keyboard focus, a hint if it is empty, a
/// banner if something other than the material is shown, and for a comparison the names of the sides, the split bar and
/// the legend of the difference.
class PreviewOverlay : public QObject {
  Q_OBJECT

 public:
  explicit PreviewOverlay(QWidget* viewport);

  void setStatusWanted(bool wanted);
  bool statusWanted() const { return m_statusWanted; }
  /// An empty text hides it.
  void setStatus(const QString& text);
  /// In the middle; an empty text hides it.
  void setHint(const QString& text);

  /// @param shown the displayed comparison; mode off hides all.
  void setComparison(const PreviewComparison& shown, const std::array<QString, 2>& names, bool flickering);
  void setRange(DifferenceKind kind, double range);

  /// At the top; an empty text hides it.
  void setBanner(const QString& text, const QString& button);

  /// Draws the parts that belong to the picture (names, divider, legend), in the viewport's coordinates.
  void drawLabels(QPainter& painter) const;

  PreviewBanner* banner() const { return m_banner; }
  SplitBar* splitBar() const { return m_split; }
  FalseColourLegend* legend() const { return m_legend; }
  QLabel* name(std::size_t side) const { return m_names[side]; }
  bool hasFocusRing() const { return !m_ring->isHidden(); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QLabel* addLabel();
  void place();

  QWidget* m_viewport;
  QLabel *m_status, *m_hint;
  std::array<QLabel*, 2> m_names;
  PreviewBanner* m_banner;
  SplitBar* m_split;
  FalseColourLegend* m_legend;
  QFrame* m_ring;
  CompareMode m_mode = CompareMode::off;
  bool m_statusWanted = true;
};

}  // namespace gonio::widgets
