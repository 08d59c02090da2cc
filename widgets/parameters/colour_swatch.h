// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractButton>

#include "core/math/types.h"

namespace gonio::widgets {

/// A button filled with a linear RGB colour. Colours with values above 1 are scaled down and marked with a corner.
/// Pressing it opens a colour dialog; every change in the dialog is emitted immediately, and cancelling emits the old
/// colour.
class ColourSwatch : public QAbstractButton {
  Q_OBJECT

 public:
  explicit ColourSwatch(QWidget* parent = nullptr);

  void setColour(const Rgb& linear);
  Rgb colour() const { return m_colour; }

  QSize sizeHint() const override;

 Q_SIGNALS:
  void editingStarted();
  void colourEdited(const gonio::Rgb& linear);
  void editingFinished();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void openDialog();

  Rgb m_colour{0};
};

}  // namespace gonio::widgets
