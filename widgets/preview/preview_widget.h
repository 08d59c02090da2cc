// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "widgets/preview/picture_thread.h"
#include "widgets/preview/preview_content.h"
#include "widgets/preview/preview_input.h"

namespace gonio::widgets {

class PreviewOverlay;

/// The preview viewport: a material in a scene, converging while nothing changes, restarting when something does; or
/// two subjects against each other, in one scene. Only the effects that the scene calls for are simulated. The shader
/// draws at once, the path tracer takes over at rest where Tracing says so; both in other threads: the widget shows the
/// newest finished picture (PictureThread), with facts about it (PreviewOverlay). What is shown stands in its
/// content(), what the hand does to it in its input().
class PreviewWidget : public QWidget {
  Q_OBJECT

 public:
  explicit PreviewWidget(QWidget* parent = nullptr);
  ~PreviewWidget() override;

  PreviewContent& content() { return m_content; }
  const PreviewContent& content() const { return m_content; }
  PreviewInput& input() { return *m_input; }
  PreviewOverlay* overlay() const { return m_overlay; }

  /// How radiance becomes pixels, and what is behind them. Emits displayChanged().
  void setDisplay(const DisplaySettings& settings);
  const DisplaySettings& display() const { return m_settings; }
  /// The display with another exposure, in stops.
  void setExposure(double stops);
  /// Whether noise is filtered for the eye while samples are few; never in difference pictures, which show numbers.
  void setNoiseFiltered(bool filtered);
  bool isNoiseFiltered() const { return m_filtersNoise; }
  /// In a comparison: shows the second subject while it is on.
  void setFlickering(bool flickering);

  /// The picture that is shown, without overlay; null before the first.
  const QImage& picture() const { return m_state.picture; }
  /// The picture of what is wanted now, without overlay, at the quality reached so far. Waits for a frame of it.
  QImage grabPicture();
  /// The same with the names of what is compared and the legend of a difference.
  QImage grabLabelledPicture();
  /// The linear radiance of the first subject as it has converged so far. Waits for the frame that is being drawn.
  Image linearPicture() { return m_thread.readFirst(); }
  /// The difference that has the last colour now; 0: not found yet.
  double differenceRange() const { return m_state.range; }
  /// What OpenGL says of itself, once it has started: renderer, maker, version.
  QString graphics() const { return m_graphics; }
  /// Whether the picture has all the samples that it will get.
  bool converged() const;
  /// Whether the picture was traced on the CPU.
  bool showsFilm() const { return m_state.sides[0].isTraced; }
  /// Pictures are requested with rising numbers: that of the last request, and of the picture that is shown.
  int lastRequest() const { return m_number; }
  int shownRequest() const { return m_state.number; }

 Q_SIGNALS:
  /// Exposure, tone map or the checkerboard behind the picture.
  void displayChanged();
  void frameRendered(double milliseconds, int samplesPerPixel);
  void failed(const QString& message);
  /// By the user, on the picture.
  void splitMoved(double fraction);

 protected:
  void showEvent(QShowEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void connectContent();
  void connectThread();
  void startDrawing();
  void requestPicture();
  void adopt(const PictureState& state);
  void showOverlay();
  void showStatus(double milliseconds);
  void showFailure(const QString& message);
  QSize pixelSize() const;

  PreviewContent m_content;
  PictureThread m_thread;
  PictureState m_state;  ///< of the picture that is shown
  int m_number = 0;      ///< of the newest request
  int m_fresh = 0;       ///< the first request of the pictures as they are wanted now
  std::chrono::steady_clock::time_point m_changed;
  DisplaySettings m_settings;
  bool m_flickering = false, m_filtersNoise = true;
  QString m_failure, m_graphics;
  PreviewOverlay* m_overlay;
  PreviewInput* m_input;
};

}  // namespace gonio::widgets
