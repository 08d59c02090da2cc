// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "widgets/preview/picture_thread.h"
#include "widgets/preview/preview_content.h"
#include "widgets/preview/preview_input.h"

namespace gonio::widgets {

class PreviewOverlay;

/// The preview viewport: one subject, or two in comparison, in a scene. The picture converges while nothing changes and
/// restarts after a change. Only the effects that the scene needs are simulated. The shader renders at once, the path
/// tracer takes over at rest depending on Tracing, both in other threads. The widget shows the newest finished picture
/// (PictureThread) with facts about it (PreviewOverlay). content() describes what is shown, input() handles mouse and
/// keys.
class PreviewWidget : public QWidget {
  Q_OBJECT

 public:
  explicit PreviewWidget(QWidget* parent = nullptr);
  ~PreviewWidget() override;

  PreviewContent& content() { return m_content; }
  const PreviewContent& content() const { return m_content; }
  PreviewInput& input() { return *m_input; }
  PreviewOverlay* overlay() const { return m_overlay; }

  /// Sets the conversion of radiance to pixels and the background. Emits displayChanged().
  void setDisplay(const DisplaySettings& settings);
  const DisplaySettings& display() const { return m_settings; }
  /// Sets the exposure of the display, in stops.
  void setExposure(double stops);
  /// Sets whether noise is filtered for display while there are few samples; never in difference pictures, which show
  /// numbers.
  void setNoiseFiltered(bool filtered);
  bool isNoiseFiltered() const { return m_filtersNoise; }
  /// In a comparison: whether the second subject is shown instead of the first.
  void setFlickering(bool flickering);

  /// The displayed picture without overlay; null before the first one.
  const QImage& picture() const { return m_state.picture; }
  /// The picture of the current state without overlay, at the quality reached so far. Waits for one frame.
  QImage grabPicture();
  /// The same with the names of the compared subjects and the legend of a difference.
  QImage grabLabelledPicture();
  /// The linear radiance of the first subject, at the quality reached so far. Waits for the current frame.
  Image linearPicture() { return m_thread.readFirst(); }
  /// The difference currently shown in the last colour of the map; 0: not determined yet.
  double differenceRange() const { return m_state.range; }
  /// Renderer, vendor and version reported by OpenGL, once it has started.
  QString graphics() const { return m_graphics; }
  /// Whether the picture has all its samples.
  bool converged() const;
  /// Dims the picture and names what is being opened in its place; an empty name: shows it as it is.
  /// @param thumbnail of what is being opened, shown above its name; null if there is none.
  void setLoading(const QString& name, const QImage& thumbnail = {});
  /// Whether the picture was traced on the CPU.
  bool showsFilm() const { return m_state.sides[0].isTraced; }
  /// Requests have increasing numbers: the number of the last request, and of the displayed picture.
  int lastRequest() const { return m_number; }
  int shownRequest() const { return m_state.number; }

 Q_SIGNALS:
  /// Exposure, tone map or the checkerboard background changed.
  void displayChanged();
  void frameRendered(double milliseconds, int samplesPerPixel);
  void failed(const QString& message);
  /// The user dragged the split bar on the picture.
  void splitMoved(double fraction);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void connectContent();
  void connectThread();
  void adoptPalette();
  void startDrawing();
  void requestPicture();
  void adopt(const PictureState& state);
  void showOverlay();
  void drawLoading(QPainter& painter) const;
  void showStatus(double milliseconds);
  void showFailure(const QString& message);
  QSize pixelSize() const;

  PreviewContent m_content;
  PictureThread m_thread;
  PictureState m_state;    ///< of the displayed picture
  int m_number = 0;        ///< of the newest request
  int m_fresh = 0;         ///< first request with the current content
  int m_firstCurrent = 0;  ///< first request since the content or comparison changed; earlier failures are ignored
  std::chrono::steady_clock::time_point m_changed;
  DisplaySettings m_settings;
  bool m_flickering = false, m_filtersNoise = true;
  QString m_failure;
  QString m_loading;      ///< what is being opened; empty: nothing
  QImage m_thumbnail;     ///< of it; may be null
  QString m_unavailable;  ///< why nothing can be drawn; empty: OpenGL works, or was not started
  QString m_graphics;
  PreviewOverlay* m_overlay;
  PreviewInput* m_input;
};

}  // namespace gonio::widgets
