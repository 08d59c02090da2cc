// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_widget.h"

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QWheelEvent>

#include "core/support/error.h"
#include "widgets/preview/preview_navigation.h"

namespace gonio::widgets {

namespace {
constexpr int restMs = 120;  // without a change: the picture is at rest
}  // namespace

PreviewWidget::PreviewWidget(QWidget* parent)
    : QOpenGLWidget(parent), overlay_(new QLabel(this)), hint_(new QLabel(this)) {
  QSurfaceFormat format;
  format.setVersion(4, 1);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setSwapInterval(1);
  setFormat(format);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(200, 200);
  setAccessibleName(tr("Preview"));
  setAccessibleDescription(tr("The material on a sphere. Drag to orbit, wheel to zoom."));
  overlay_->setStyleSheet("background: rgba(0, 0, 0, 120); color: #e8e8e8; padding: 4px 8px; border-radius: 4px;");
  overlay_->setAttribute(Qt::WA_TransparentForMouseEvents);
  overlay_->hide();
  hint_->setStyleSheet("color: #c8c8c8; background: transparent;");
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  hint_->setAttribute(Qt::WA_TransparentForMouseEvents);
  hint_->setText(tr("Open a measured material (Ctrl+O), drop a file here,\nor double-click one in the library."));
  frameTimer_.setSingleShot(true);
  connect(&frameTimer_, &QTimer::timeout, this, [this] { update(); });
}

PreviewWidget::~PreviewWidget() {
  if (!context()) return;
  makeCurrent();
  renderer_.release();
  doneCurrent();
}

void PreviewWidget::setMaterial(std::shared_ptr<const TabulatedBrdf> table, const SamplingLobe& lobe) {
  table_ = std::move(table);
  lobe_ = lobe;
  tablePending_ = true;
  budget_.reset();
  hint_->setVisible(!table_);
  overlay_->setVisible(overlayWanted_ && table_);
  restart();
}

void PreviewWidget::setEdit(std::optional<editing::DifferentialEdit> edit) {
  edit_ = std::move(edit);
  renderer_.setEdit(edit_);
  renderer_.setLobe(editedLobe());
  restart();
}

SamplingLobe PreviewWidget::editedLobe() const {
  if (!table_ || !edit_ || edit_->isIdentity()) return lobe_;
  return estimateSamplingLobe(*editing::applyEdits(table_, std::span(&*edit_, 1)));
}

void PreviewWidget::setScene(const SphereScene& scene) {
  scene_ = scene;
  renderer_.setScene(scene_);
  restart();
  Q_EMIT sceneChanged(scene_);
}

void PreviewWidget::setExposure(double stops) {
  display_.exposure = stops;
  update();
}

void PreviewWidget::setToneMap(ToneMap toneMap) {
  display_.toneMap = toneMap;
  update();
}

void PreviewWidget::setOverlayVisible(bool visible) {
  overlayWanted_ = visible;
  overlay_->setVisible(visible && table_);
}

void PreviewWidget::setPicking(bool picking) {
  picking_ = picking;
  setCursor(picking ? Qt::CrossCursor : Qt::ArrowCursor);
}

bool PreviewWidget::converged() const {
  return renderer_.hasMaterial() && renderer_.size() == pixelSize() && renderer_.samples() >= wantedSamples();
}

QImage PreviewWidget::grabPicture() {
  overlay_->hide();
  QImage picture = grabFramebuffer();
  overlay_->setVisible(overlayWanted_ && table_);
  return picture;
}

Image PreviewWidget::linearPicture() {
  makeCurrent();
  Image picture = renderer_.readPicture();
  doneCurrent();
  return picture;
}

void PreviewWidget::frameObject() {
  SphereScene scene = scene_;
  scene.camera.distance = OrbitCamera{}.distance;
  setScene(scene);
}

void PreviewWidget::resetView() {
  SphereScene scene = scene_;
  scene.camera = OrbitCamera{};
  scene.light = DirectionalLight{};
  scene.environmentRotation = 0;
  setScene(scene);
}

int PreviewWidget::wantedSamples() const {
  // One light has no noise: its samples smooth the edge alone.
  return scene_.environment ? 512 : 64;
}

QSize PreviewWidget::pixelSize() const { return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1}); }

void PreviewWidget::restart() {
  renderer_.restart();
  sinceChange_.start();
  update();
}

void PreviewWidget::fail(const QString& message) {
  if (failure_ == message) return;
  failure_ = message;
  hint_->setText(message);
  hint_->show();
  Q_EMIT failed(message);
}

void PreviewWidget::initializeGL() {
  // Reparenting (a dock that floats) destroys the context and makes another: everything is uploaded again.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
    makeCurrent();
    renderer_.release();
    doneCurrent();
  });
  try {
    renderer_.initialize();
    tablePending_ = table_ != nullptr;
  } catch (const Error& error) {
    fail(QString::fromUtf8(error.what()));
  }
}

void PreviewWidget::applyPending() {
  if (!tablePending_) return;
  renderer_.setTable(table_, editedLobe());
  tablePending_ = false;
}

