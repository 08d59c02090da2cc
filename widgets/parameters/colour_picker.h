// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QColor>
#include <QDialog>
#include <QImage>
#include <array>

class QLineEdit;
class QPushButton;

namespace gonio::widgets {

class NumberField;
class ParameterSlider;

/// A disc of colours: the hue is the angle, the saturation the distance from the centre. Arrow keys turn the hue and
/// change the saturation.
class ColourWheel : public QWidget {
  Q_OBJECT

 public:
  explicit ColourWheel(QWidget* parent = nullptr);

  /// Hue, saturation and value in [0, 1]; emits nothing.
  void setHsv(double hue, double saturation, double value);
  QSize sizeHint() const override;

 Q_SIGNALS:
  void edited(double hue, double saturation);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF disc() const;
  void editAt(const QPointF& place);

  double m_hue = 0, m_saturation = 0, m_value = 1;
  QImage m_colours;      ///< of the disc
  double m_painted = 0;  ///< value of m_colours
};

/// A dialog for a colour: a wheel, hue, saturation and value, the sRGB value as hexadecimal digits, the colours before
/// and after, and a colour from the screen. Each change is emitted at once.
class ColourPicker : public QDialog {
  Q_OBJECT

 public:
  ColourPicker(const QColor& colour, QWidget* parent);

  QColor colour() const;
  ColourWheel& wheel() const { return *m_wheel; }
  NumberField& field(std::size_t component) const { return *m_fields[component]; }
  QLineEdit& digits() const { return *m_digits; }

 Q_SIGNALS:
  void colourChanged(const QColor& colour);

 protected:
  /// While a colour is taken from the screen.
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* buildComponents();
  void setColour(const QColor& colour);
  void setComponent(std::size_t component, double value);
  void showColour();
  void pickFromScreen();
  void endPicking(bool accept);

  std::array<double, 3> m_hsv{};  ///< kept apart from the colour: a grey has no hue of its own
  QColor m_before, m_beforePicking;
  bool m_picking = false;
  ColourWheel* m_wheel;
  std::array<ParameterSlider*, 3> m_sliders{};
  std::array<NumberField*, 3> m_fields{};
  QLineEdit* m_digits;
  QWidget* m_swatches;
};

}  // namespace gonio::widgets
