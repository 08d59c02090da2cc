// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_widget.h"

#include <QEvent>
#include <QPainter>
#include <QSurfaceFormat>
#include <utility>

#include "widgets/preview/gl/scene_uniforms.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/split_bar.h"

namespace gonio::widgets {

namespace {

/// Where a picture stands: everywhere, or where the widget has another shape by now, as large as it fits.
QRect unstretched(const QSize& picture, const QRect& area) {
  constexpr int roundedPart = 50;  // of the area: coarse pictures have whole pixels
  const QSize fit = picture.scaled(area.size(), Qt::KeepAspectRatio);
  const QSize missing = area.size() - fit;
  if (missing.width() <= area.width() / roundedPart && missing.height() <= area.height() / roundedPart) return area;
  return {area.topLeft() + QPoint(missing.width(), missing.height()) / 2, fit};
}

}  // namespace

PreviewWidget::PreviewWidget(QWidget* parent)
    : QWidget(parent), m_overlay(new PreviewOverlay(this)), m_input(new PreviewInput(m_content, *this)) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(200, 200);
  setAccessibleName(tr("Preview"));
  setAccessibleDescription(tr("The material in the scene. Drag to orbit, use the wheel to zoom."));
  connectContent();
  connectThread();
  connect(m_overlay->splitBar(), &SplitBar::moved, this, [this](double fraction) {
    PreviewComparison comparison = m_content.comparison();
    comparison.split = fraction;
    m_content.setComparison(comparison);
    Q_EMIT splitMoved(fraction);
  });
  showOverlay();
}

PreviewWidget::~PreviewWidget() { m_thread.stop(); }

void PreviewWidget::connectContent() {
  const auto changed = [this] {
    m_changed = std::chrono::steady_clock::now();
    m_failure = m_unavailable;
    m_firstCurrent = m_number + 1;
    showOverlay();
    requestPicture();
  };
  const auto refresh = [this] {
    m_fresh = m_number + 1;
    requestPicture();
  };
  connect(&m_content, &PreviewContent::changed, this, [this, changed] {
    m_fresh = m_number + 1;
    changed();
  });
  connect(&m_content, &PreviewContent::comparisonChanged, this, changed);
  connect(&m_content, &PreviewContent::refined, this, refresh);
  connect(&m_content, &PreviewContent::failed, this, &PreviewWidget::showFailure);
}

void PreviewWidget::connectThread() {
  connect(&m_thread, &PictureThread::started, this, [this](const QString& graphics, bool software) {
    m_graphics = graphics;
    m_content.setSoftware(software);
  });
  connect(&m_thread, &PictureThread::unavailable, this, [this](const QString& reason) {
    m_unavailable =
        tr("The preview is not available: %1. Editing, fits, plots and exports work without it.").arg(reason);
    showFailure(m_unavailable);
  });
  connect(&m_thread, &PictureThread::drawn, this, &PreviewWidget::adopt);
  connect(&m_thread, &PictureThread::failed, this, [this](const QString& message, int number) {
    if (number >= m_firstCurrent) showFailure(message);
  });
  connect(&m_thread, &PictureThread::compiling, this, [this] {
    if (m_content.hasMaterial()) m_overlay->setStatus(tr("Compiling shaders..."));
  });
}

void PreviewWidget::setLoading(const QString& name, const QImage& thumbnail) {
  if (m_loading == name && m_thumbnail.cacheKey() == thumbnail.cacheKey()) return;
  m_loading = name;
  m_thumbnail = thumbnail;
  showOverlay();
  update();
}

void PreviewWidget::setFlickering(bool flickering) {
  m_flickering = flickering && m_content.isComparing() && m_content.comparison().mode != CompareMode::twoUp;
  showOverlay();
  if (m_content.hasMaterial() && m_state.number > 0) showStatus(m_state.milliseconds);
  requestPicture();
}

void PreviewWidget::setNoiseFiltered(bool filtered) {
  m_filtersNoise = filtered;
  requestPicture();
}

void PreviewWidget::setDisplay(const DisplaySettings& settings) {
  m_settings = settings;
  requestPicture();
  Q_EMIT displayChanged();
}

void PreviewWidget::setExposure(double stops) {
  DisplaySettings settings = m_settings;
  settings.exposure = stops;
  setDisplay(settings);
}

QSize PreviewWidget::pixelSize() const { return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1}); }

void PreviewWidget::requestPicture() {
  PictureRequest request = m_content.request();
  request.number = ++m_number;
  request.display = m_settings;
  request.flickering = m_flickering && request.comparing;
  const bool showsNumbers = request.comparing && request.comparison.mode == CompareMode::difference;
  request.filtersNoise = m_filtersNoise && m_content.isNoisy() && !showsNumbers;
  request.changed = m_changed;
  m_thread.request(request);
}

bool PreviewWidget::converged() const {
  if (!m_content.hasMaterial() || m_content.isBusy() || m_state.number < m_fresh) return false;
  const auto done = [this](const PictureState::Side& side) {
    return side.size == m_content.pictureSize() && side.samples >= m_content.wantedSamples();
  };
  return done(m_state.sides[0]) && (!m_content.isComparing() || done(m_state.sides[1]));
}

