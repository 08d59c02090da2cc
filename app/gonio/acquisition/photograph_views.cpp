// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/photograph_views.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "app/gonio/matching/reference_view.h"
#include "app/gonio/scene/scene_panel.h"
#include "core/rendering/environment.h"
#include "widgets/acquisition/residual_view.h"
#include "widgets/acquisition/uncertainty_curve.h"
#include "widgets/inputs/number_field.h"
#include "widgets/interpolation/sphere_picture.h"

namespace gonio::app {

/// A picture of a sphere, as large as the widget permits.
class SphereView : public QWidget {
 public:
  void setPicture(const QImage& picture) {
    m_picture = picture;
    update();
  }
  QSize minimumSizeHint() const override { return QSize(5, 5) * fontMetrics().height(); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = std::min(width(), height());
    widgets::paintSphere(painter, m_picture, {(width() - side) / 2, (height() - side) / 2, side, side}, palette());
  }

 private:
  QImage m_picture;
};

namespace {

constexpr int stripSide = 52;

QLabel* captionLabel() {
  auto* label = new QLabel;
  label->setTextFormat(Qt::PlainText);
  label->setAlignment(Qt::AlignCenter);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  return label;
}

QLabel* paragraph(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

/// The sphere (or the whole image of another shape) of a photograph, and its residual beside it.
QPixmap stripPicture(const PhotographItem& item, const QImage& residual, double pixelRatio) {
  const int side = int(std::lround(stripSide * pixelRatio)), gap = side / 16;
  QPixmap picture(residual.isNull() ? side : 2 * side + gap, side);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const matching::Disc disc = item.disc();
  const double scale = double(item.shown.width()) / item.size.width(), radius = 1.08 * disc.radius * scale;
  const QRectF crop(disc.x * scale - radius, disc.y * scale - radius, 2 * radius, 2 * radius);
  painter.fillRect(picture.rect(), QColor(46, 46, 48));
  painter.drawImage(QRectF(0, 0, side, side), item.shown, crop);
  if (!residual.isNull()) painter.drawImage(QRectF(side + gap, 0, side, side), residual);
  picture.setDevicePixelRatio(pixelRatio);
  return picture;
}

/// A factor, and its range of one standard deviation of its logarithm: "factor 0.84 (0.31 to 2.3)".
QString factorText(double logarithm, double deviation) {
  const auto number = [](double value) { return QString::number(std::exp(value), 'g', 3); };
  return PhotographViews::tr("factor %1 (%2 to %3)")
      .arg(number(logarithm), number(logarithm - deviation), number(logarithm + deviation));
}

/// "outline x −1.2 ± 0.4 px"
QString checkText(const photograph::InputCheck& check) {
  using Views = PhotographViews;
  const std::string& property = check.property;
  double estimate = check.estimate, deviation = check.deviation;
  QString name = QString::fromStdString(property), unit = Views::tr(" px");
  if (property == "exposure") return Views::tr("exposure: %1").arg(factorText(estimate, deviation));
  if (property == "gamma") {  // of a logarithm
    deviation *= 100 * std::exp(estimate);
    estimate = 100 * std::expm1(estimate);
    unit = Views::tr(" %");
  } else if (property == "rotation") {
    deviation = degrees(deviation);
    estimate = degrees(estimate);
    unit = QStringLiteral("°");
  } else if (property == "outline y" || property == "outline radius") {  // after "outline x"
    name = name.section(' ', 1);
  }
  return QStringLiteral("%1 %2%3 ± %4%5")
      .arg(name, estimate < 0 ? QStringLiteral("−") : QStringLiteral("+"))
      .arg(std::abs(estimate), 0, 'f', 1)
      .arg(deviation, 0, 'f', 1)
      .arg(unit);
}

QStringList photographWarnings(const PhotographResultPtr& result) {
  QStringList texts;
  if (!result) return texts;
  for (const std::string& warning : result->fit.warnings) {
    QString text = QString::fromStdString(warning);
    if (text.startsWith(QLatin1String("the "))) text[0] = text[0].toUpper();
    texts << text + '.';
  }
  for (QString& text : texts) text.prepend(QStringLiteral("⚠ "));
  return texts;
}

}  // namespace

PhotographViews::PhotographViews(PhotographSession& session)
    : m_session(session),
      m_title(captionLabel()),
      m_residualTitle(captionLabel()),
      m_warnings(paragraph("warnings")),
      m_checks(paragraph("checks")),
      m_outline(new ReferenceView),
      m_residual(new widgets::ResidualView),
      m_strip(new QListWidget),
      m_sameLight(new SphereView),
      m_otherLight(new SphereView),
      m_lights(rowBox(tr("Environment of the second sphere"))),
      m_sameName(captionLabel()),
      m_uncertainty(new widgets::UncertaintyCurve),
      m_open(new QPushButton(tr("Open as Mater&ial"))) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(fontMetrics().height() / 2);
  layout->addLayout(buildPhotograph(), 2);
  layout->addLayout(buildResult(), 1);
  connectParts();
  refresh();
}

QLayout* PhotographViews::buildPhotograph() {
  m_outline->setAccessibleName(tr("Photograph"));
  m_outline->installEventFilter(this);
  m_strip->setAccessibleName(tr("Photographs"));
  m_strip->setToolTip(tr("The photographs, each with its residual beside it"));
  m_strip->setFlow(QListView::LeftToRight);
  m_strip->setWrapping(false);
  m_strip->setViewMode(QListView::IconMode);
  m_strip->setMovement(QListView::Static);
  m_strip->setTextElideMode(Qt::ElideMiddle);
  m_strip->setUniformItemSizes(true);
  m_strip->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_strip->setFixedHeight(stripSide + 2 * fontMetrics().lineSpacing() + 2);
  auto* layout = new QGridLayout;
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_title, 0, 0);
  layout->addWidget(m_residualTitle, 0, 1);
  layout->addWidget(m_outline, 1, 0);
  layout->addWidget(m_residual, 1, 1);
  layout->addWidget(m_warnings, 2, 0, 1, 2);
  layout->addWidget(m_checks, 3, 0, 1, 2);
  layout->addWidget(m_strip, 4, 0, 1, 2);
  layout->setRowStretch(1, 1);
  for (const int column : {0, 1}) layout->setColumnStretch(column, 1);
  return layout;
}

