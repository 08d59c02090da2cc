// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/colour_picker.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QScreen>
#include <algorithm>
#include <cmath>

#include "core/math/types.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

namespace gonio::widgets {

namespace {

QColor fromHsv(double hue, double saturation, double value) {
  return QColor::fromHsvF(float(std::clamp(hue, 0.0, 1.0)), float(saturation), float(value));
}

/// The two colours beside each other, the one before on the left.
class Swatches : public QWidget {
 public:
  QColor before, after;

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const int half = width() / 2;
    painter.fillRect(0, 0, half, height(), before);
    painter.fillRect(half, 0, width() - half, height(), after);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
};

}  // namespace

ColourWheel::ColourWheel(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Colour wheel"));
  setToolTip(tr("Hue around the centre, saturation away from it; the arrow keys change them too"));
}

QSize ColourWheel::sizeHint() const {
  constexpr int lines = 13;
  return QSize(lines, lines) * fontMetrics().height();
}

QRectF ColourWheel::disc() const {
  const double margin = fontMetrics().height() / 2.0, side = std::min(width(), height()) - 2 * margin;
  return {(width() - side) / 2, (height() - side) / 2, side, side};
}

void ColourWheel::setHsv(double hue, double saturation, double value) {
  m_hue = hue;
  m_saturation = saturation;
  m_value = value;
  update();
}

void ColourWheel::paintEvent(QPaintEvent*) {
  const QRectF area = disc();
  const QSize pixels = (area.size() * devicePixelRatioF()).toSize();
  if (m_colours.size() != pixels || m_painted != m_value) {
    m_painted = m_value;
    m_colours = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
    const double radius = pixels.width() / 2.0;
    for (int y = 0; y < pixels.height(); ++y)
      for (int x = 0; x < pixels.width(); ++x) {
        const double dx = (x + 0.5) / radius - 1, dy = 1 - (y + 0.5) / radius, distance = std::hypot(dx, dy);
        const double turn = std::atan2(dy, dx) / (2 * pi);
        // The edge is smooth over one pixel.
        const double coverage = std::clamp((1 - distance) * radius, 0.0, 1.0);
        QColor colour = fromHsv(turn < 0 ? turn + 1 : turn, std::min(distance, 1.0), m_value);
        colour.setAlphaF(float(coverage));
        m_colours.setPixel(x, y, qPremultiply(colour.rgba()));
      }
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.drawImage(area, m_colours);
  const double angle = 2 * pi * m_hue, reach = m_saturation * area.width() / 2;
  const QPointF place = area.center() + QPointF(std::cos(angle), -std::sin(angle)) * reach;
  painter.setBrush(fromHsv(m_hue, m_saturation, m_value));
  for (const auto& [colour, width] : {std::pair(QColor(Qt::black), 4.0), std::pair(QColor(Qt::white), 2.0)}) {
    painter.setPen(QPen(colour, width));
    painter.drawEllipse(place, 6, 6);
  }
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
  painter.drawEllipse(area.adjusted(-3, -3, 3, 3));
}

void ColourWheel::editAt(const QPointF& place) {
  const QRectF area = disc();
  const QPointF offset = (place - area.center()) / (area.width() / 2);
  const double turn = std::atan2(-offset.y(), offset.x()) / (2 * pi);
  Q_EMIT edited(turn < 0 ? turn + 1 : turn, std::min(1.0, std::hypot(offset.x(), offset.y())));
}

void ColourWheel::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) editAt(event->position());
}

void ColourWheel::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) editAt(event->position());
}

void ColourWheel::keyPressEvent(QKeyEvent* event) {
  constexpr double hueStep = 1 / 72.0, saturationStep = 0.02;
  const double turn = event->key() == Qt::Key_Left ? hueStep : event->key() == Qt::Key_Right ? -hueStep : 0;
  const double out = event->key() == Qt::Key_Up ? saturationStep : event->key() == Qt::Key_Down ? -saturationStep : 0;
  if (turn == 0 && out == 0) return QWidget::keyPressEvent(event);
  const double hue = m_hue + turn;
  Q_EMIT edited(hue - std::floor(hue), std::clamp(m_saturation + out, 0.0, 1.0));
}

