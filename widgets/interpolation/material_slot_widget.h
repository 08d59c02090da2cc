// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFrame>
#include <QImage>

class QLabel;
class QToolButton;

namespace gonio::widgets {

/// The content of a material slot.
struct SlotContent {
  QString name;     ///< empty: the slot is empty
  QString toolTip;  ///< what the material is
  QImage picture;   ///< null: a placeholder disc
  QString note;     ///< below the name: a weight, "Opening...", or an error
  bool failed = false;
  bool removable = false;  ///< whether the slot itself can be removed, even if it is empty
};

/// A drop target for one material: a material of the library, or a file. Buttons put the open document's material or a
/// file in it; Delete empties it.
class MaterialSlotWidget : public QFrame {
  Q_OBJECT

 public:
  /// @param letter name of the material in the panel: A, B, ...
  explicit MaterialSlotWidget(QChar letter, QWidget* parent = nullptr);

  void setContent(const SlotContent& content);
  /// Sets only the note, which changes with every step of a drag.
  void setNote(const QString& note);
  const SlotContent& content() const { return m_content; }
  /// Enables the button Current, which puts the open material in the slot.
  void setCurrentAvailable(bool available);

 Q_SIGNALS:
  /// @param id a file, or the id of a library material.
  void materialDropped(const QString& id);
  void currentRequested();
  void fileRequested();
  void clearRequested();

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
  SlotContent m_content;
  QWidget* m_picture;
  QLabel *m_name, *m_note;
  QToolButton *m_current, *m_file, *m_clear;
  bool m_dropping = false;
};

}  // namespace gonio::widgets
