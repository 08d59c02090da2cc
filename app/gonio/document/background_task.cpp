// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/background_task.h"

#include <QPointer>
#include <algorithm>
#include <cassert>
#include <utility>

#include "core/math/parallel.h"

namespace gonio::app {

namespace {
constexpr int progressMilliseconds = 80;
constexpr int foregroundThreads = 2, longThreads = 2, liveThreads = 2;
/// A check of a minute must not keep the library without its pictures.
constexpr int lowPriorityThreads = 2;
}  // namespace

struct BackgroundTasks::Task {
  TaskRequest request;
  std::stop_source stop;
  std::atomic<double> fraction{0};
  std::atomic<bool> waiting{true};
  int id = 0;
  Callbacks callbacks;
};

BackgroundTasks::BackgroundTasks(QObject* parent) : QObject(parent) {
  m_pool.setMaxThreadCount(foregroundThreads);
  m_longPool.setMaxThreadCount(longThreads);
  m_lowPriorityPool.setMaxThreadCount(lowPriorityThreads);
  m_livePool.setMaxThreadCount(liveThreads);
  m_filePool.setMaxThreadCount(1);
  m_progressTimer.setInterval(progressMilliseconds);
  connect(&m_progressTimer, &QTimer::timeout, this, &BackgroundTasks::changed);
  m_holdTimer.setSingleShot(true);
  connect(&m_holdTimer, &QTimer::timeout, this, &BackgroundTasks::release);
}

BackgroundTasks::~BackgroundTasks() { stopAll(); }

void BackgroundTasks::start(const TaskRequest& request, std::function<void(const TaskControl&)> work,
                            Callbacks callbacks) {
  assert(request.key.isEmpty() == request.file);
  if (!request.file) drop(request.key);
  auto task = std::make_shared<Task>();
  task->id = ++m_lastId;
  task->request = request;
  task->callbacks = std::move(callbacks);
  m_tasks.push_back(task);
  m_progressTimer.start();

  const auto body = [this, task, work = std::move(work)] {
    Outcome outcome = Outcome::done;
    QString error;
    task->waiting = false;
    try {
      const TaskControl control{task->stop.get_token(), [task](double fraction) { task->fraction = fraction; }};
      control.throwIfStopped();
      work(control);
    } catch (const Cancelled&) {
      outcome = Outcome::cancelled;
    } catch (const std::bad_alloc&) {
      outcome = Outcome::failed;
      error = tr("Not enough memory. Close other windows or programs and try again.");
    } catch (const std::exception& exception) {
      outcome = Outcome::failed;
      error = QString::fromUtf8(exception.what());
    }
    QMetaObject::invokeMethod(
        this, [this, task, outcome, error] { finish(task, outcome, error); }, Qt::QueuedConnection);
  };
  const auto launch = [this, request, body] {
    if (request.quiet)
      m_lowPriorityPool.start([body] { runAtLowPriority(body); });
    else if (request.live)
      m_livePool.start(body);
    else if (request.file)
      m_filePool.start(body);
    else if (request.isLong)
      m_longPool.start(body);
    else
      m_pool.start(body);
  };
  if (m_holdTimer.isActive())
    m_held.push_back(launch);
  else
    launch();
  Q_EMIT changed();
}

void BackgroundTasks::hold(int maxMilliseconds) { m_holdTimer.start(maxMilliseconds); }

void BackgroundTasks::release() {
  m_holdTimer.stop();
  for (const auto& launch : std::exchange(m_held, {})) launch();
}

void BackgroundTasks::finish(const std::shared_ptr<Task>& task, Outcome outcome, const QString& error) {
  const auto found = std::find(m_tasks.begin(), m_tasks.end(), task);
  if (found == m_tasks.end()) return;  // replaced or dropped: nobody waits for it any more
  m_tasks.erase(found);
  if (m_tasks.empty()) m_progressTimer.stop();
  const Callbacks& callbacks = task->callbacks;
  const QPointer<BackgroundTasks> guard(this);  // a callback may end the window
  if (outcome == Outcome::done)
    callbacks.done();
  else if (outcome == Outcome::failed && callbacks.failed)
    callbacks.failed(error);
  else if (outcome == Outcome::failed)
    Q_EMIT failed(tr("%1 failed").arg(task->request.title), error);
  else if (outcome == Outcome::cancelled && callbacks.cancelled)
    callbacks.cancelled();
  if (guard) Q_EMIT changed();
}

std::shared_ptr<BackgroundTasks::Task> BackgroundTasks::newestShown() const {
  std::shared_ptr<Task> newest;
  for (const auto& task : m_tasks)
    if (!task->request.quiet && !task->request.live && (!newest || !(task->request.file && task->waiting)))
      newest = task;
  return newest;
}

BackgroundTasks::Info BackgroundTasks::infoOf(const Task& task) {
  const auto& pause = task.request.pause;
  return {task.request.title, task.fraction,    task.request.quiet,    task.id,
          task.waiting,       pause != nullptr, pause && pause->isOn()};
}

std::optional<BackgroundTasks::Info> BackgroundTasks::topmost() const {
  if (const auto task = newestShown()) return infoOf(*task);
  const auto quiet = std::find_if(m_tasks.begin(), m_tasks.end(), [](const auto& t) { return t->request.quiet; });
  if (quiet == m_tasks.end()) return std::nullopt;
  return infoOf(**quiet);
}

std::vector<BackgroundTasks::Info> BackgroundTasks::shown() const {
  std::vector<Info> result;
  for (const auto& task : m_tasks)
    if (!task->request.quiet && !task->request.live) result.push_back(infoOf(*task));
  return result;
}

bool BackgroundTasks::isWritingFiles() const {
  return std::any_of(m_tasks.begin(), m_tasks.end(), [](const auto& t) { return t->request.file; });
}

bool BackgroundTasks::isRunning(const QString& key) const {
  return std::any_of(m_tasks.begin(), m_tasks.end(), [&](const auto& t) { return t->request.key == key; });
}

std::optional<double> BackgroundTasks::progress(const QString& key) const {
  const auto found = std::find_if(m_tasks.begin(), m_tasks.end(), [&](const auto& t) { return t->request.key == key; });
  if (found == m_tasks.end()) return std::nullopt;
  return (*found)->fraction;
}

void BackgroundTasks::cancel(const QString& key) {
  for (const auto& task : m_tasks)
    if (task->request.key == key) task->stop.request_stop();
}

void BackgroundTasks::cancel(int id) {
  for (const auto& task : m_tasks)
    if (task->id == id) task->stop.request_stop();
}

void BackgroundTasks::setPaused(int id, bool paused) {
  for (const auto& task : m_tasks)
    if (task->id == id && task->request.pause) task->request.pause->set(paused);
  Q_EMIT changed();
}

void BackgroundTasks::drop(const QString& key) {
  cancel(key);
  // They go once the list is whole again: what a callback holds may drop tasks of its own.
  const auto last =
      std::stable_partition(m_tasks.begin(), m_tasks.end(), [&](const auto& t) { return t->request.key != key; });
  const std::vector<std::shared_ptr<Task>> dropped(last, m_tasks.end());
  m_tasks.erase(last, m_tasks.end());
}

void BackgroundTasks::stopAll() {
  for (const auto& task : m_tasks) task->stop.request_stop();
  m_held.clear();
  QThreadPool* const pools[] = {&m_lowPriorityPool, &m_livePool, &m_filePool, &m_longPool, &m_pool};
  for (QThreadPool* pool : pools) pool->clear();
  for (QThreadPool* pool : pools) pool->waitForDone();
  m_progressTimer.stop();
  // They go once the list is empty: what a callback holds may drop tasks of its own.
  const auto dropped = std::exchange(m_tasks, {});
}

void BackgroundTasks::cancelTopmost() {
  if (const auto task = newestShown()) task->stop.request_stop();
}

}  // namespace gonio::app

#include "moc_background_task.cpp"
