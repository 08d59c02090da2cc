// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>
#include <optional>

#include "core/rendering/render_material.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

/// What rendering wants to know of a subject.
struct MaterialEstimate {
  std::shared_ptr<const TabulatedLobe> lobe;
  std::shared_ptr<const RenderMaterial> material;
};

/// Estimates how a subject is sampled and what it reflects in another thread: some 10 ms; some 100 for a blend of codes
/// over different dictionaries. While one estimate runs, of all further requests the newest alone is kept.
class MaterialEstimator : public QObject {
  Q_OBJECT

 public:
  explicit MaterialEstimator(QObject* parent = nullptr);
  ~MaterialEstimator() override;

  void request(const PreviewSubject& subject);
  /// Forgets what was requested: nothing is reported any more.
  void cancel();
  bool isBusy() const { return m_busy; }

 Q_SIGNALS:
  void estimated(const gonio::widgets::MaterialEstimate& estimate);
  /// The newest request came to nothing.
  void failed(const QString& message);

 private:
  void start(const PreviewSubject& subject);
  void finish();

  struct Outcome {
    MaterialEstimate estimate;
    QString failure;  ///< empty: there is an estimate
  };
  QThreadPool m_pool;  ///< not the global one, which Qt paints with: painting would wait for this work
  QFutureWatcher<Outcome> m_watcher;
  std::optional<PreviewSubject> m_next;
  bool m_busy = false, m_wanted = false;
};

}  // namespace gonio::widgets
