// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QWidget>

namespace gonio::app {

/// Two pictures of the same size side by side with their names below; missing pictures leave an empty area.
class ExportPictures : public QWidget {
  Q_OBJECT

 public:
  explicit ExportPictures(QWidget* parent = nullptr);

  void setPictures(const QImage& original, const QImage& exported);
  void setExportedName(const QString& name);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage m_pictures[2];
  QString m_names[2];
};

}  // namespace gonio::app
