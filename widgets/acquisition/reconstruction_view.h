// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QWidget>

namespace gonio::widgets {

/// Pictures of a material and its reconstruction side by side, with their difference in false colour and its legend. As
/// large as space permits, in one or more rows.
class ReconstructionView : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QImage reference, reconstruction, errorMap;  ///< null pictures are omitted, except the reconstruction
    QString referenceName;
    /// The luminance difference at the last colour of the error map, in the scene's unit of radiance.
    double errorRange = 0;
  };

  explicit ReconstructionView(QWidget* parent = nullptr);

  void setContent(const Content& content);
  /// Shown in the middle while there is no reconstruction.
  void setHint(const QString& hint);
  /// Squares of the available pictures, in widget pixels: reference, reconstruction, error map.
  QList<QRectF> squares() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Picture {
    QImage image;
    QString caption;
  };
  std::vector<Picture> pictures() const;
  void drawLegend(QPainter& painter, const QRectF& square) const;

  Content m_content;
  QString m_hint;
};

}  // namespace gonio::widgets
