// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;
class QToolButton;

namespace gonio::widgets {

/// A non-modal message at the top of the window: a warning, or a proposal with Apply and Discard.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  /// Shows a message below the last ones, which stay until the bar is hidden. A repeated message is shown once.
  void showMessage(const QString& text);
  /// Removes a message that is no longer true, if it is still shown.
  void withdraw(const QString& text);
  /// Shows a proposal below the messages.
  void showProposal(const QString& text);
  bool isProposal() const;

 Q_SIGNALS:
  void applied();
  void discarded();

 private:
  void present(const QString& text, bool proposal);
  void dismiss();

  QStringList m_shown;
  QLabel* m_text;
  QPushButton* m_apply;
  QPushButton* m_discard;
  QToolButton* m_close;
};

}  // namespace gonio::widgets
