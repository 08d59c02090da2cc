// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/support/task_control.h"

namespace gonio::app {

/// How a background task is reported to the user and how it relates to other tasks.
struct TaskRequest {
  QString title;        ///< "Loading chrome.binary"
  QString key;          ///< a newer task with the same key stops the older one, and the older result is dropped
  bool quiet = false;   ///< at low priority, shown only while nothing else runs, not cancelled by Esc (thumbnails)
  bool live = false;    ///< at normal priority in separate threads, never shown, not cancelled by Esc; for work after
                        ///< each step of an interaction (checks, comparisons, plots)
  bool file = false;    ///< writes a file requested by the user; such tasks run one after the other, are never replaced
                        ///< and have no key
  bool isLong = false;  ///< takes many seconds; runs in separate threads, so that short tasks need not wait for it
  std::shared_ptr<Pause> pause = nullptr;  ///< the work waits while it is paused
};

/// Runs all core functions outside the GUI thread. The work gets a TaskControl; its result is delivered in the thread
/// of this object, unless the task was replaced meanwhile. Destruction stops all work (stopAll()).
class BackgroundTasks : public QObject {
  Q_OBJECT

 public:
  explicit BackgroundTasks(QObject* parent = nullptr);
  ~BackgroundTasks() override;

  /// Runs `work` in another thread, then in this one `done` with the result, `failed` with the message of an exception,
  /// or `cancelled` after Cancelled; none of them if the task was replaced. Without `failed` the signal failed() is
  /// emitted, so that no failure is lost.
  template <class Result>
  void run(const TaskRequest& request, std::function<Result(const TaskControl&)> work, std::function<void(Result)> done,
           std::function<void(const QString&)> failed = {}, std::function<void()> cancelled = {}) {
    auto result = std::make_shared<std::unique_ptr<Result>>();
    start(request,
          [result, work = std::move(work)](const TaskControl& control) {
            *result = std::make_unique<Result>(work(control));
          },
          {[result, done = std::move(done)] { done(std::move(**result)); }, std::move(failed), std::move(cancelled)});
  }

  struct Info {
    QString title;
    double fraction;  ///< [0, 1]
    bool quiet;
    int id;        ///< for cancel()
    bool waiting;  ///< for earlier tasks
    bool canPause, paused;
  };
  /// The task for the status bar: the newest that is neither quiet nor live, else a quiet one.
  std::optional<Info> topmost() const;
  /// All tasks that are neither quiet nor live, oldest first.
  std::vector<Info> shown() const;
  /// Whether files requested by the user are being written or waiting.
  bool isWritingFiles() const;
  bool isRunning(const QString& key) const;
  /// Progress of a task, [0, 1]; nullopt if it is not running.
  std::optional<double> progress(const QString& key) const;
  bool isIdle() const { return m_tasks.empty(); }

  /// Holds new tasks until release(), at most this long, so that the processors are free for urgent work.
  void hold(int maxMilliseconds);
  void release();

  /// Asks a task to stop; its `cancelled` or `done` is still called.
  void cancel(const QString& key);
  void cancel(int id);
  /// Pauses or resumes a task that has a Pause.
  void setPaused(int id, bool paused);
  /// Stops a task and drops its result.
  void drop(const QString& key);
  /// Stops all work, waits for the threads and drops the results.
  void stopAll();

 public Q_SLOTS:
  /// Cancels the newest task that is neither quiet nor live.
  void cancelTopmost();

 Q_SIGNALS:
  /// A task started, progressed or ended.
  void changed();
  /// A task without a `failed` callback failed.
  void failed(const QString& title, const QString& text);

 private:
  struct Callbacks {
    std::function<void()> done;
    std::function<void(const QString&)> failed;
    std::function<void()> cancelled;
  };
  struct Task;
  enum class Outcome { done, failed, cancelled };

  void start(const TaskRequest& request, std::function<void(const TaskControl&)> work, Callbacks callbacks);
  void finish(const std::shared_ptr<Task>& task, Outcome outcome, const QString& error);

  static Info infoOf(const Task& task);
  /// Running tasks take precedence over waiting ones.
  std::shared_ptr<Task> newestShown() const;

  QThreadPool m_pool, m_longPool, m_lowPriorityPool, m_livePool, m_filePool;
  QTimer m_progressTimer, m_holdTimer;  ///< the latter runs while tasks are held
  std::vector<std::function<void()>> m_held;
  int m_lastId = 0;
  std::vector<std::shared_ptr<Task>> m_tasks;  ///< tasks with results that are still needed, oldest first
};

}  // namespace gonio::app
