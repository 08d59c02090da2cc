// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

class QLabel;
class QStatusBar;

namespace gonio::widgets {
class PreviewWidget;
class ProgressStrip;
}  // namespace gonio::widgets

namespace gonio::app {

class BackgroundTasks;
class ComparisonController;
class Document;

/// The content of a window's status bar: running tasks, the content of the preview, its samples and frame time.
class StatusLine : public QObject {
  Q_OBJECT

 public:
  StatusLine(QStatusBar& bar, const Document& document, BackgroundTasks& tasks, const ComparisonController& comparison,
             const widgets::PreviewWidget& preview);

  /// Shows a message for a few seconds, e.g. "Wrote chrome.bsdf".
  void showNotice(const QString& text);
  widgets::ProgressStrip& progress() { return *m_progress; }

 private:
  QLabel* addPermanent(QStatusBar& bar, const QString& toolTip, const QString& widest = {});
  void showProgress();
  QString representationText() const;
  QString formText() const;

  const Document& m_document;
  BackgroundTasks& m_tasks;
  const ComparisonController& m_comparison;
  const widgets::PreviewWidget& m_preview;
  widgets::ProgressStrip* m_progress;
};

}  // namespace gonio::app