QImage PreviewWidget::grabPicture() {
  startDrawing();
  if (const PictureState state = m_thread.drawNow(); state.number > 0) adopt(state);
  return m_state.picture;
}

QImage PreviewWidget::grabLabelledPicture() {
  QImage picture = grabPicture();
  picture.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(&picture);
  m_overlay->drawLabels(painter);
  return picture;
}

void PreviewWidget::adopt(const PictureState& state) {
  m_state = state;
  if (m_content.isComparing() && m_content.comparison().mode == CompareMode::difference && state.range > 0)
    m_overlay->setRange(m_content.comparison().difference, state.range);
  if (state.isNew && m_content.hasMaterial()) {
    const bool isTraced = state.sides[0].isTraced;
    const double milliseconds = isTraced ? m_content.first().tracer().millisecondsPerSample() : state.milliseconds;
    showStatus(milliseconds);
    Q_EMIT frameRendered(milliseconds, state.sides[0].samples);
  }
  update();
}

void PreviewWidget::showFailure(const QString& message) {
  if (m_failure == message) return;
  m_failure = message;
  showOverlay();
  Q_EMIT failed(message);
}

/// Dark around the material in a dark window, mid-grey in a light one: the viewport is no hole in either.
void PreviewWidget::adoptPalette() {
  const bool isDark = palette().color(QPalette::Window).lightness() < 128;
  DisplaySettings settings = m_settings;
  settings.backgroundCentre = isDark ? DisplaySettings().backgroundCentre : QColor(148, 148, 150);
  settings.backgroundEdge = isDark ? DisplaySettings().backgroundEdge : QColor(118, 118, 120);
  if (settings.backgroundEdge != m_settings.backgroundEdge) setDisplay(settings);
}

void PreviewWidget::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) adoptPalette();
}

void PreviewWidget::startDrawing() {
  QSurfaceFormat format;
  format.setVersion(4, 1);
  format.setProfile(QSurfaceFormat::CoreProfile);
  m_content.setViewport(pixelSize());
  m_thread.start(format);
}

void PreviewWidget::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  adoptPalette();
  startDrawing();
}

void PreviewWidget::paintEvent(QPaintEvent*) {
  m_content.setViewport(pixelSize());  // a screen of another density
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, m_state.picture.size() != pixelSize());
  const QRect place = m_state.picture.isNull() ? QRect() : unstretched(m_state.picture.size(), rect());
  if (place != rect()) painter.fillRect(rect(), m_settings.backgroundEdge);
  painter.drawImage(place, m_state.picture);
  if (!m_loading.isEmpty()) drawLoading(painter);
}

void PreviewWidget::drawLoading(QPainter& painter) const {
  constexpr QColor veil(20, 20, 20, 150);
  if (!m_state.picture.isNull()) painter.fillRect(rect(), veil);
  // Above the name, which is in the middle.
  const int above = fontMetrics().height(), room = std::min(height() / 2 - 2 * above, width() / 2);
  if (m_thumbnail.isNull() || room <= 0) return;
  const QSize size = QSize(room, room).boundedTo(m_thumbnail.size());
  const QRect place((width() - size.width()) / 2, height() / 2 - above - size.height(), size.width(), size.height());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(unstretched(m_thumbnail.size(), place), m_thumbnail);
}

void PreviewWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  m_content.setViewport(pixelSize());
}

void PreviewWidget::showOverlay() {
  PreviewComparison shown = m_content.comparison();
  if (!m_content.isComparing()) shown.mode = CompareMode::off;
  m_overlay->setComparison(shown, {m_content.first().name(), m_content.second().name()},
                           m_flickering && m_content.isComparing());
  if (!m_failure.isEmpty()) return m_overlay->setHint(m_failure);
  if (!m_loading.isEmpty()) return m_overlay->setHint(tr("Opening %1...").arg(m_loading));
  m_overlay->setHint(m_content.hasMaterial() ? QString()
                                             : tr("Open a material (Ctrl+O), drop a file here,\n"
                                                  "or double-click a material in the library."));
  if (!m_content.hasMaterial()) m_overlay->setStatus({});
}

void PreviewWidget::showStatus(double milliseconds) {
  const QString curve = QString::fromUtf8(rendering::toneMapName(m_settings.toneMap).data());
  const bool second = m_flickering && m_content.isComparing();
  const PictureState::Side& shown = m_state.sides[second ? 1 : 0];
  const int followed = shown.isTraced ? m_content.plan().reflections : SceneUniforms::maxReflections;
  const QString& name = (second ? m_content.second() : m_content.first()).name();
  m_overlay->setStatus(
      tr("%1%2 | exposure %3 stops | %4 | %5 ms%6 | %7%8\n%9")
          .arg(name.isEmpty() ? QString() : tr("%1 | ").arg(name), QString::fromStdString(m_content.scene().name),
               QString::number(m_settings.exposure, 'f', 1), curve, QString::number(milliseconds, 'f', 1),
               shown.isTraced ? tr(" per sample, on the CPU") : QString(), samplesText(shown.samples),
               shown.isFiltered ? tr(", noise filtered") : QString(), effectsText(m_content.plan(), followed)));
}

}  // namespace gonio::widgets

#include "moc_preview_widget.cpp"
