// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_widget.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include "core/rendering/scene_file.h"
#include "core/support/error.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/split_bar.h"

namespace gonio::widgets {

namespace {
constexpr int restMs = 120;  // without a change: the picture is at rest
}  // namespace

PreviewWidget::PreviewWidget(QWidget* parent)
    : QOpenGLWidget(parent),
      resources_(std::make_shared<PreviewResources>()),
      first_(resources_),
      second_(resources_),
      display_(resources_),
      overlay_(new PreviewOverlay(this)) {
  QSurfaceFormat format;
  format.setVersion(4, 1);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setSwapInterval(1);
  setFormat(format);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(200, 200);
  setAccessibleName(tr("Preview"));
  setAccessibleDescription(tr("The material on a sphere. Drag to orbit, wheel to zoom."));
  frameTimer_.setSingleShot(true);
  connect(&frameTimer_, &QTimer::timeout, this, [this] { update(); });
  connect(&first_.estimator, &MaterialEstimator::estimated, this,
          [this](const auto& estimate) { adopt(first_, estimate); });
  connect(&second_.estimator, &MaterialEstimator::estimated, this,
          [this](const auto& estimate) { adopt(second_, estimate); });
  for (Side* side : {&first_, &second_}) connect(&side->tracer, &SceneTracer::advanced, this, [this] { update(); });
  connect(overlay_->splitBar(), &SplitBar::moved, this, [this](double share) {
    comparison_.split = share;
    update();
    Q_EMIT splitMoved(share);
  });
  showScene(openScene(bundledSceneNames().front()));
  setMaterial(nullptr, {});
}

PreviewWidget::~PreviewWidget() {
  if (context()) release();
}

void PreviewWidget::release() {
  makeCurrent();
  first_.picture.release();
  second_.picture.release();
  resources_->release();
  doneCurrent();
}

void PreviewWidget::setComparison(const PreviewComparison& comparison) {
  if (comparison == comparison_) return;
  if (comparison.difference != comparison_.difference || comparison.range != comparison_.range) range_ = 0;
  comparison_ = comparison;
  showOverlay();
  for (Side* side : {&first_, &second_}) trace(*side);
  changed();
}

bool PreviewWidget::isComparing() const {
  return comparison_.mode != CompareMode::off && !first_.subject.isEmpty() && !second_.subject.isEmpty();
}

void PreviewWidget::setFlickering(bool flickering) {
  flickering_ = flickering && isComparing() && comparison_.mode != CompareMode::twoUp;
  showOverlay();
  update();
}

void PreviewWidget::setExposure(double stops) {
  settings_.exposure = stops;
  update();
}

void PreviewWidget::setToneMap(ToneMap toneMap) {
  settings_.toneMap = toneMap;
  update();
}

void PreviewWidget::setOverlayVisible(bool visible) { overlay_->setStatusWanted(visible); }

bool PreviewWidget::overlayVisible() const { return overlay_->statusWanted(); }

void PreviewWidget::setPicking(bool picking) {
  picking_ = picking;
  setCursor(picking ? Qt::CrossCursor : Qt::ArrowCursor);
}

bool PreviewWidget::needsFrames(const Side& side) const {
  if (isTraced()) return false;
  return side.picture.size() != pictureSize() || side.picture.samples() < wantedSamples();
}

bool PreviewWidget::converged() const {
  const auto done = [this](const Side& side) {
    if (isTraced()) return side.shown && side.shown->samples >= wantedSamples() && !side.estimator.isBusy();
    return !needsFrames(side) && !side.estimator.isBusy();
  };
  return hasMaterial() && done(first_) && (!isComparing() || done(second_));
}

QImage PreviewWidget::grabPicture() { return grabFramebuffer(); }

Image PreviewWidget::linearPicture() {
  makeCurrent();
  Image picture = first_.picture.readPicture();
  doneCurrent();
  return picture;
}

int PreviewWidget::wantedSamples() const {
  // Light without a size that is reflected once has no noise: its samples smooth the edge alone.
  const EffectPlan& simulated = first_.plan;
  const bool noisy = simulated.simulates(Effect::environmentLight) || simulated.simulates(Effect::areaLightSampling) ||
                     simulated.reflections > 1;
  return noisy ? 512 : 64;
}

QSize PreviewWidget::pixelSize() const { return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1}); }

QSize PreviewWidget::pictureSize() const {
  const QSize all = pixelSize();
  const bool halved = isComparing() && comparison_.mode == CompareMode::twoUp;
  return halved ? QSize(std::max(1, all.width() / 2), all.height()) : all;
}

void PreviewWidget::changed() {
  sinceChange_.start();
  update();
}

void PreviewWidget::restart() {
  for (Side* side : {&first_, &second_}) {
    side->picture.restart();
    trace(*side);
  }
  changed();
}

void PreviewWidget::fail(const QString& message) {
  if (failure_ == message) return;
  failure_ = message;
  overlay_->setHint(message);
  Q_EMIT failed(message);
}

