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

/// Text, progress bar and Cancel button of running tasks, for a status bar; a list if there are several. Beside them,
/// the last notice is shown for a limited time.
class ProgressStrip : public QWidget {
  Q_OBJECT

 public:
  explicit ProgressStrip(QWidget* parent = nullptr);

  /// One task in the list.
  struct Entry {
    int id;
    QString text;  ///< e.g. "Exporting chrome.bsdf, 40 %"
  };

  enum class Pausing { no, running, paused };
  void showProgress(const QString& text, double fraction, bool canCancel, Pausing pausing = Pausing::no);
  void clear();
  /// Shown as a list if there are two or more.
  void setEntries(const std::vector<Entry>& entries);
  /// Shows a result, such as "Wrote chrome.bsdf", for this time.
  void showNotice(const QString& text, int milliseconds);
  QString notice() const;

 Q_SIGNALS:
  void cancelRequested();
  /// @param pause false: continue.
  void pauseRequested(bool pause);
  /// The user cancelled one entry of the list.
  void entryCancelRequested(int id);

 private:
  QLabel *m_text, *m_notice;
  QProgressBar* m_bar;
  QToolButton *m_cancel, *m_pause, *m_entries;
  QTimer m_noticeTime;
};

}  // namespace gonio::widgets
