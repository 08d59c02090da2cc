// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFrame>
#include <QImage>

class QLabel;
class QToolButton;

namespace gonio::widgets {

/// What a well shows.
struct WellContent {
  QString name;     ///< empty: nothing is in it
  QString toolTip;  ///< what the material is
  QImage picture;   ///< null: a quiet disc
  QString note;     ///< below the name: a weight, "Opening...", what went wrong
  bool failed = false;
  bool removable = false;  ///< the place itself can be taken away, also when it is empty
};

/// A place for one material: dropped from the library or the desktop, taken from what is open, or from a file. Buttons
/// do the same for the keyboard; Delete empties it.
class MaterialWell : public QFrame {
  Q_OBJECT

 public:
  /// @param letter what the material is called in the panel: A, B.
  explicit MaterialWell(QChar letter, QWidget* parent = nullptr);

  void setContent(const WellContent& content);
  /// The note alone: what changes with every step of a drag.
  void setNote(const QString& note);
  const WellContent& content() const { return m_content; }
  void setCurrentAvailable(bool available);

  QToolButton* currentButton() const { return m_current; }
  QToolButton* fileButton() const { return m_file; }
  QToolButton* clearButton() const { return m_clear; }

 Q_SIGNALS:
  /// A file, or the id of a library's material.
  void materialDropped(const QString& id);
  void currentWanted();
  void fileWanted();
  void clearWanted();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QToolButton* addButton(const QString& text, const QString& toolTip);
  void showTexts();

  QChar m_letter;
  WellContent m_content;
  QWidget* m_picture;
  QLabel *m_name, *m_note;
  QToolButton *m_current, *m_file, *m_clear;
  bool m_dropping = false;
};

}  // namespace gonio::widgets