QLayout* PhotographViews::buildResult() {
  for (const std::string& name : rendering::bundledEnvironmentNames())
    m_lights->addItem(sceneTitle(name), QString::fromStdString(name));
  m_lights->setAccessibleName(tr("Other light"));
  m_lights->setCurrentIndex(m_lights->findData(m_session.otherLight()));
  m_sameLight->setAccessibleName(tr("Reconstruction in the light of the photograph"));
  m_sameLight->setToolTip(tr("The reconstruction in the light of the photograph, as bright as the photograph"));
  m_otherLight->setAccessibleName(tr("Reconstruction in another light"));
  m_open->setToolTip(
      tr("Opens the reconstruction as a material that can be edited, saved and exported.\nIts table is stored in "
         "Gonio's data folder. Undo restores the previous material."));
  auto* layout = new QGridLayout;
  layout->setContentsMargins(0, 0, 0, 0);
  auto* title = captionLabel();
  title->setText(tr("Reconstruction"));
  layout->addWidget(title, 0, 0, 1, 2);
  layout->addWidget(m_sameLight, 1, 0);
  layout->addWidget(m_otherLight, 1, 1);
  layout->addWidget(m_sameName, 2, 0);
  layout->addWidget(m_lights, 2, 1);
  layout->addWidget(m_uncertainty, 3, 0, 1, 2);
  layout->addWidget(m_open, 4, 0, 1, 2, Qt::AlignRight);
  layout->setRowStretch(1, 2);
  layout->setRowStretch(3, 3);
  for (const int column : {0, 1}) layout->setColumnStretch(column, 1);
  return layout;
}

void PhotographViews::connectParts() {
  connect(&m_session, &PhotographSession::inputsChanged, this, &PhotographViews::refresh);
  connect(&m_session, &PhotographSession::resultChanged, this, &PhotographViews::refresh);
  connect(&m_session, &PhotographSession::otherSphereChanged, this, &PhotographViews::showSpheres);
  connect(m_strip, &QListWidget::currentRowChanged, this, &PhotographViews::setCurrent);
  connect(m_outline, &ReferenceView::discDragged, this, [this](const matching::Disc& disc) {
    if (m_current >= 0) m_session.setDisc(std::size_t(m_current), disc);
  });
  connect(m_lights, &QComboBox::activated, this,
          [this](int index) { m_session.setOtherLight(m_lights->itemData(index).toString()); });
  connect(m_open, &QPushButton::clicked, this, &PhotographViews::openRequested);
}

bool PhotographViews::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    // Both views show the sphere at the same size; the colour bar has room beside it.
    const double radius = std::min(0.46 * m_outline->height(), 0.5 * m_outline->width() - m_residual->barWidth());
    m_outline->setShownRadius(radius);
    m_residual->setShownRadius(radius);
  }
  return QWidget::eventFilter(watched, event);
}

void PhotographViews::setCurrent(int index) {
  if (index < 0 && !m_session.inputs().isEmpty()) return;  // the strip is being filled
  if (index == m_current) return;
  m_current = index;
  refresh();
  Q_EMIT currentChanged(index);
}

