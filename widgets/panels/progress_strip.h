// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

class QLabel;
class QProgressBar;
class QToolButton;

namespace gonio::widgets {

/// Text, bar and Cancel button of the work in progress, for a status bar; a list of all of it where there is more than
/// one piece. While there is none, the last notice is shown for some seconds.
class ProgressStrip : public QWidget {
  Q_OBJECT

 public:
  explicit ProgressStrip(QWidget* parent = nullptr);

  /// One piece of work in the list.
  struct Entry {
    int id;
    QString text;  ///< "Exporting chrome.bsdf, 40 %"
  };

  enum class Pausing { no, running, paused };
  void showProgress(const QString& text, double fraction, bool canCancel, Pausing pausing = Pausing::no);
  void clear();
  /// Shown as a list where there are two or more.
  void setEntries(const std::vector<Entry>& entries);
  /// What has been done ("Wrote chrome.bsdf"), beside the work that goes on.
  void showNotice(const QString& text, int milliseconds);
  QString notice() const;
  QToolButton* entriesButton() const { return m_entries; }

 Q_SIGNALS:
  void cancelRequested();
  /// Or to go on.
  void pauseRequested(bool pause);
  /// Of one entry of the list.
  void entryCancelRequested(int id);

 private:
  QLabel *m_text, *m_notice;
  QProgressBar* m_bar;
  QToolButton *m_cancel, *m_pause, *m_entries;
  QTimer m_noticeTime;
};

}  // namespace gonio::widgets
