// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>
#include <QObject>
#include <QStringList>
#include <functional>
#include <vector>

class QListView;

namespace gonio::widgets {

/// Actions for the selected materials of a library: for one, two, or several. Entries without a function are omitted.
struct LibraryActions {
  using One = std::function<void(const QString& id)>;
  using Several = std::function<void(const QStringList& ids)>;

  struct Quality {
    QString id, name;  ///< name: e.g. "measured"
  };

  One open, look, compare;
  std::vector<Quality> qualities;         ///< of one material, if there are several, to open
  Several comparePair;                    ///< of two ids
  Several interpolate, study, exportAll;  ///< study: of two or more ids
  std::function<void(const QStringList& ids, bool favourite)> favour;
  std::function<void(const QStringList& ids, int rating)> rate;
  Several tag;
};

/// Common properties of the selected materials; false or 0 if they differ.
struct CommonNotes {
  bool favourites = false;
  int rating = 0;
};

/// A menu that deletes itself when it closes.
QMenu* libraryMenu(const QStringList& ids, const CommonNotes& common, const LibraryActions& actions, QWidget* parent);

class LibraryModel;
class QuickLook;

/// The selection in a library's grid, which stays when the library is listed again, and the user's actions on it
/// (double-click, keys, menu).
class LibrarySelection : public QObject {
  Q_OBJECT

 public:
  /// @param list the view of the model. @param library the widget beside which the quick look appears.
  LibrarySelection(QListView& list, LibraryModel& model, QWidget& library);

  /// Restricts the selection to one material and hides actions for several.
  void setSingle();
  /// The selected ids, in the order of display.
  QStringList ids() const;
  /// Selects only this material and scrolls to it; if it is not listed yet, it is selected later.
  void select(const QString& id);
  /// Selects the first or the last material, without headings.
  void selectOutermost(bool first);
  /// Opens the current material, if any, like Enter.
  void openCurrent();
  QuickLook& quickLook() const { return *m_look; }

 Q_SIGNALS:
  void openRequested(const QString& id);
  /// The user chose a material as the reference of comparisons.
  void referenceRequested(const QString& id);
  /// The user chose materials to interpolate.
  void interpolationRequested(const QStringList& ids);
  /// Open the first material and compare it with the second.
  void pairRequested(const QString& first, const QString& second);
  void exportRequested(const QStringList& ids);
  /// The user requested a study of several materials.
  void studyRequested(const QStringList& ids);
  /// The quick look needs a large picture; pass it to setPicture().
  void largePictureRequested(const QString& id);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showMenu(const QPoint& position);
  /// Selects the listed materials of m_kept and stores the others for later.
  void restore();
  /// Handles a key of the grid; returns whether it had an effect.
  bool key(int key, Qt::KeyboardModifiers modifiers);
  bool keyFor(const QStringList& ids, int key, Qt::KeyboardModifiers modifiers);
  QString current() const;
  void setFavourites(const QStringList& ids, bool favourite);
  void setRating(const QStringList& ids, int rating);
  /// Asks the user for tags, initially those common to all.
  void editTags(const QStringList& ids);
  CommonNotes common(const QStringList& ids) const;
  std::vector<LibraryActions::Quality> qualities(const QString& id) const;
  void toggleLook();
  void showLook();

  QListView& m_list;
  LibraryModel& m_model;
  QuickLook* m_look;
  bool m_single = false;
  QStringList m_kept;  ///< what is selected when the materials are listed again
};

}  // namespace gonio::widgets
