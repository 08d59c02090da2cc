// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QObject>
#include <QPointF>

#include "app/gonio/document/document.h"

namespace gonio::widgets {
class PreviewWidget;
}

namespace gonio::app {

/// Edits the highlight in the preview by Alt + left drag: sideways away from the middle of the highlight widens it (the
/// control roughness), upwards strengthens it (the control specular strength); a distance of pixelsPerDoubling doubles
/// a value. One drag is one undo step. A tooltip at the pointer shows the values, or why nothing can be changed.
class HighlightDrag : public QObject {
  Q_OBJECT

 public:
  static constexpr double pixelsPerDoubling = 120;
  /// A drag may tremble by so much in the other direction.
  static constexpr double deadPixels = 6;

  HighlightDrag(widgets::PreviewWidget& preview, Document& document);

  /// 1 if a place is right of the middle of the highlight around it, or in a dark or missing picture; else -1.
  /// @param place in [0, 1] over the width and the height of the picture.
  static int outwards(const QImage& picture, const QPointF& place);

 private:
  void begin(const QPointF& position);
  void drag(const QPointF& pixels, const QPoint& place);
  void end();

  widgets::PreviewWidget& m_preview;
  Document& m_document;
  models::ParameterValues m_controls;  ///< at the beginning of the drag
  int m_outwards = 1;
};

}  // namespace gonio::app
