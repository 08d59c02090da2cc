// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <functional>

class QWidget;

namespace gonio::app {

/// Reports whether the key \ is held in a window, with any focus except a text field. A shortcut does not report the
/// release.
class FlickerKey : public QObject {
  Q_OBJECT

 public:
  FlickerKey(QWidget* window, std::function<void(bool held)> callback);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void set(bool held);

  QWidget* m_window;
  std::function<void(bool)> m_callback;
  bool m_held = false;
};

}  // namespace gonio::app
