// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/picture_thread.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QTimer>
#include <limits>
#include <mutex>

#include "widgets/preview/gl/code_decoder.h"
#include "widgets/preview/gl/picture_readback.h"
#include "widgets/preview/gl/textures.h"
#include "widgets/preview/picture_drawer.h"
#include "widgets/preview/preview_side.h"

namespace gonio::widgets {

/// The object in the rendering thread. Only request() may be called from other threads.
class PictureThread::Worker : public QObject {
 public:
  Worker(PictureThread& thread, const QOffscreenSurface& surface)
      : m_owner(thread), m_surface(surface), m_context(new QOpenGLContext(this)), m_timer(this) {
    m_context->setFormat(surface.requestedFormat());
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, [this] {
      if (const std::optional<PictureState> state = draw())
        postToOwner([state = *state](PictureThread& owner) { Q_EMIT owner.drawn(state); });
    });
  }

  void initialize() {
    m_drawer.setCompileListener([this] { postToOwner([](PictureThread& owner) { Q_EMIT owner.compiling(); }); });
    const QString failure = TaskFailure::of([this] {
      if (!m_context->create()) throw Error("the graphics driver cannot create an OpenGL context");
      makeCurrent();
      if (!m_gl.initializeOpenGLFunctions()) throw Error(openGlTooOld);
      postToOwner([graphics = graphics(), software = CodeDecoder::isSoftware(m_gl)](PictureThread& owner) {
        Q_EMIT owner.started(graphics, software);
      });
      m_drawer.initialize();
    });
    m_works = failure.isEmpty();
    if (!m_works) postToOwner([failure](PictureThread& owner) { Q_EMIT owner.unavailable(failure); });
  }

  void release() {
    m_timer.stop();
    if (!m_works) return;
    guarded(latest, [this] {
      makeCurrent();
      m_drawer.release();
      m_readback.release(m_gl);
    });
    m_context->doneCurrent();
    m_works = false;
  }

  void request(std::shared_ptr<const PictureRequest> request) {
    const std::lock_guard lock(m_mutex);
    m_request = std::move(request);
    QMetaObject::invokeMethod(
        this, [this] { m_timer.start(0); }, Qt::QueuedConnection);
  }

  std::optional<PictureState> draw() {
    const std::shared_ptr<const PictureRequest> request = newest();
    if (!request || !m_works) return std::nullopt;
    std::optional<PictureState> state;
    guarded(request->number, [&] {
      makeCurrent();
      PictureState reached = m_drawer.addFrame(*request, [&] { return newest()->replaces(*request); });
      if (reached.isObsolete) return;  // the newer request has started the timer
      m_readback.begin(m_gl, request->viewport);
      m_drawer.present(*request);
      reached.picture = m_readback.read(m_gl);
      state = reached;
      if (const std::optional<int> wait = m_drawer.nextFrame(*request)) m_timer.start(*wait);
    });
    return state;
  }

  Image readFirst() {
    Image picture(1, 1);
    if (m_works)
      guarded(latest, [&] {
        makeCurrent();
        picture = m_drawer.readFirst();
      });
    return picture;
  }

 private:
  static constexpr int latest = std::numeric_limits<int>::max();  ///< of work that belongs to no request

  std::shared_ptr<const PictureRequest> newest() {
    const std::lock_guard lock(m_mutex);
    return m_request;
  }
  void makeCurrent() {
    if (!m_context->makeCurrent(const_cast<QOffscreenSurface*>(&m_surface)))
      throw Error("the graphics driver cannot render without a window");
  }
  QString graphics() {
    QStringList facts;
    for (const GLenum name : {GL_RENDERER, GL_VENDOR, GL_VERSION})
      facts << QString::fromUtf8(reinterpret_cast<const char*>(m_gl.glGetString(name)));
    return facts.join(QStringLiteral("; "));
  }
  /// A failure is reported; the next request gets its chance.
  template <typename Work>
  void guarded(int number, const Work& work) {
    const QString failure = TaskFailure::of(work);
    if (!failure.isEmpty()) report(failure, number);
  }
  void report(const QString& failure, int number) {
    postToOwner([failure, number](PictureThread& owner) { Q_EMIT owner.failed(failure, number); });
  }
  template <typename Say>
  void postToOwner(const Say& say) {
    QMetaObject::invokeMethod(
        &m_owner, [&owner = m_owner, say] { say(owner); }, Qt::QueuedConnection);
  }

  PictureThread& m_owner;
  const QOffscreenSurface& m_surface;
  QOpenGLContext* m_context;
  QOpenGLFunctions_4_1_Core m_gl;
  PictureDrawer m_drawer;
  PictureReadback m_readback;
  QTimer m_timer;
  std::mutex m_mutex;
  std::shared_ptr<const PictureRequest> m_request;
  bool m_works = false;
};

PictureThread::PictureThread(QObject* parent) : QObject(parent) { m_thread.setObjectName("preview"); }

PictureThread::~PictureThread() { stop(); }

void PictureThread::start(const QSurfaceFormat& format) {
  if (m_worker) return;
  m_surface = std::make_unique<QOffscreenSurface>();
  m_surface->setFormat(format);
  m_surface->create();
  m_worker = std::make_unique<Worker>(*this, *m_surface);
  if (QOpenGLContext::supportsThreadedOpenGL()) {
    m_worker->moveToThread(&m_thread);
    m_thread.start();
  }
  QMetaObject::invokeMethod(
      m_worker.get(), [worker = m_worker.get()] { worker->initialize(); }, Qt::QueuedConnection);
  if (m_request) m_worker->request(m_request);
}

void PictureThread::stop() {
  if (!m_worker) return;
  inThread([this] { m_worker->release(); });
  m_thread.quit();
  m_thread.wait();
  m_worker.reset();
  m_surface.reset();
}

void PictureThread::inThread(const std::function<void()>& work) {
  const bool here = m_worker->thread() == QThread::currentThread();
  QMetaObject::invokeMethod(m_worker.get(), work, here ? Qt::DirectConnection : Qt::BlockingQueuedConnection);
}

void PictureThread::request(const PictureRequest& request) {
  m_request = std::make_shared<const PictureRequest>(request);
  if (m_worker) m_worker->request(m_request);
}

PictureState PictureThread::drawNow() {
  std::optional<PictureState> state;
  if (m_worker) inThread([&] { state = m_worker->draw(); });
  return state.value_or(PictureState{});
}

Image PictureThread::readFirst() {
  Image picture(1, 1);
  if (m_worker) inThread([&] { picture = m_worker->readFirst(); });
  return picture;
}

}  // namespace gonio::widgets

#include "moc_picture_thread.cpp"
