// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace gonio::widgets {

/// Text, bar and Cancel button of the work in progress, for a status bar. Invisible while there is none.
class ProgressStrip : public QWidget {
  Q_OBJECT

 public:
  explicit ProgressStrip(QWidget* parent = nullptr);

  void showProgress(const QString& text, double share, bool canCancel);
  void clear();

 Q_SIGNALS:
  void cancelRequested();

 private:
  QLabel* m_text;
  QProgressBar* m_bar;
  QToolButton* m_cancel;
};

}  // namespace gonio::widgets
