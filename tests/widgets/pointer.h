// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QCoreApplication>
#include <QMouseEvent>
#include <QWidget>

namespace gonio::test {

/// Moves the pointer over a widget, no button pressed. QTest::mouseMove() would move the system's cursor, of which a
/// display reports when it likes, if it has one.
inline void pointAt(QWidget& widget, const QPoint& at) {
  QMouseEvent event(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
  QCoreApplication::sendEvent(&widget, &event);
}

}  // namespace gonio::test
