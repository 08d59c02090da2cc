// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace gonio::widgets {

/// A line over the preview that states that something other than the material is shown, with a button to end this.
class PreviewBanner : public QFrame {
  Q_OBJECT

 public:
  explicit PreviewBanner(QWidget* viewport);

  /// An empty text hides it.
  void showText(const QString& text, const QString& button);
  QString text() const { return m_whole; }
  QPushButton* button() const { return m_button; }
  QSize sizeHint() const override;

 Q_SIGNALS:
  void dismissed();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();

  QString m_whole;
  QLabel* m_text;
  QPushButton* m_button;
};

}  // namespace gonio::widgets