void PhotographViews::setState(bool isOpening, bool isBusy) {
  m_open->setEnabled(m_session.result() && !isOpening);
  m_residual->setHint(isBusy ? tr("Working...")
                             : tr("Press Reconstruct to see how much the photograph differs from the reconstruction."));
}

void PhotographViews::refresh() {
  const int count = int(m_session.inputs().size()), before = m_current;
  m_current = std::clamp(m_current, count > 0 ? 0 : -1, count - 1);
  showPhotograph();
  showStrip();
  showSpheres();
  showResult();
  if (m_current != before) Q_EMIT currentChanged(m_current);
}

void PhotographViews::showPhotograph() {
  m_title->setText(m_current >= 0 ? m_session.inputs()[std::size_t(m_current)].name() : QString());
  if (m_current < 0) return m_outline->setImage({}, {}, {});
  const PhotographItem& item = m_session.inputs()[std::size_t(m_current)];
  m_title->setToolTip(item.path());
  m_outline->setImage(item.shown, item.disc(), item.size);
  m_outline->setHasOutline(item.hasOutline());
  const auto place = m_session.placeInResult(std::size_t(m_current));
  m_residualTitle->setText(place ? tr("Residual: SNR %1 dB").arg(m_session.result()->fit.residualSnr[*place], 0, 'f', 1)
                                 : tr("Residual"));
  m_residual->setMap(place ? m_session.result()->residuals[qsizetype(*place)] : QImage(),
                     place ? m_session.result()->residualRange : 0);
}

void PhotographViews::showStrip() {
  const PhotographInputs& inputs = m_session.inputs();
  const QSignalBlocker blocker(m_strip);
  m_strip->setVisible(inputs.size() > 1);
  while (m_strip->count() > int(inputs.size())) delete m_strip->takeItem(m_strip->count() - 1);
  while (m_strip->count() < int(inputs.size())) m_strip->addItem(QString());
  bool hasResiduals = false;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto place = m_session.placeInResult(i);
    QListWidgetItem& tile = *m_strip->item(int(i));
    const QPixmap picture =
        stripPicture(inputs[i], place ? m_session.result()->residuals[*place] : QImage(), devicePixelRatioF());
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected);  // in its own colours
    tile.setIcon(icon);
    tile.setText(
        place ? tr("%1 · %2 dB").arg(inputs[i].name()).arg(m_session.result()->fit.residualSnr[*place], 0, 'f', 1)
              : inputs[i].name());
    tile.setToolTip(inputs[i].path());
    hasResiduals |= place.has_value();
  }
  const int across = hasResiduals ? 2 * stripSide + stripSide / 16 : stripSide;
  m_strip->setIconSize({across, stripSide});
  const int em = fontMetrics().height();
  m_strip->setGridSize({std::max(across, 10 * em) + em / 2, stripSide + fontMetrics().lineSpacing() + 6});
  m_strip->setCurrentRow(m_current);
}

void PhotographViews::showSpheres() {
  const PhotographResultPtr& result = m_session.result();
  const auto place = m_current >= 0 ? m_session.placeInResult(std::size_t(m_current)) : std::nullopt;
  const std::size_t shown = place.value_or(0);
  m_sameLight->setPicture(result ? result->spheres[shown] : QImage());
  m_sameName->setText(result ? result->lights[qsizetype(shown)] : tr("Same light"));
  m_otherLight->setPicture(m_session.otherSphere());
}

QString PhotographViews::checksText() const {
  const PhotographResultPtr& result = m_session.result();
  if (!result) return {};
  QStringList texts;
  if (!m_session.inputs().isExposureKnown() || result->fit.exposureDeviation > 0)
    texts << tr("Exposure: %1").arg(factorText(std::log(result->fit.exposure), result->fit.exposureDeviation));
  QStringList checks;
  for (const photograph::InputCheck& check : result->fit.checks)
    if (check.deviation > 0) checks << checkText(check);
  if (!checks.isEmpty()) texts << tr("Estimated errors of the input: %1").arg(checks.join(QStringLiteral(", ")));
  return texts.join(QStringLiteral(" · "));
}

void PhotographViews::showResult() {
  const PhotographResultPtr& result = m_session.result();
  const QStringList warnings = photographWarnings(result);
  m_warnings->setText(warnings.join('\n'));
  m_warnings->setVisible(!warnings.isEmpty());
  const QString checks = checksText();
  m_checks->setText(checks);
  m_checks->setVisible(!checks.isEmpty());
  m_checks->setToolTip(
      tr("How much better the photographs would fit if one number of the input were different: its estimated "
         "difference from the stated value, and the standard deviation of the estimate"));
  m_uncertainty->setPoints(result ? result->uncertainty : std::vector<widgets::UncertaintyCurve::Point>());
  m_uncertainty->setHint(tr("Uncertainty of the reconstruction"));
}

}  // namespace gonio::app

#include "moc_photograph_views.cpp"
