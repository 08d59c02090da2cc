// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QObject>
#include <optional>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"

namespace gonio::app {

/// One of the materials that are blended.
struct BlendEnd {
  QString name, description;
  QImage picture;
  editing::InterpolationEnd material;  ///< with its edits
  editing::EditDocument source;        ///< what it takes to make it again; resolved paths
};

/// A file, a .gonio document, or a library's material by its id. Draws its picture. @throws Error, Cancelled.
BlendEnd readBlendEnd(const QString& id, const TaskControl& control);
/// An open material with the edits of `source`. @throws Cancelled.
BlendEnd takeBlendEnd(const LoadedMaterial& material, const QString& name, editing::EditDocument source,
                      const TaskControl& control);

/// The materials of the Interpolation panel, two to four places, and the reading of them in the background. Nothing of
/// it is part of the document.
class BlendEnds : public QObject {
  Q_OBJECT

 public:
  BlendEnds(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr);

  int count() const { return int(m_places.size()); }
  /// Null while the place is empty; one that is filled anew has its old material until then.
  const BlendEnd* at(int place) const;
  bool isReading(int place) const;
  /// What went wrong there, else empty.
  QString failure(int place) const { return m_places[std::size_t(place)].failure; }
  /// Every place has its material.
  bool isComplete() const;
  bool isReading() const;
  /// All materials; complete ones only.
  std::vector<editing::InterpolationEnd> ends() const;

  /// A file, a .gonio document, or a library's material by its id.
  void read(int place, const QString& id);
  /// The document's material as it is now, with its edits.
  void takeCurrent(int place);
  void clear(int place);
  void addPlace();
  void removePlace(int place);
  void swap(int first, int second);

 Q_SIGNALS:
  /// A place was filled, emptied, added or taken away: isComplete() and ends() may be others now.
  void changed();
  /// Only the words of a place changed: it is being read, or that failed.
  void stateChanged();
  void failed(const QString& title, const QString& text);

 private:
  struct Place {
    std::optional<BlendEnd> end;
    QString failure;
    int key;  ///< of its task
  };
  void fill(int place, const QString& title, const QString& name, std::function<BlendEnd(const TaskControl&)> make);
  int placeOf(int key) const;
  QString taskKey(int key) const;

  Document& m_document;
  BackgroundTasks& m_tasks;
  std::vector<Place> m_places;
  int m_nextKey = 0;
};

}  // namespace gonio::app
