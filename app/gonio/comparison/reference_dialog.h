// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>

class QDialogButtonBox;

namespace gonio::widgets {
class LibraryModel;
}

namespace gonio::app {

/// Asks for a material of the shown library or a file; by default for the reference of comparisons.
class ReferenceDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ReferenceDialog(widgets::LibraryModel& library, QWidget* parent);

  /// Sets the title and the text of the button that accepts the material, to choose it for another purpose.
  void setPurpose(const QString& title, const QString& button);

 Q_SIGNALS:
  void chosen(const QString& path);

 private:
  void chooseFile();

  QDialogButtonBox* m_buttons;
};

}  // namespace gonio::app
