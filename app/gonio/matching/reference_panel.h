// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace gonio::widgets {
class PreviewWidget;
}

namespace gonio::app {

class Document;
class MatchController;
class ReferenceView;

/// The reference image beside the preview, at the scale of its ball, with Match, Take and Leave. Hidden without an
/// image.
class ReferencePanel : public QWidget {
  Q_OBJECT

 public:
  ReferencePanel(MatchController& match, const Document& document, widgets::PreviewWidget& preview,
                 QWidget* parent = nullptr);

  ReferenceView& view() { return *m_view; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void build();
  void refresh();
  void showScale();
  QString message() const;
  QString proposalText() const;

  MatchController& m_match;
  const Document& m_document;
  widgets::PreviewWidget& m_preview;
  QLabel *m_title, *m_text;
  QToolButton* m_close;
  ReferenceView* m_view;
  QComboBox* m_tones;
  QPushButton *m_start, *m_take, *m_leave;
  QProgressBar* m_progress;
};

}  // namespace gonio::app
