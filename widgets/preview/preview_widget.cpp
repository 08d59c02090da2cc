// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_widget.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>

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
  connect(&first_.estimator, &LobeEstimator::estimated, this, [this](const auto& lobe) { adoptLobe(first_, lobe); });
  connect(&second_.estimator, &LobeEstimator::estimated, this, [this](const auto& lobe) { adoptLobe(second_, lobe); });
  connect(overlay_->splitBar(), &SplitBar::moved, this, [this](double share) {
    comparison_.split = share;
    update();
    Q_EMIT splitMoved(share);
  });
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

void PreviewWidget::setMaterial(std::shared_ptr<const TabulatedBrdf> table, const SamplingLobe& lobe) {
  setSubject({.table = std::move(table), .lobe = lobe});
}

void PreviewWidget::setEdit(std::optional<editing::DifferentialEdit> edit) {
  PreviewSubject subject = first_.subject;
  subject.edit = std::move(edit);
  setSubject(subject, first_.name);
}

void PreviewWidget::setSubject(const PreviewSubject& subject, const QString& name) {
  const bool another = subject.table != first_.subject.table;
  changeSubject(first_, subject, name);
  if (another) budget_.reset();
  if (!failure_.isEmpty()) return;
  overlay_->setHint(subject.isEmpty() ? tr("Open a measured material (Ctrl+O), drop a file here,\n"
                                           "or double-click one in the library.")
                                      : QString());
  if (subject.isEmpty()) overlay_->setStatus({});
}

void PreviewWidget::setOther(const PreviewSubject& subject, const QString& name) {
  changeSubject(second_, subject, name);
}

void PreviewWidget::changeSubject(Side& side, const PreviewSubject& subject, const QString& name) {
  side.name = name;
  showOverlay();
  if (sameSubject(subject, side.subject)) return;
  const bool wasPlain = side.subject.isMeasured();
  side.subject = subject;
  PreviewSubject drawn = subject;
  if (!subject.isMeasured()) {
    // The lobe of the step before serves until the new one is known.
    if (!wasPlain) drawn.lobe = side.picture.subject().lobe;
    side.estimator.request(subject);
  } else {
    side.estimator.cancel();
  }
  side.picture.setSubject(drawn);
  changed();
}

void PreviewWidget::adoptLobe(Side& side, const SamplingLobe& lobe) {
  if (similarLobes(lobe, side.picture.subject().lobe)) return;
  side.picture.setLobe(lobe);
  update();
}

void PreviewWidget::setComparison(const PreviewComparison& comparison) {
  if (comparison == comparison_) return;
  if (comparison.difference != comparison_.difference || comparison.range != comparison_.range) range_ = 0;
  comparison_ = comparison;
  showOverlay();
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

void PreviewWidget::setScene(const SphereScene& scene) {
  scene_ = scene;
  first_.picture.setScene(scene_);
  second_.picture.setScene(scene_);
  changed();
  Q_EMIT sceneChanged(scene_);
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
  return side.picture.size() != pictureSize() || side.picture.samples() < wantedSamples();
}

bool PreviewWidget::converged() const {
  const auto done = [this](const Side& side) { return !needsFrames(side) && !side.estimator.isBusy(); };
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
  // One light has no noise: its samples smooth the edge alone.
  return scene_.environment ? 512 : 64;
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
  first_.picture.restart();
  second_.picture.restart();
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
  const QString light =
      scene_.environment ? QString::fromStdString(scene_.environment->name()) : tr("directional light");
  const QString curve = QString::fromUtf8(toneMapName(settings_.toneMap).data());
  overlay_->setStatus(tr("%1 | exposure %2 | %3 | %4 ms | %5")
                          .arg(light)
                          .arg(settings_.exposure, 0, 'f', 1)
                          .arg(curve)
                          .arg(milliseconds, 0, 'f', 1)
                          .arg(samplesText(first_.picture.samples())));
}

}  // namespace gonio::widgets

#include "moc_preview_widget.cpp"
