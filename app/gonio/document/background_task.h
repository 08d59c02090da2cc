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

#include "core/support/pause.h"
#include "core/support/task_control.h"

namespace gonio::app {

/// How a piece of background work is reported to the user and how it relates to other work.
struct TaskRequest {
  QString title;       ///< "Loading chrome.binary"
  QString key;         ///< a newer task of the same key stops and replaces an older one: its result is dropped
  bool quiet = false;  ///< at low priority, shown only while nothing else runs, not cancelled by Esc (thumbnails)
  bool live = false;   ///< at normal priority in threads of their own, never shown, not cancelled by Esc: what follows
                       ///< each step of the user's hand (checks, comparisons, plots)
  bool file = false;   ///< it writes a file that the user asked for: one after the other, never replaced; key: none
  std::shared_ptr<Pause> pause = nullptr;  ///< the work waits while it is on
};

/// The one place that runs core functions off the GUI thread. Work gets a TaskControl; its result comes back to the
/// thread of this object, unless the task was replaced meanwhile. Destroying the object stops all work (stopAll()).
class BackgroundTasks : public QObject {
  Q_OBJECT

 public:
  explicit BackgroundTasks(QObject* parent = nullptr);
  ~BackgroundTasks() override;

  /// Runs `work` in another thread, then in this one: `done` with its result, or `failed` with the text of what it
  /// threw, or `cancelled` when it threw Cancelled. None of them for a task that was replaced. Without `failed` the
  /// signal of that name is emitted, so that no failure is lost.
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
    bool waiting;  ///< for those before it
    bool canPause, paused;
  };
  /// What the status bar shows: the newest task that is neither quiet nor live, else a quiet one.
  std::optional<Info> topmost() const;
  /// All that is neither quiet nor live, oldest first.
  std::vector<Info> shown() const;
  /// Whether files that the user asked for are still being written or waiting for it.
  bool isWritingFiles() const;
  bool isRunning(const QString& key) const;
  /// Its share, [0, 1]; nothing where it does not run.
  std::optional<double> progress(const QString& key) const;
  bool isIdle() const { return m_tasks.empty(); }

  /// Work that is asked for from now on waits for release(), at most this long: what is urgent has the processors.
  void hold(int maxMilliseconds);
  void release();

  /// Asks a task to stop; its `cancelled` or `done` still comes.
  void cancel(const QString& key);
  void cancel(int id);
  /// Of a task that can pause: it goes on when it is asked to.
  void setPaused(int id, bool paused);
  /// Stops a task and drops its result.
  void drop(const QString& key);
  /// Stops all work, waits until no thread is at work any more and drops the results.
  void stopAll();

 public Q_SLOTS:
  /// Cancels the newest task that is neither quiet nor live. Those end with what they belong to.
  void cancelTopmost();

 Q_SIGNALS:
  /// A task started, ended or progressed.
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
  /// One that runs comes before those that wait for it.
  std::shared_ptr<Task> newestShown() const;

  QThreadPool m_pool, m_quietPool, m_livePool, m_filePool;
  QTimer m_progressTimer, m_holdTimer;  ///< the latter runs while work is held
  std::vector<std::function<void()>> m_held;
  int m_lastId = 0;
  std::vector<std::shared_ptr<Task>> m_tasks;  ///< those whose result is still wanted, oldest first
};

}  // namespace gonio::app
