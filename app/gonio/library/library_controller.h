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

/// Fills the library with the bundled materials or with a folder, and renders the thumbnails in the background, visible
/// ones first.
class LibraryController : public QObject {
  Q_OBJECT

 public:
  using ThumbnailFactory = std::function<widgets::LibraryThumbnail(const QString& id, const TaskControl&)>;

  /// @param ownFolder folder of the user's own materials, shown with the bundled ones; need not exist. Empty: none.
  LibraryController(BackgroundTasks& tasks, ThumbnailFactory makeThumbnail, QString ownFolder = {},
                    QObject* parent = nullptr);

  widgets::LibraryModel& model() { return m_model; }
  /// Shows the bundled materials and those of the user's own folder.
  void showBundled();
  /// Lists the user's own folder again after a document was saved there. The folder may be new.
  void addOwn(const QString& path);
  QString ownFolder() const { return m_ownFolder; }
  /// Shows all materials and documents in a folder, without subfolders. The folder is listed in the background, and
  /// again when files are added, removed or changed.
  void showFolder(const QString& folder);
  /// Sets the reference of LibraryModel::DissimilarityRole; empty: none. Renders its thumbnail if necessary.
  void setReference(const QString& id);
  /// Renders a large picture in the background, `pixels` wide and high. Only the last requested picture is delivered.
  void makeLargePicture(const QString& id, int pixels);
  QString title() const { return m_title; }
  QString folder() const { return m_folder; }  ///< empty for the bundled library
  /// Whether all visible thumbnails are available.
  bool isVisibleComplete() const;

 public Q_SLOTS:
  void setVisible(const QStringList& ids);

 Q_SIGNALS:
  void titleChanged(const QString& title);
  /// A material that the user has just saved will appear in the list.
  void added(const QString& id);
  void largePictureMade(const QString& id, const QImage& picture);

 private:
  void begin(const QString& title, const QString& folder);
  void listFolder();
  void listOwn();
  void watch(const QString& folder);
  void show(std::vector<widgets::LibraryItem> items);
  void makeNext();
  /// Ids without a thumbnail, visible ones first.
  QStringList nextOnes() const;

  BackgroundTasks& m_tasks;
  ThumbnailFactory m_makeThumbnail;
  widgets::LibraryModel m_model;
  QStringList m_visible;
  QString m_title, m_folder;
  const QString m_ownFolder;
  QFileSystemWatcher m_watcher;
  QTimer m_change;  ///< delays listing until a folder has not changed for a while
};

}  // namespace gonio::app
