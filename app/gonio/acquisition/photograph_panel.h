// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/photograph_session.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace gonio::widgets {
class DropOverlay;
}

namespace gonio::app {

class AcquisitionPanel;
class PhotographControls;
class PhotographViews;

/// The Photographs panel: reconstructs a material from photographs of a sphere under known light. The document does not
/// change until the result is opened, which is an undo step.
class PhotographPanel : public QWidget {
  Q_OBJECT

 public:
  /// @param acquisition the panel whose training set is used, and whose session opens the result.
  PhotographPanel(AcquisitionPanel& acquisition, BackgroundTasks& tasks, QWidget* parent = nullptr);

  PhotographSession& session() { return m_session; }
  PhotographControls& controls() const { return *m_controls; }
  PhotographViews& views() const { return *m_views; }
  QPushButton& startButton() const { return *m_start; }
  /// Description of the current state and of the possible next step.
  QString status() const;
  /// Whether no work is pending.
  bool isSettled() const { return !m_session.isBusy(); }
  void askForFiles();
  /// Prepares the panel for use: asks for files if there are no photographs.
  void present();

 Q_SIGNALS:
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 protected:
  QSize sizeHint() const override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* buildEmpty();
  void connectParts();
  void start();
  void openResult();
  void askForDescription();
  void refresh();
  QString statusText() const;

  AcquisitionPanel& m_acquisition;
  PhotographSession m_session;
  PhotographControls* m_controls;
  PhotographViews* m_views;
  QStackedWidget* m_content;
  QPushButton* m_start;
  QProgressBar* m_progress;
  QLabel* m_status;
  widgets::DropOverlay* m_overlay;
};

}  // namespace gonio::app
