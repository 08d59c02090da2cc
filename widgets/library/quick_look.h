// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFrame>

class QLabel;

namespace gonio::widgets {

/// A large picture of a material with information about it, beside the library; it never takes the focus.
class QuickLook : public QFrame {
  Q_OBJECT

 public:
  static constexpr int side = 384;  ///< of the image, in device-independent pixels

  explicit QuickLook(QWidget* library);

  /// @param text rich text. @param picture may be small or null; setPicture() replaces it.
  void showMaterial(const QString& id, const QString& text, const QImage& picture);
  /// Ignored if another material is shown.
  void setPicture(const QString& id, const QImage& picture);
  /// The id of the shown material.
  const QString& id() const { return m_id; }

 protected:
  void mousePressEvent(QMouseEvent* event) override;

 private:
  QString m_id;
  QLabel *m_picture, *m_text;
};

}  // namespace gonio::widgets
