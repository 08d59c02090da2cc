// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractButton>
#include <QPixmap>
#include <QWidget>

#include "app/gonio/inspector/inspector.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace gonio::app {

class RecentFiles;

/// A picture with a name below it, and optionally a sentence; a button.
class StartTile : public QAbstractButton {
  Q_OBJECT

 public:
  /// @param size of the picture, in heights of a line.
  StartTile(const QString& picture, const QSizeF& size, const QString& name, const QString& sentence = {});

  /// Enlarges the picture; 1 at first.
  void setScale(double scale);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QSize pictureSize() const;

  QPixmap m_picture;
  QSizeF m_size;
  double m_scale = 1;
  QString m_sentence;
};

/// What the viewport shows while nothing is open: recent files, six materials, Open, and one picture for each kind of
/// editing. It covers its parent, with larger pictures where there is room.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  StartPage(const RecentFiles& recent, QWidget* parent);

  /// Ids of the six materials, in order.
  static QStringList materials();
  /// Shows the page with the current recent files, or hides it.
  void setWanted(bool wanted);
  /// The name of the material that is being opened, which the page states; empty: none.
  void setOpening(const QString& name);
  QPushButton* openButton() const { return m_open; }

 Q_SIGNALS:
  void openRequested(const QString& path);
  /// The user wants to choose a file.
  void fileRequested();
  void kindRequested(gonio::app::EditingKind kind);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addHeading(const QString& text);
  void addMaterials();
  void addKinds();
  void showRecent();

  const RecentFiles& m_recent;
  QVBoxLayout* m_column;
  QLabel* m_title;
  QPushButton* m_open;
  QWidget* m_recentBox;
};

}  // namespace gonio::app