void PreviewWidget::initializeGL() {
  // Reparenting (a dock that floats) destroys the context and makes another: everything is uploaded again.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &PreviewWidget::release);
  try {
    first_.picture.initialize();
    second_.picture.initialize();
    display_.initialize();
  } catch (const Error& error) {
    fail(QString::fromUtf8(error.what()));
  }
}

void PreviewWidget::renderFrame() {
  const bool resting = !sinceChange_.isValid() || sinceChange_.elapsed() >= restMs;
  const bool firstNeeds = needsFrames(first_), secondNeeds = isComparing() && needsFrames(second_);
  const double fullPixels = double(pictureSize().width()) * pictureSize().height() * (firstNeeds + secondNeeds);
  const int accumulated = std::min(firstNeeds ? first_.picture.samples() : wantedSamples(),
                                   secondNeeds ? second_.picture.samples() : wantedSamples());
  const FrameBudget::Frame frame = budget_.next(fullPixels, accumulated, wantedSamples(), resting);
  QElapsedTimer timer;
  timer.start();
  for (Side* side : {&first_, &second_}) {
    if (!(side == &first_ ? firstNeeds : secondNeeds)) continue;
    side->picture.setSize(frame.scale == 1 ? pictureSize() : pictureSize() / 2);
    side->picture.accumulate(frame.samples);
  }
  const double milliseconds = double(timer.nsecsElapsed()) * 1e-6;
  budget_.record(fullPixels * frame.scale * frame.scale, frame.samples, milliseconds);
  updateRange();
  updateStatus(milliseconds);
  Q_EMIT frameRendered(milliseconds, first_.picture.samples());
  // A frame at half the resolution stands until the hand rests; others are refined at once.
  if (needsFrames(first_) || (isComparing() && needsFrames(second_))) frameTimer_.start(frame.scale < 1 ? restMs : 0);
}

/// Takes over what the tracers have reached.
void PreviewWidget::showTraced() {
  for (Side* side : {&first_, &second_}) {
    if (side->tracer.film() == side->shown || !side->tracer.film()) continue;
    side->shown = side->tracer.film();
    side->picture.showTraced(*side->shown);
    if (side != &first_) continue;
    updateStatus(side->tracer.millisecondsOfSample());
    Q_EMIT frameRendered(side->tracer.millisecondsOfSample(), side->shown->samples);
  }
  updateRange();
}

void PreviewWidget::updateRange() {
  if (!isComparing() || comparison_.mode != CompareMode::difference) return;
  const int samples = std::min(first_.picture.samples(), second_.picture.samples());
  if (comparison_.range > 0) {
    range_ = comparison_.range;
  } else {
    // Noise makes a range too wide: it is found again at 4 times as many samples, and at last.
    const bool due =
        range_ == 0 || samples >= 4 * rangeSamples_ || (samples >= wantedSamples() && rangeSamples_ < samples);
    if (samples < rangeSamples_) rangeSamples_ = samples;
    if (!due || first_.picture.size() != second_.picture.size() || samples == 0) return;
    range_ = automaticRange(
        pictureDifferences(first_.picture.readPicture(), second_.picture.readPicture(), comparison_.difference));
    rangeSamples_ = samples;
  }
  overlay_->setRange(comparison_.difference, range_);
}

void PreviewWidget::paintGL() {
  if (!failure_.isEmpty()) return;
  try {
    if (isTraced()) showTraced();
    if (hasMaterial() && (needsFrames(first_) || (isComparing() && needsFrames(second_)))) renderFrame();
    if (range_ == 0) updateRange();
    context()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    if (isComparing() && !flickering_)
      display_.present(pixelSize(), settings_, comparison_, std::max(range_, 1e-9), first_.picture, second_.picture);
    else
      display_.present(pixelSize(), settings_, flickering_ ? second_.picture : first_.picture);
  } catch (const Error& error) {
    fail(QString::fromUtf8(error.what()));
  }
}

void PreviewWidget::resizeGL(int, int) { restart(); }

void PreviewWidget::showOverlay() {
  PreviewComparison shown = comparison_;
  if (!isComparing()) shown.mode = CompareMode::off;
  overlay_->setComparison(shown, {first_.name, second_.name}, flickering_ && isComparing());
}

void PreviewWidget::updateStatus(double milliseconds) {
  const QString curve = QString::fromUtf8(toneMapName(settings_.toneMap).data());
  const int followed = isTraced() ? first_.plan.reflections : SceneUniforms::mostReflections;
  const QString subject = first_.name.isEmpty() ? QString() : tr("%1 | ").arg(first_.name);
  overlay_->setStatus(tr("%1%2 | exposure %3 | %4 | %5 ms%6 | %7\n%8")
                          .arg(subject, QString::fromStdString(scene_.name))
                          .arg(settings_.exposure, 0, 'f', 1)
                          .arg(curve)
                          .arg(milliseconds, 0, 'f', 1)
                          .arg(isTraced() ? tr(" a sample, on the CPU") : QString())
                          .arg(samplesText(first_.picture.samples()), effectsText(first_.plan, followed)));
}

}  // namespace gonio::widgets

#include "moc_preview_widget.cpp"
