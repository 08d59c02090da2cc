// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QStringList>

class QListView;

namespace gonio::widgets {

class LibraryModel;
class QuickLook;
struct LibraryCommon;

/// The materials that are selected in a library's grid, which stay so when they are listed again, and what the user
/// does with them: by a double-click, by keys, by the menu.
class LibrarySelection : public QObject {
  Q_OBJECT

 public:
  /// @param list shows the model. @param library beside which the quick look stands.
  LibrarySelection(QListView& list, LibraryModel& model, QWidget& library);

  /// One material is chosen, and nothing is offered for several.
  void setSingle();
  /// In the order in which they are shown.
  QStringList ids() const;
  /// Selects a material alone and scrolls to it; one that is not listed yet is selected when it comes.
  void select(const QString& id);
  /// The first material or the last; headings are none.
  void selectOutermost(bool first);
  /// As Enter does; nothing where no material is current.
  void openCurrent();
  QuickLook& quickLook() const { return *m_look; }

 Q_SIGNALS:
  void openRequested(const QString& id);
  /// As the reference of comparisons.
  void referenceRequested(const QString& id);
  /// As materials to interpolate between.
  void interpolationRequested(const QStringList& ids);
  /// The first is to be opened, the second compared with it.
  void pairRequested(const QString& first, const QString& second);
  void exportRequested(const QStringList& ids);
  /// Accuracy against cost of several materials.
  void studyRequested(const QStringList& ids);
  /// A large picture for the quick look, by its setPicture().
  void largePictureRequested(const QString& id);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showMenu(const QPoint& position);
  /// Selects what of m_kept is listed, and keeps the rest.
  void restore();
  /// Whether a key of the grid meant something.
  bool key(int key, Qt::KeyboardModifiers modifiers);
  bool keyFor(const QStringList& ids, int key, Qt::KeyboardModifiers modifiers);
  QString current() const;
  void setFavourites(const QStringList& ids, bool favourite);
  void setRating(const QStringList& ids, int rating);
  /// Asks for tags, starting from those that all have.
  void editTags(const QStringList& ids);
  LibraryCommon common(const QStringList& ids) const;
  void toggleLook();
  void showLook();

  QListView& m_list;
  LibraryModel& m_model;
  QuickLook* m_look;
  bool m_single = false;
  QStringList m_kept;  ///< what is selected when the materials are listed again
};

}  // namespace gonio::widgets
