// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <functional>

#include "app/gonio/document/background_task.h"
#include "widgets/library/library_model.h"

namespace gonio::app {

/// Fills the library with the bundled materials or with a folder, and has the pictures made in the background, those in
/// sight first.
class LibraryController : public QObject {
  Q_OBJECT

 public:
  using ThumbnailFactory = std::function<widgets::LibraryLook(const QString& id, const TaskControl&)>;

  /// @param ownFolder whose materials stand beside the bundled ones; it need not be there. Empty: none.
  LibraryController(BackgroundTasks& tasks, ThumbnailFactory makeLook, QString ownFolder = {},
                    QObject* parent = nullptr);

  widgets::LibraryModel& model() { return m_model; }
  /// The bundled materials, and those of the user's own folder.
  void showBundled();
  /// Lists the user's own folder again, which may be new, because a document has been saved there.
  void addOwn(const QString& path);
  QString ownFolder() const { return m_ownFolder; }
  /// Every material and document in a folder, not in its subfolders. It is listed in the background, and again when
  /// files come, go or change.
  void showFolder(const QString& folder);
  /// The material that LibraryModel::DissimilarityRole compares with; empty: none. Its picture is made where there is
  /// none.
  void setReference(const QString& id);
  /// Has a large picture made, of `pixels` a side; only the last one that is asked for comes.
  void makeLargePicture(const QString& id, int pixels);
  QString title() const { return m_title; }
  QString folder() const { return m_folder; }  ///< empty for the bundled library
  /// Whether every picture in sight is there.
  bool isVisibleComplete() const;

 public Q_SLOTS:
  void setVisible(const QStringList& ids);

 Q_SIGNALS:
  void titleChanged(const QString& title);
  /// A material comes into the list soon that the user has just saved.
  void added(const QString& id);
  void largePictureMade(const QString& id, const QImage& picture);

 private:
  void begin(const QString& title, const QString& folder);
  void listFolder();
  void listOwn();
  void watch(const QString& folder);
  void show(std::vector<widgets::LibraryItem> items);
  void makeNext();
  /// What is not there yet, those in sight first.
  QStringList nextOnes() const;

  BackgroundTasks& m_tasks;
  ThumbnailFactory m_makeLook;
  widgets::LibraryModel m_model;
  QStringList m_visible;
  QString m_title, m_folder;
  const QString m_ownFolder;
  QFileSystemWatcher m_watcher;
  QTimer m_change;  ///< runs out when a folder has been quiet
};

}  // namespace gonio::app