void PreviewWidget::renderFrame() {
  const bool resting = !sinceChange_.isValid() || sinceChange_.elapsed() >= restMs;
  const double fullPixels = double(pixelSize().width()) * pixelSize().height();
  const FrameBudget::Frame frame = budget_.next(fullPixels, renderer_.samples(), wantedSamples(), resting);
  renderer_.setSize(frame.scale == 1 ? pixelSize() : pixelSize() / 2);
  QElapsedTimer timer;
  timer.start();
  renderer_.accumulate(frame.samples);
  const double milliseconds = double(timer.nsecsElapsed()) * 1e-6;
  budget_.record(fullPixels * frame.scale * frame.scale, frame.samples, milliseconds);
  updateOverlay(milliseconds);
  Q_EMIT frameRendered(milliseconds, renderer_.samples());
  // A frame at half the resolution stands until the hand rests; others are refined at once.
  if (!converged()) frameTimer_.start(frame.scale < 1 ? restMs : 0);
}

void PreviewWidget::paintGL() {
  if (!failure_.isEmpty()) return;
  try {
    applyPending();
    if (renderer_.hasMaterial() && !converged()) renderFrame();
    context()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    renderer_.present(pixelSize(), display_);
  } catch (const Error& error) {
    fail(QString::fromUtf8(error.what()));
  }
}

void PreviewWidget::resizeGL(int, int) {
  placeOverlay();
  restart();
}

void PreviewWidget::placeOverlay() {
  overlay_->adjustSize();
  overlay_->move(10, height() - overlay_->height() - 10);
  hint_->setGeometry(rect().adjusted(40, 40, -40, -40));
}

void PreviewWidget::updateOverlay(double milliseconds) {
  if (!overlay_->isVisible()) return;
  const QString light =
      scene_.environment ? QString::fromStdString(scene_.environment->name()) : tr("directional light");
  const QString curve = QString::fromUtf8(toneMapName(display_.toneMap).data());
  overlay_->setText(tr("%1 | exposure %2 | %3 | %4 ms | %5 samples")
                        .arg(light)
                        .arg(display_.exposure, 0, 'f', 1)
                        .arg(curve)
                        .arg(milliseconds, 0, 'f', 1)
                        .arg(renderer_.samples()));
  placeOverlay();
}

bool PreviewWidget::pick(const QMouseEvent& event) {
  if (!(event.buttons() & Qt::LeftButton) || !(picking_ || event.modifiers() & Qt::ControlModifier)) return false;
  const QPointF at = event.position();
  if (const auto theta = viewerPolarAngle(scene_.camera, 2 * at.x() / width() - 1, 1 - 2 * at.y() / height(),
                                          double(width()) / height()))
    Q_EMIT polarAnglePicked(*theta);
  return true;
}

void PreviewWidget::mousePressEvent(QMouseEvent* event) {
  lastPosition_ = event->position();
  if (pick(*event)) return;
  if (event->button() == Qt::LeftButton && !scene_.environment) dragLight(event->position());
}

void PreviewWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF delta = event->position() - lastPosition_;
  lastPosition_ = event->position();
  if (pick(*event)) return;
  SphereScene scene = scene_;
  if (event->buttons() & Qt::LeftButton && !scene.environment) return dragLight(event->position());
  if (event->buttons() & Qt::RightButton && event->modifiers() & Qt::ShiftModifier)
    scene.environmentRotation += environmentTurn(delta.x());
  else if (event->buttons() & (Qt::LeftButton | Qt::MiddleButton | Qt::RightButton))
    scene.camera = orbited(scene.camera, delta.x(), delta.y());
  else
    return;
  setScene(scene);
}

void PreviewWidget::dragLight(const QPointF& position) {
  SphereScene scene = scene_;
  scene.light.toLight = lightTowards(scene.camera, 2 * position.x() / width() - 1, 1 - 2 * position.y() / height(),
                                     double(width()) / height());
  setScene(scene);
}

void PreviewWidget::wheelEvent(QWheelEvent* event) {
  SphereScene scene = scene_;
  scene.camera = zoomed(scene.camera, event->angleDelta().y() / 120.0);
  setScene(scene);
  event->accept();
}

void PreviewWidget::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers() & Qt::ShiftModifier ? 2 : 20;  // pixels of a drag
  SphereScene scene = scene_;
  switch (event->key()) {
    case Qt::Key_F:
      return frameObject();
    case Qt::Key_R:
      return resetView();
    case Qt::Key_Left:
      scene.camera = orbited(scene.camera, -step, 0);
      break;
    case Qt::Key_Right:
      scene.camera = orbited(scene.camera, step, 0);
      break;
    case Qt::Key_Up:
      scene.camera = orbited(scene.camera, 0, -step);
      break;
    case Qt::Key_Down:
      scene.camera = orbited(scene.camera, 0, step);
      break;
    case Qt::Key_Plus:
      scene.camera = zoomed(scene.camera, 1);
      break;
    case Qt::Key_Minus:
      scene.camera = zoomed(scene.camera, -1);
      break;
    default:
      return QOpenGLWidget::keyPressEvent(event);
  }
  setScene(scene);
}

}  // namespace gonio::widgets
