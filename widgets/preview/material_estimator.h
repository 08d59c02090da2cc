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

/// The properties of a subject that rendering needs.
struct MaterialEstimate {
  std::shared_ptr<const TabulatedDensity> lobe;
  std::shared_ptr<const RenderMaterial> material;
};

/// Estimates a subject's sampling density and albedo in another thread: about 10 ms, or about 100 ms for a blend of
/// codes with different dictionaries. While an estimate runs, only the newest further request waits.
class MaterialEstimator : public QObject {
  Q_OBJECT

 public:
  explicit MaterialEstimator(QObject* parent = nullptr);
  ~MaterialEstimator() override;

  void request(const PreviewSubject& subject);
  /// Drops all requests; their results are not reported.
  void cancel();
  bool isBusy() const { return m_busy; }

 Q_SIGNALS:
  void estimated(const gonio::widgets::MaterialEstimate& estimate);
  /// The newest request failed.
  void failed(const QString& message);

 private:
  void start(const PreviewSubject& subject);
  void finish();

  struct Outcome {
    MaterialEstimate estimate;
    QString failure;  ///< empty on success
  };
  QThreadPool m_pool;  ///< separate from the global pool, which Qt uses for painting, so that painting does not wait
  QFutureWatcher<Outcome> m_watcher;
  std::optional<PreviewSubject> m_next;
  bool m_busy = false, m_wanted = false;
};

}  // namespace gonio::widgets
