// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/acquisition/acquisition_result.h"
#include "app/gonio/document/background_task.h"

namespace gonio::app {

/// Reads the reference of an acquisition in the background: the measured material, with which the result is compared. A
/// new request replaces the running one.
class ReferenceReader : public QObject {
  Q_OBJECT

 public:
  using TableFactory = std::function<std::shared_ptr<const TabulatedBrdf>(const TaskControl&)>;

  explicit ReferenceReader(BackgroundTasks& tasks, QObject* parent = nullptr);

  /// Sets size and samples of the pictures of later references.
  void setPicture(const RenderOptions& picture) { m_picture = picture; }
  /// @param id a file or a material of the library
  void read(const QString& id);
  /// @param makeTable called in another thread
  void read(const QString& id, const QString& name, TableFactory makeTable);
  void clear();

  /// Null until it has been read.
  const AcquisitionReferencePtr& reference() const { return m_reference; }
  /// Id of the reference, also while it is being read; empty: none.
  QString id() const { return m_id; }
  QString name() const { return m_name; }
  bool isReading() const;

 Q_SIGNALS:
  /// Id, name or reference changed.
  void changed();
  /// The reference was read, or cleared.
  void finished();
  void failed(const QString& title, const QString& text);

 private:
  void start(std::function<AcquisitionReferencePtr(const TaskControl&)> make);
  void finish(const AcquisitionReferencePtr& reference);

  BackgroundTasks& m_tasks;
  RenderOptions m_picture = acquisitionPicture();
  QString m_id, m_name;
  AcquisitionReferencePtr m_reference;
};

}  // namespace gonio::app