ColourPicker::ColourPicker(const QColor& colour, QWidget* parent)
    : QDialog(parent), m_before(colour), m_wheel(new ColourWheel), m_digits(new QLineEdit), m_swatches(new Swatches) {
  static_cast<Swatches*>(m_swatches)->before = colour;
  m_swatches->setMinimumHeight(2 * fontMetrics().height());
  m_swatches->setToolTip(tr("The colour before, and the new one"));
  auto* pick = new QPushButton(tr("&Pick from Screen"));
  pick->setToolTip(tr("Takes a colour from anywhere on the screen, such as from the preview; Escape cancels"));
  pick->setAutoDefault(false);
  connect(pick, &QPushButton::clicked, this, &ColourPicker::pickFromScreen);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout;
  column->addWidget(buildComponents());
  column->addWidget(m_swatches);
  column->addStretch();
  column->addWidget(pick, 0, Qt::AlignLeft);
  auto* row = new QHBoxLayout;
  row->addWidget(m_wheel, 1);
  row->addLayout(column, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(row, 1);
  layout->addWidget(buttons);
  connect(m_wheel, &ColourWheel::edited, this, [this](double hue, double saturation) {
    m_hsv[0] = hue;
    m_hsv[1] = saturation;
    showColour();
    Q_EMIT colourChanged(this->colour());
  });
  setColour(colour);
}

QWidget* ColourPicker::buildComponents() {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  const QString names[] = {tr("&Hue"), tr("&Saturation"), tr("&Value")};
  constexpr std::array<double, 3> scales = {360, 100, 100};
  const QString units[] = {QStringLiteral("°"), QStringLiteral("%"), QStringLiteral("%")};
  for (std::size_t i = 0; i < 3; ++i) {
    auto* slider = m_sliders[i] = new ParameterSlider;
    auto* field = m_fields[i] = new NumberField;
    slider->setRange(0, 1, models::ParameterScale::linear);
    field->setRange(0, 1);
    field->setUnit(units[i], scales[i]);
    field->setFixedWidth(fontMetrics().height() * 5);
    auto* label = new QLabel(names[i]);
    label->setBuddy(field);
    for (QWidget* part : std::initializer_list<QWidget*>{slider, field})
      part->setAccessibleName(QString(names[i]).remove('&'));
    const auto row = int(i);
    grid->addWidget(label, row, 0);
    grid->addWidget(slider, row, 1);
    grid->addWidget(field, row, 2);
    connect(slider, &ParameterSlider::numberEdited, this, [this, i](double value) { setComponent(i, value); });
    connect(field, &NumberField::valueEdited, this, [this, i](double value) { setComponent(i, value); });
  }
  auto* label = new QLabel(tr("sRGB (h&ex)"));
  label->setBuddy(m_digits);
  m_digits->setAccessibleName(tr("sRGB value, hexadecimal"));
  grid->addWidget(label, 3, 0);
  grid->addWidget(m_digits, 3, 1, 1, 2);
  grid->setColumnStretch(1, 1);
  connect(m_digits, &QLineEdit::textEdited, this, [this](const QString& text) {
    const QColor typed(text.startsWith('#') ? text : '#' + text);
    if (!typed.isValid() || text.count(QLatin1Char('#')) > 1 || QString(text).remove('#').size() != 6) return;
    setColour(typed);
    Q_EMIT colourChanged(colour());
  });
  return box;
}

QColor ColourPicker::colour() const { return fromHsv(m_hsv[0], m_hsv[1], m_hsv[2]); }

void ColourPicker::setColour(const QColor& colour) {
  const double hue = colour.hsvHueF();
  if (hue >= 0) m_hsv[0] = hue;
  m_hsv[1] = colour.hsvSaturationF();
  m_hsv[2] = colour.valueF();
  showColour();
}

void ColourPicker::setComponent(std::size_t component, double value) {
  m_hsv[component] = value;
  showColour();
  Q_EMIT colourChanged(colour());
}

void ColourPicker::showColour() {
  m_wheel->setHsv(m_hsv[0], m_hsv[1], m_hsv[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    m_sliders[i]->setNumber(m_hsv[i]);
    m_fields[i]->setValue(m_hsv[i]);
  }
  if (!m_digits->hasFocus()) m_digits->setText(colour().name());
  static_cast<Swatches*>(m_swatches)->after = colour();
  m_swatches->update();
}

void ColourPicker::pickFromScreen() {
  m_picking = true;
  m_beforePicking = colour();
  grabMouse(Qt::CrossCursor);
  grabKeyboard();
  setMouseTracking(true);
}

void ColourPicker::endPicking(bool accept) {
  m_picking = false;
  setMouseTracking(false);
  releaseMouse();
  releaseKeyboard();
  if (accept) return;
  setColour(m_beforePicking);
  Q_EMIT colourChanged(colour());
}

void ColourPicker::mouseMoveEvent(QMouseEvent* event) {
  if (!m_picking) return QDialog::mouseMoveEvent(event);
  const QPoint place = event->globalPosition().toPoint();
  QScreen* screen = QGuiApplication::screenAt(place);
  if (!screen) return;
  const QPoint local = place - screen->geometry().topLeft();
  const QImage pixel = screen->grabWindow(0, local.x(), local.y(), 1, 1).toImage();
  if (pixel.isNull()) return;  // the window system does not allow it
  setColour(pixel.pixelColor(0, 0));
  Q_EMIT colourChanged(colour());
}

void ColourPicker::mouseReleaseEvent(QMouseEvent* event) {
  if (!m_picking) return QDialog::mouseReleaseEvent(event);
  mouseMoveEvent(event);
  endPicking(true);
}

void ColourPicker::keyPressEvent(QKeyEvent* event) {
  if (!m_picking) return QDialog::keyPressEvent(event);
  if (event->key() == Qt::Key_Escape) endPicking(false);
}

}  // namespace gonio::widgets

#include "moc_colour_picker.cpp"
