// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFrame>

class QLabel;

namespace gonio::widgets {

/// A large picture of a material with what is known of it, beside the library; it never takes the focus.
class QuickLook : public QFrame {
  Q_OBJECT

 public:
  static constexpr int side = 384;  ///< of the picture, without the ratio of device pixels

  explicit QuickLook(QWidget* library);

  /// @param text rich. @param picture may be small or null: a larger one follows by setPicture().
  void showMaterial(const QString& id, const QString& text, const QImage& picture);
  /// Ignored where it is of another material than the one that is shown.
  void setPicture(const QString& id, const QImage& picture);
  /// Of the material that is shown.
  const QString& id() const { return m_id; }

 protected:
  void mousePressEvent(QMouseEvent* event) override;

 private:
  QString m_id;
  QLabel *m_picture, *m_text;
};

}  // namespace gonio::widgets
