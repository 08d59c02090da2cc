// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>

namespace gonio::widgets {
class LibraryModel;
}

namespace gonio::app {

/// Asks for the reference of comparisons: a material of the shown library, or a file.
class ReferenceDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ReferenceDialog(widgets::LibraryModel& library, QWidget* parent);

 Q_SIGNALS:
  void chosen(const QString& path);

 private:
  void chooseFile();
};

}  // namespace gonio::app
